// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdio>

#include "../child.h"
#include "ways.h"

namespace speed {

namespace {

using Command = std::vector<std::string>;

double seconds(const Command& command) {
    const auto start = std::chrono::steady_clock::now();
    const int status = bench::run_child(command);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (status == 0)
        return time.count();
    std::fprintf(stderr, "%s failed\n", command[0].c_str());
    return -1;
}

/// Time of a command less that of another.
double difference(const Command& with, const Command& without) {
    const double all = seconds(with), rest = seconds(without);
    return all < 0 || rest < 0 ? -1 : std::fmax(all - rest, 1e-9);
}

/// The image as a file that every program reads fast: 8 or 16 bits a channel, not compressed.
bool write(const OIIO::ImageBuf& image, const std::string& path) {
    const bool floats = image.spec().format.is_floating_point();
    if (image.write(path, floats ? OIIO::TypeUInt16 : OIIO::TypeUInt8))
        return true;
    std::fprintf(stderr, "%s\n", image.geterror().c_str());
    return false;
}

std::string size_after(const Task& task) {
    return std::to_string(task.width()) + "x" + std::to_string(task.height()) + "!";
}

Way imagemagick(const std::string& program, const std::string& name, const Command& operation) {
    return {name,
            [=](const Task& task) {
                const bench::ScratchFolder folder;
                const std::string in = folder.file("in.ppm");
                if (!write(task.image, in))
                    return -1.0;
                const Command without = {program, "-limit", "thread", std::to_string(task.threads),
                                         in,      "null:"};
                Command with(without.begin(), without.end() - 1);
                with.insert(with.end(), operation.begin(), operation.end());
                with.insert(with.end(), {size_after(task), "null:"});
                return difference(with, without);
            },
            true};
}

/// vips works while it writes, so writing a raw image counts too; it is little. It takes kernels
/// for shrinking alone: whichever is named, from "cubic" on, it enlarges by bicubic interpolation.
Way vips() {
    return {"vips bicubic",
            [](const Task& task) {
                const bench::ScratchFolder folder;
                const std::string in = folder.file("in.ppm"), out = folder.file("out.v");
                if (!write(task.image, in))
                    return -1.0;
                const Command start = {"env", "VIPS_CONCURRENCY=" + std::to_string(task.threads),
                                       "vips"};
                Command with = start, without = start;
                with.insert(with.end(), {"resize", in, out, std::to_string(task.scale)});
                without.insert(without.end(), {"copy", in, out});
                return difference(with, without);
            },
            true};
}

} // namespace

std::vector<Way> program_ways() {
    std::vector<Way> ways;
    for (const char* program : {"magick", "convert"})
        if (ways.empty() && bench::run_child({program, "-size", "1x1", "xc:black", "null:"}) == 0) {
            ways.push_back(imagemagick(program, "IM adaptive", {"-adaptive-resize"}));
            ways.push_back(imagemagick(program, "IM Lanczos", {"-filter", "Lanczos", "-resize"}));
        }
    const bench::ScratchFolder folder;
    if (bench::run_child({"vips", "black", folder.file("one.v"), "1", "1"}) == 0)
        ways.push_back(vips());
    return ways;
}

} // namespace speed
