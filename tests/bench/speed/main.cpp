// SPDX-License-Identifier: Apache-2.0
// How fast the filters are: as ratios to what else enlarges images, by stage, and over the image's
// size. Tables and how their times are taken: tables.h.
//
//   speed                    everything: half an hour
//   speed --quick            a look, in a minute
//   speed photo.png --scales 4 --threads 1 --tables ratios,stages
#include <algorithm>
#include <cstdio>

#include <OpenImageIO/argparse.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>
#include <hwy/highway.h>

#include "../arguments.h"
#include "ddt/resize.h"
#include "tables.h"
#include "tests/use_simd.h"

namespace {

/// False, with a line on stderr, if a name is none of those allowed.
bool check_names(const std::vector<std::string>& names, const std::vector<std::string>& allowed) {
    for (const std::string& name : names)
        if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
            std::fprintf(stderr, "unknown: \"%s\"; allowed are %s\n", name.c_str(),
                         OIIO::Strutil::join(allowed, ", ").c_str());
            return false;
        }
    return true;
}

/// Have ddt use this instruction set ("": the best there is). False, with a line on stderr, if it
/// was not compiled or the machine has it not.
bool use_simd(const std::string& wanted) {
    if (wanted.empty())
        return true;
    const std::string name = OIIO::Strutil::upper(wanted);
    std::vector<std::string> names;
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
        names.emplace_back(hwy::TargetName(target));
        if (names.back() == name)
            ddt::test::use_simd(target);
    }
    return check_names({name}, names);
}

bool has(const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

int main(int argc, char** argv) {
    using OIIO::Strutil::splits;
    speed::Plan plan;
    bool quick = false, no_programs = false;
    const int all = int(OIIO::Sysutil::hardware_concurrency());
    std::vector<std::string> paths;
    std::string scales = "1.5,2,4,8", megapixels = "1", largest = "64", rounds = "3",
                threads = all > 1 ? "1,0" : "1", format = "float,8bit",
                filters = OIIO::Strutil::join(ddt::filter_names(), "+"),
                tables = "small,ratios,stages,threads,cores,growth", memory = "warm,fresh", simd;
    OIIO::ArgParse args;
    args.intro("speed: ddt against other ways to enlarge\n").usage("speed [IMAGE] [options]");
    args.arg("image").hidden().action([&](OIIO::cspan<const char*> a) { paths.push_back(a[0]); });
    args.arg("--quick", &quick).help("0.25 megapixels, one round, no other programs, 2x and 4x");
    args.arg("--megapixels %s:N", &megapixels).help("size of the source (default: 1)");
    args.arg("--largest %s:N", &largest).help("largest source for growth (default: 64)");
    args.arg("--rounds %s:N", &rounds).help("runs of each (default: 3)");
    args.arg("--scales %s:LIST", &scales).help("factors (default: 1.5,2,4,8)");
    args.arg("--threads %s:LIST", &threads).help("numbers of threads, 0 for all (default: 1,0)");
    args.arg("--formats %s:LIST", &format).help("float, 8bit (default: both)");
    args.arg("--filters %s:FILTER+FILTER", &filters)
        .help("filters, with options if any (default: all)");
    args.arg("--memory %s:LIST", &memory)
        .help("of the result: warm (written to before), fresh (default: both)");
    args.arg("--tables %s:LIST", &tables)
        .help("small, ratios, stages, threads, cores, growth (default: all)");
    args.arg("--simd %s:NAME", &simd)
        .help("instruction set that ddt uses, AVX2 say (default: the best there is)");
    args.arg("--no-programs", &no_programs).help("without ImageMagick and libvips");
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || paths.size() > 1) {
        args.print_help();
        return 2;
    }
    if (quick) {
        megapixels = "0.25";
        largest = "4";
        rounds = "1";
        scales = "2,4";
        no_programs = true;
    }
    const auto wanted = splits(tables, ","), formats = splits(format, ","),
               memories = splits(memory, ",");
    if (!check_names(wanted, {"small", "ratios", "stages", "threads", "cores", "growth"}) ||
        !check_names(formats, {"float", "8bit"}) || !check_names(memories, {"warm", "fresh"}) ||
        !use_simd(simd) || wanted.empty() || formats.empty() || memories.empty() ||
        !bench::parse_argument("--megapixels", megapixels, 0.001, 1000.0, plan.megapixels) ||
        !bench::parse_argument("--largest", largest, 0.25, 1000.0, plan.largest) ||
        !bench::parse_argument("--rounds", rounds, 1, 1000, plan.rounds) ||
        !bench::parse_arguments("--scales", scales, 1.0, 64.0, plan.scales) ||
        !bench::parse_arguments("--threads", threads, 0, 1024, plan.threads)) {
        args.print_help();
        return 2;
    }
    for (const std::string& name : memories)
        plan.memory.push_back(name == "warm" ? speed::Memory::warm : speed::Memory::fresh);
    plan.programs = !no_programs;
    plan.filters = splits(filters, "+");
    ddt::Options options;
    for (const std::string& filter : plan.filters)
        if (std::string error; !ddt::parse_filter(filter, options, error)) {
            std::fprintf(stderr, "speed: %s\n", error.c_str());
            return 2;
        }
    for (int& n : plan.threads)
        n = n > 0 ? n : all;
    for (const std::string& name : formats)
        plan.formats.push_back(name == "float" ? speed::Format::linear_float
                                               : speed::Format::srgb_8bit);

    const speed::Pictures pictures(paths.empty() ? "" : paths[0]);
    bool good = true;
    if (has(wanted, "small")) // first: it tells of the process's first call
        good = good && print_small(pictures, plan);
    if (has(wanted, "ratios"))
        good = good && print_ratios(pictures, plan);
    if (has(wanted, "stages"))
        good = good && print_stages(pictures, plan);
    if (has(wanted, "threads"))
        good = good && print_threads(pictures, plan);
    if (has(wanted, "cores"))
        good = good && print_cores(pictures, plan);
    if (has(wanted, "growth"))
        good = good && print_growth(pictures, plan);
    return good ? 0 : 1;
}
