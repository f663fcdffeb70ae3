// SPDX-License-Identifier: Apache-2.0
// Holes of a result that has the source's size.
#pragma once

#include <string>

#include "plugin/host/enlargement.h"

namespace ddt::host {

/// Fill what is missing in work.to, which is a copy of the source, as ddt::resize() fills an image
/// that keeps its size: from the numbers as they are, but associated. What is there keeps its bits.
/// `job`: the work's. Not Outcome::done: with one line in `error`. May throw.
Outcome fill_copy(const Enlargement& work, const Job& job, std::string& error);

} // namespace ddt::host
