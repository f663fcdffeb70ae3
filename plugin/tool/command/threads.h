// SPDX-License-Identifier: Apache-2.0
// How many threads a command works with.
#pragma once

namespace ddt::tool {

/// The threads to enlarge with where `wanted` are asked for, be it more than there are cores; 0: as
/// many as OpenImageIO's attribute "threads" says, which is all, or what a container's quota is
/// worth. OpenImageIO gets as many to read and write with, those that OpenEXR decompresses with
/// among them.
int share_threads(int wanted);

} // namespace ddt::tool
