// SPDX-License-Identifier: Apache-2.0
// How the checks of a device say what they found.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ddt::gl {

/// "3 of 100 `what` differ", of as many numbers of a device as the CPU has; nothing if none do.
template <class T>
std::string difference(const char* what, const std::vector<T>& cpu, const std::vector<T>& gpu) {
    size_t differing = 0;
    for (size_t i = 0; i < cpu.size(); ++i)
        differing += cpu[i] != gpu[i];
    return differing == 0 ? std::string()
                          : std::to_string(differing) + " of " + std::to_string(cpu.size()) + ' ' +
                                what + " differ";
}

/// That in the line a user sees; nothing of nothing. `checked`: what was done, as a key tells it.
inline std::string difference_of(const std::string& renderer, const std::string& checked,
                                 const std::string& difference) {
    return difference.empty()
               ? difference
               : renderer + " does not compute as the CPU does (" + checked + "): " + difference;
}

} // namespace ddt::gl
