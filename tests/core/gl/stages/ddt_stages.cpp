// SPDX-License-Identifier: Apache-2.0
// Where a device's bits part from the CPU's, stage by stage (HACKING.md, "When bits differ on a new
// driver").
#include <climits>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "core/base/parse_number.h"
#include "core/gl/context/faults.h"
#include "core/gl/programs.h"
#include "core/tiles/grid.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/gl/stages/compare_stages.h"

namespace ddt::test {
namespace {

constexpr const char* usage =
    R"(ddt_stages [--device egl|osmesa] [--filter ddt,KEY=VALUE,...] [--size WxH] [--seed N]
           [--picture photo|noise|drawing|flat|hdr|nonfinite|tiny]
           [--change PROGRAM CONSTANT VALUE]

Where a device's bits part from the CPU's, stage by stage. Sizes are 2x2 to 256x256. --change:
what a fault looks like, a constant of one program ("flip.comp") changed.
Exits with 0 if no stage differs, 2 if one does, 1 for everything else.
)";

struct Arguments {
    Device device = Device::egl;
    FilterOptions filter;
    Content content = Content::photo;
    int width = 64, height = 48, channels = 4;
    unsigned seed = 1;
    std::string changed; ///< the program, if one is to be
};

bool find_content(const char* name, Content& content) {
    for (int i = 0; i < int(Content::count); ++i)
        if (!std::strcmp(name, name_of(Content(i)))) {
            content = Content(i);
            return true;
        }
    return false;
}

bool parse(int argc, char** argv, Arguments& a) {
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 >= argc) {
            std::fprintf(stderr, "%s", usage);
            return false;
        }
        const char* value = argv[i + 1];
        bool known = true;
        std::string why;
        if (name == "--device")
            known = find_device(value, a.device) && a.device != Device::cpu;
        else if (name == "--filter")
            known = parse_filter(value, a.filter, why);
        else if (name == "--picture")
            known = find_content(value, a.content);
        else if (name == "--size")
            known = parse_sides(value, 2, tile_size, a.width, a.height);
        else if (name == "--seed")
            known = parse_number(value, 0u, UINT_MAX, a.seed);
        else if (name == "--change" && i + 3 < argc) {
            a.changed = value;
            gl::change_constant(value, argv[i + 2], argv[i + 3]);
            i += 2;
        } else
            known = false;
        if (!known) {
            std::fprintf(stderr, "ddt_stages: %s %s: not understood %s\n", name.c_str(), value,
                         why.c_str());
            return false;
        }
    }
    return true;
}

/// A misspelt program would look like one without a fault.
void refuse_unknown_program(const std::string& changed, const gl::Programs& programs) {
    if (changed.empty() || gl::was_changed())
        return;
    std::string names;
    for (const std::string& name : programs.names())
        names += (names.empty() ? "" : ", ") + name;
    throw std::runtime_error("no program \"" + changed + "\" was compiled; compiled were " + names);
}

int run(const Arguments& a) {
    std::string why;
    bool forked = false;
    gl::Gpu* gpu = gl::open(a.device, why, forked);
    if (!gpu) {
        std::fprintf(stderr, "ddt_stages: no device: %s\n", why.c_str());
        return 1;
    }
    const gl::Context& context = *gpu->context;
    std::printf("%s, OpenGL %s, by %s\n", context.renderer.c_str(), context.version.c_str(),
                context.platform.c_str());
    const Picture picture = make_picture(a.content, a.width, a.height, a.channels, a.seed);
    const StageResult* first = nullptr;
    Job job;
    job.mesh = a.filter.mesh;
    job.surface = a.filter.surface;
    const auto results = compare_stages(*gpu, picture, job);
    refuse_unknown_program(a.changed, *gpu->programs);
    for (const StageResult& r : results) {
        std::printf("%s\n", line_of(r).c_str());
        if (!first && r.differing > 0)
            first = &r;
    }
    if (first)
        std::printf("first: %s, %s, at %d, %d\n", first->name.c_str(), first->what.c_str(),
                    first->x, first->y);
    else
        std::printf("no bit differs\n");
    return first ? 2 : 0;
}

} // namespace
} // namespace ddt::test

int main(int argc, char** argv) {
    if (argc == 2 && !std::strcmp(argv[1], "--help")) {
        std::printf("%s", ddt::test::usage);
        return 0;
    }
    ddt::test::Arguments arguments;
    if (!ddt::test::parse(argc, argv, arguments))
        return 1;
    // Failures on the device arrive as exceptions.
    try {
        return ddt::test::run(arguments);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "ddt_stages: %s\n", e.what());
        return 1;
    }
}
