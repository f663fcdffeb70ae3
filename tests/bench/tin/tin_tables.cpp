// SPDX-License-Identifier: Apache-2.0
// Prints the tables of docs/tin.md.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "ddt/names.h"
#include "tables.h"

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
    std::vector<std::string> rest;
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        const bool has_value = i + 1 < argc;
        if (arg == "--scheme" && has_value)
            scheme = argv[++i];
        else if (arg == "--sets" && has_value)
            sets = std::atoi(argv[++i]);
        else if (arg == "--crop" && has_value)
            crop = std::atoi(argv[++i]);
        else if (table.empty())
            table = arg;
        else
            rest.push_back(arg);
    }
    ddt::MeshOptions known;
    if (!ddt::find_scheme(scheme, known) || sets < 1 || crop < 32)
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
            counts.push_back(std::atoi(n.c_str()));
        done = ddt::bench::print_time(scheme, counts);
    } else
        return usage();
    return done ? 0 : 1;
}
