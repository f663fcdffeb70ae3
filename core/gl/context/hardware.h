// SPDX-License-Identifier: Apache-2.0
// A look for graphics hardware that loads nothing.
#pragma once

#include <string>

namespace ddt::gl {

/// Whether there could be a GPU: on Linux, whether a driver of one has its device files in
/// `folder`; elsewhere always. Loading libEGL to find none takes a tenth of a second.
bool hardware_possible(const std::string& folder = "/dev");

/// Whether there could be one that EGL does not list among its devices: that of Windows below a
/// guest of it, which Mesa has behind its software device.
bool hardware_unlisted(const std::string& folder = "/dev");

} // namespace ddt::gl
