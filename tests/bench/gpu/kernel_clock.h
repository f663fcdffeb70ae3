// SPDX-License-Identifier: Apache-2.0
// Time that the device spends on each kernel.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/gl/context/functions.h"

namespace ddt::bench {

/// Time stamps between kernels. What one takes is the time from when it is asked for, with all
/// before it done, until it is done itself: its wait for the one before is in it. To be used on the
/// context's thread.
class KernelClock {
public:
    explicit KernelClock(const gl::Functions& gl) : m_gl(gl) {}
    ~KernelClock();
    KernelClock(const KernelClock&) = delete;
    KernelClock& operator=(const KernelClock&) = delete;

    /// From here on it is the kernel's time; "": nobody's.
    void next(const std::string& kernel);
    /// Milliseconds by kernel; waits for the device.
    std::map<std::string, double> milliseconds() const;

private:
    const gl::Functions& m_gl;
    std::vector<std::pair<std::string, GLuint>> m_stamps;
};

} // namespace ddt::bench
