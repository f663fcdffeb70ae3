// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef DDT_TEST_TBB
#include <tbb/global_control.h>
#endif

namespace ddt::test {

/// While it lives up to `n` threads may work, also where this machine has fewer processors, to
/// which oneTBB would keep.
class ManyThreads {
public:
#ifdef DDT_TEST_TBB
    explicit ManyThreads(int n = 8)
        : m_control(tbb::global_control::max_allowed_parallelism, size_t(n)) {}

private:
    tbb::global_control m_control;
#else
    explicit ManyThreads(int = 8) {}
    ~ManyThreads() {} // not an unused variable
#endif
};

} // namespace ddt::test
