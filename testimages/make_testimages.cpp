// SPDX-License-Identifier: Apache-2.0
// Makes the images of this folder.
//
//   make_testimages FOLDER            writes them there
//   make_testimages --check FOLDER    fails if the files there differ from what it would write
#include <cstdio>
#include <cstring>
#include <string>

#include <OpenImageIO/imagebufalgo.h>

#include "images.h"

namespace {

struct Entry {
    const char* file;
    OIIO::ImageBuf (*make)();
};

constexpr Entry entries[] = {
    {"siemens_star.png", testimages::siemens_star},
    {"zone_plate.png", testimages::zone_plate},
    {"checkerboards.png", testimages::checkerboards},
    {"ramps.exr", testimages::ramps},
    {"strokes.png", testimages::strokes},
    {"lines.png", testimages::lines},
    {"alpha.png", testimages::alpha},
    {"light.exr", testimages::light},
    {"window.exr", testimages::window},
    {"layers.exr", testimages::layers},
    {"ids.exr", testimages::ids},
    {"scene.png", testimages::scene},
};

bool write(OIIO::ImageBuf image, const std::string& path) {
    // An EXR without a date gets the present one: the file would differ every time.
    image.specmod().attribute("DateTime", "2000:01:01 00:00:00");
    if (image.write(path))
        return true;
    std::fprintf(stderr, "%s: %s\n", path.c_str(), image.geterror().c_str());
    return false;
}

/// Of a file in EXR OpenImageIO 3.1 names none.
bool same_space(const std::string& made, const std::string& read) {
    return made == read || (read.empty() && OIIO::openimageio_version() >= 30100);
}

bool same_layout(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
    return a.channelnames == b.channelnames && a.format == b.format &&
           a.channelformats == b.channelformats && a.roi() == b.roi() &&
           a.roi_full() == b.roi_full() &&
           same_space(a.get_string_attribute("oiio:ColorSpace"),
                      b.get_string_attribute("oiio:ColorSpace"));
}

bool check(const OIIO::ImageBuf& image, const std::string& path) {
    // Alpha stays as the file has it: multiplying 8-bit colour by it would lose the difference.
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf file(path, 0, 0, nullptr, &as_stored);
    if (!file.read(0, 0, true)) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), file.geterror().c_str());
        return false;
    }
    if (!same_layout(image.spec(), file.spec())) {
        std::fprintf(stderr, "%s: size, channels, format or colour space differ\n", path.c_str());
        return false;
    }
    OIIO::ImageBufAlgo::CompareResults result = OIIO::ImageBufAlgo::compare(image, file, 0, 0);
    if (result.nfail == 0)
        return true;
    std::fprintf(stderr, "%s: %llu pixels differ, by at most %g\n", path.c_str(),
                 static_cast<unsigned long long>(result.nfail), result.maxerror);
    return false;
}

} // namespace

int main(int argc, char** argv) {
    bool checking = argc == 3 && std::strcmp(argv[1], "--check") == 0;
    if (argc != 2 && !checking) {
        std::fprintf(stderr, "usage: make_testimages [--check] FOLDER\n");
        return 2;
    }
    std::string folder = argv[argc - 1];
    bool all_well = true;
    for (const Entry& entry : entries) {
        OIIO::ImageBuf image = entry.make();
        std::string path = folder + "/" + entry.file;
        all_well &= checking ? check(image, path) : write(image, path);
    }
    return all_well ? 0 : 1;
}
