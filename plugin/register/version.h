// SPDX-License-Identifier: Apache-2.0
// Which version of a library the program uses.
#pragma once

#include <string>

namespace ddt {

/// Libraries are told apart by the ends of their names: with the stem "libName.so.", the end of
/// "libName.so.2.4" is "2.4".
struct Versions {
    std::string ours;   ///< of the library that defines a function of ours
    std::string theirs; ///< of another one that is loaded; empty if there is none
    bool mixed = false; ///< the program uses theirs: nothing but this module asks for ours
};

/// Look at the modules loaded now. `function` is one that the library of ours defines.
Versions versions_loaded(const char* stem, const void* function);

} // namespace ddt
