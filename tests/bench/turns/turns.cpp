// SPDX-License-Identifier: Apache-2.0
// Builds side by side: each enlarges the same part of a picture in turn, some tens of milliseconds
// long, within one process. A machine that is faster one second and slower the next is so for all
// of them: of 40 turns of one build beside itself the ratio was 0.99 to 1.01, where times went from
// 67 to 92 ns; of 20 it was up to 1.03.
//
//   turns photo.png build/bin/ddt_turn.so ../before/build/bin/ddt_turn.so
//   turns photo.png ... --filter ddt-sharp --scale 4 --rounds 100
//
// A row a stage: the median and the least of all turns, in ns an output pixel and added over the
// threads, and the median of the ratios to the first build's turn in the same round. If bits
// differ the program says so and fails.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include <dlfcn.h>

#include <OpenImageIO/argparse.h>

#include "light.h"
#include "reference.h"
#include "speed/times.h"
#include "turn.h"

namespace {

constexpr const char* stages[] = {"all", "triangulate", "surface", "sample"};
constexpr size_t stage_count = std::size(stages);

struct Build {
    std::string path;
    turns::Take* take = nullptr;
    speed::Times times[stage_count]; ///< ns an output pixel, a round each
};

/// False, with a line on stderr, if a module cannot be loaded.
bool load(Build& build) {
    void* const module = dlopen(build.path.c_str(), RTLD_NOW | RTLD_LOCAL);
    build.take =
        module ? reinterpret_cast<turns::Take*>(dlsym(module, turns::name_of_take)) : nullptr;
    if (!build.take)
        std::fprintf(stderr, "%s\n", dlerror());
    return build.take;
}

/// A picture's middle, `side` pixels wide and high at most, in linear light.
struct Subject {
    int width = 0, height = 0;
    std::vector<float> pixels, guide;

    Subject(const metrics::Image& image, int side)
        : width(std::min(image.width(), side)), height(std::min(image.height(), side)) {
        const auto all = bench::pixels_of(image, bench::Light::linear);
        const int x = (image.width() - width) / 2, y = (image.height() - height) / 2;
        for (int row = y; row < y + height; ++row) {
            const auto from = all.begin() + 3 * (ptrdiff_t(row) * image.width() + x);
            pixels.insert(pixels.end(), from, from + 3 * ptrdiff_t(width));
        }
        guide = bench::guide_of(pixels, bench::Light::linear);
    }
};

void print(const Build& build, const Build& first) {
    std::printf("%s\n", build.path.c_str());
    for (size_t stage = 0; stage < stage_count; ++stage) {
        const speed::Times& times = build.times[stage];
        std::printf("  %-12s %8.2f %8.2f   x %.3f\n", stages[stage], speed::median(times),
                    *std::min_element(times.begin(), times.end()),
                    speed::ratio(times, first.times[stage]));
    }
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::string> paths;
    std::string filter = "ddt";
    int scale = 2, rounds = 40, threads = 1, side = 512;
    OIIO::ArgParse args;
    args.intro("turns: builds of ddt side by side\n").usage("turns IMAGE MODULE... [options]");
    args.arg("paths").hidden().action(
        [&](OIIO::cspan<const char*> a) { paths.emplace_back(a[0]); });
    args.arg("--filter %s:FILTER", &filter).help("with options if any (default: ddt)");
    args.arg("--scale %d:N", &scale).help("a whole number (default: 2)");
    args.arg("--rounds %d:N", &rounds).help("turns of each (default: 40)");
    args.arg("--threads %d:N", &threads).help("0 for all (default: 1)");
    args.arg("--side %d:N", &side).help("of the picture, that many pixels (default: 512)");
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || paths.size() < 2 ||
        scale < 1 || scale > 64 || rounds < 1 || threads < 0 || side < 2 || side > 8192) {
        if (args.has_error())
            std::fprintf(stderr, "%s\n", args.geterror().c_str());
        args.print_help();
        return 2;
    }
    metrics::Image image;
    std::string error;
    if (!bench::read_original(paths[0], 1, bench::Light::linear, image, error)) {
        std::fprintf(stderr, "%s\n", error.c_str());
        return 1;
    }
    const Subject subject(image, side);
    std::vector<Build> builds(paths.size() - 1);
    for (size_t i = 0; i < builds.size(); ++i) {
        builds[i].path = paths[i + 1];
        if (!load(builds[i]))
            return 1;
    }

    const size_t pixels = subject.guide.size() * size_t(scale) * size_t(scale);
    std::vector<float> result(3 * pixels), expected;
    bool same = true;
    for (int round = 0; round < rounds; ++round)
        for (size_t k = 0; k < builds.size(); ++k) {
            // Back and forth, so that no build always comes after the same one.
            Build& build = builds[round % 2 ? builds.size() - 1 - k : k];
            const turns::Turn turn{subject.pixels.data(), subject.guide.data(),
                                   subject.width,         subject.height,
                                   result.data(),         scale,
                                   filter.c_str(),        threads};
            turns::Spent spent{};
            if (const char* failure = build.take(turn, spent)) {
                std::fprintf(stderr, "%s: %s\n", build.path.c_str(), failure);
                return 1;
            }
            const int64_t ns[stage_count] = {spent.triangulate + spent.surface + spent.sample +
                                                 spent.other,
                                             spent.triangulate, spent.surface, spent.sample};
            for (size_t stage = 0; stage < stage_count; ++stage)
                build.times[stage].push_back(double(ns[stage]) / double(pixels));
            if (round > 0)
                continue;
            if (expected.empty())
                expected = result;
            if (std::memcmp(expected.data(), result.data(), 3 * pixels * sizeof(float)) != 0) {
                std::printf("%s: other bits\n", build.path.c_str());
                same = false;
            }
        }
    std::printf("%s, %dx, %dx%d pixels, %d rounds: median and least ns an output pixel, and the "
                "median ratio to the first\n",
                filter.c_str(), scale, subject.width, subject.height, rounds);
    for (const Build& build : builds)
        print(build, builds[0]);
    return same ? 0 : 1;
}
