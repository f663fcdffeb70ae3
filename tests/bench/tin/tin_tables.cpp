// SPDX-License-Identifier: Apache-2.0
// Prints the tables of docs/tin.md.
#include <cstdio>
#include <string>

#include "ddt/names.h"
#include "tables.h"
#include "tests/bench/arguments.h"

namespace {

int usage() {
    std::fprintf(stderr, "usage: tin_tables [--scheme NAME] [--sets N] [--crop PIXELS] "
                         "functions | pictures FILE... | fill FILE... | time POINTS...\n");
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    std::string scheme = "look-ahead", table;
    int sets = 20, crop = 256;
    bool fine = true;
    std::vector<std::string> rest;
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        const bool has_value = i + 1 < argc;
        if (arg == "--scheme" && has_value)
            scheme = argv[++i];
        else if (arg == "--sets" && has_value)
            fine = ::bench::parse_argument(argv[i], argv[i + 1], 1, 100000, sets) && fine, ++i;
        else if (arg == "--crop" && has_value)
            fine = ::bench::parse_argument(argv[i], argv[i + 1], 32, 8192, crop) && fine, ++i;
        else if (table.empty())
            table = arg;
        else
            rest.push_back(arg);
    }
    ddt::MeshOptions known;
    if (!fine || !ddt::find_scheme(scheme, known))
        return usage();
    const std::vector<ddt::bench::Way> ways = ddt::bench::ways_of(scheme);
    bool done = false;
    if (table == "functions" && rest.empty())
        done = ddt::bench::print_functions(ways, sets);
    else if (table == "pictures" && !rest.empty())
        done = ddt::bench::print_pictures(ways, rest, crop, 0.05);
    else if (table == "fill" && !rest.empty())
        done = ddt::bench::print_fill(ways, rest, crop);
    else if (table == "time" && !rest.empty()) {
        std::vector<int> counts;
        for (const std::string& n : rest)
            if (!::bench::parse_argument("POINTS", n, 3, 100000000, counts.emplace_back()))
                return usage();
        done = ddt::bench::print_time(scheme, counts);
    } else
        return usage();
    return done ? 0 : 1;
}
