// SPDX-License-Identifier: Apache-2.0
// The line that tells of work where it was done.
#pragma once

#include <string>

#include "ddt/job.h"

namespace ddt {

/// Say (core/base/log.h): "ddt: device cpu; 5 points, 1 flips, 1 iterations, 0.1 ms", of which
/// "cpu" is `device` and "5 points" is `amount`.
void say_worked(const std::string& device, const std::string& amount, const Statistics& statistics,
                double milliseconds);

} // namespace ddt
