// SPDX-License-Identifier: Apache-2.0
// Whether numbers are the same when they come from, or to, a device. Twin: job_check.h.
#pragma once

#include <string>

#include "core/gl/transfer.h"

namespace ddt::gl {

struct Gpu;

/// Have such numbers unpacked and packed on the device, and compare with what they are. Empty if
/// they are the same, else what differs. On the context's thread; throws Failure.
std::string transfer_differs(Gpu& gpu, const Transfer& transfer);

/// Two of one key use the same programs.
std::string transfer_key_of(const Transfer& transfer);

} // namespace ddt::gl
