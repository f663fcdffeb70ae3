// SPDX-License-Identifier: Apache-2.0
// The tables of the paper (Cervenansky et al. 2010) on a folder of images.
//
//   paper_tables FOLDER [--table 1|3|13] [--factor 2|4] [--reduce bilinear|triangle]
//                [--megapixels 16] [--csv FOLDER]
//
// Without --table, all of them; without --factor, both.
#include <cstdio>
#include <filesystem>

#include <OpenImageIO/argparse.h>

#include "paper/fig13.h"
#include "paper/table1.h"
#include "paper/table3.h"

int main(int argc, char** argv) {
    int only = 0, factor = 0;
    float megapixels = 16;
    std::string csv, reduce = "bilinear";
    std::vector<std::string> folders;
    OIIO::ArgParse args;
    args.intro("paper_tables: the paper's tables 1 and 3 and figure 13\n")
        .usage("paper_tables FOLDER [options]");
    args.arg("folder").hidden().action(
        [&](OIIO::cspan<const char*> a) { folders.push_back(a[0]); });
    args.arg("--table %d:N", &only).help("1, 3 or 13 only");
    args.arg("--factor %d:N", &factor).help("2 or 4 only");
    args.arg("--reduce %s:HOW", &reduce).help("bilinear (default) or triangle, a smoother filter");
    args.arg("--megapixels %f:N", &megapixels).help("how far figure 13 goes (default: 16)");
    args.arg("--csv %s:FOLDER", &csv).help("write the tables there too, as CSV");
    const bool parsed = args.parse_args(argc, const_cast<const char**>(argv)) >= 0;
    const bool allowed = (only == 0 || only == 1 || only == 3 || only == 13) &&
                         (factor == 0 || factor == 2 || factor == 4) && megapixels >= 0.125f &&
                         (reduce == "bilinear" || reduce == "triangle");
    if (!parsed || !allowed || folders.size() != 1) {
        std::fprintf(stderr, "%s\n", args.geterror().c_str());
        args.print_help();
        return 2;
    }
    if (!csv.empty()) {
        std::error_code error;
        std::filesystem::create_directories(csv, error);
    }
    const auto how = reduce == "bilinear" ? paper::Reduce::bilinear : paper::Reduce::triangle;
    bool fine = true;
    for (const int f : {2, 4}) {
        if (factor && factor != f)
            continue;
        if (only == 0 || only == 1)
            fine = paper::table1(folders[0], f, how, csv) && fine;
        if (only == 0 || only == 3)
            fine = paper::table3(folders[0], f, how, csv) && fine;
    }
    if (only == 0 || only == 13)
        fine = paper::fig13(folders[0], double(megapixels), csv) && fine;
    return fine ? 0 : 1;
}
