// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/faults.h"

#include <atomic>
#include <utility>

#include "core/gl/context/failure.h"

namespace ddt::gl {

namespace {

struct Armed {
    std::atomic<int> chances{0}, first{0}, times{0};
};
Armed g_armed[int(Fault::count)];

struct Change {
    std::string program, name, value;
};
Change& g_change = *new Change;

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

void change_constant(const std::string& program, const std::string& name,
                     const std::string& value) {
    g_change = {program, name, value};
}

std::string with_changed_constant(const std::string& program, std::string source) {
    if (g_change.program.empty() || program != g_change.program)
        return source;
    for (const auto& [before, after] : {std::pair(" " + g_change.name + " = ", ";"),
                                        std::pair(" " + g_change.name + " ", "\n")}) {
        const size_t at = source.find(before);
        if (at == source.npos)
            continue;
        const size_t begin = at + before.size();
        return source.replace(begin, source.find(after, begin) - begin, g_change.value);
    }
    throw Failure("no constant is named " + g_change.name);
}

} // namespace ddt::gl
