// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/faults.h"

#include <atomic>

namespace ddt::gl {

namespace {

struct Armed {
    std::atomic<int> chances{0}, first{0}, times{0};
};
Armed g_armed[int(Fault::count)];

} // namespace

void arm(Fault fault, int n, int times) {
    Armed& a = g_armed[int(fault)];
    a.first = n;
    a.times = times;
    a.chances = 0;
}

bool strikes(Fault fault) {
    Armed& a = g_armed[int(fault)];
    const int chance = ++a.chances;
    return a.first > 0 && chance >= a.first && chance < a.first + a.times;
}

int chances(Fault fault) {
    return g_armed[int(fault)].chances;
}

} // namespace ddt::gl
