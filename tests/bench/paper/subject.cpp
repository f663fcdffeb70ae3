// SPDX-License-Identifier: Apache-2.0
#include "paper/subject.h"

#include <cstdio>
#include <filesystem>

#include <OpenImageIO/imagebufalgo.h>

#include "core/guide/guide.h"
#include "ddt/names.h"
#include "light.h"
#include "reference.h"

namespace paper {

namespace {

/// At an even factor the centre of a new pixel is a corner of four old ones.
metrics::Plane between_four(const metrics::Plane& plane, int factor) {
    metrics::Plane out(plane.width / factor, plane.height / factor);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int right = x * factor + factor / 2, below = y * factor + factor / 2;
            out.at(x, y) = (plane.at(right - 1, below - 1) + plane.at(right, below - 1) +
                            plane.at(right - 1, below) + plane.at(right, below)) /
                           4;
        }
    return out;
}

} // namespace

metrics::Image reduce(const metrics::Image& image, int factor, Reduce how) {
    metrics::Image out;
    if (how == Reduce::bilinear) {
        for (size_t c = 0; c < 3; ++c)
            out.channels[c] = between_four(image.channels[c], factor);
    } else {
        const OIIO::ROI roi(0, image.width() / factor, 0, image.height() / factor, 0, 1, 0, 3);
        const OIIO::ImageBuf large = bench::to_light(image, bench::Light::encoded);
        out = bench::to_display(OIIO::ImageBufAlgo::resize(large, "triangle", 0, roi),
                                bench::Light::encoded);
    }
    return bench::stored(out, bench::Light::encoded);
}

bool each_subject(const std::string& folder, int factor, Reduce how,
                  const std::function<void(const Subject&)>& f) {
    int count = 0;
    for (const std::string& path : bench::image_files(folder)) {
        Subject s;
        s.name = std::filesystem::path(path).filename().string();
        s.factor = factor;
        std::string error;
        if (!bench::read_original(path, factor, bench::Light::encoded, s.original, error)) {
            std::fprintf(stderr, "%s: left out: %s\n", s.name.c_str(), error.c_str());
            continue;
        }
        s.reduced = factor == 1 ? s.original : reduce(s.original, factor, how);
        f(s);
        ++count;
    }
    return count > 0;
}

std::vector<float> guide_of(const metrics::Image& image) {
    std::vector<float> guide;
    for (const double v : luma(image).values)
        guide.push_back(ddt::guide_step(float(v / 255)));
    return guide;
}

std::vector<ddt::MeshOptions> all_schemes() {
    std::vector<ddt::MeshOptions> schemes;
    const auto add = [&](const char* name, ddt::Start start) {
        ddt::MeshOptions o;
        ddt::find_scheme(name, o);
        o.cost = ddt::Cost::scf;
        o.start = start;
        o.min_gain = 1e-6f;
        o.blur = 0;
        o.contour = 0;
        // Enough for every scheme to end by itself; annealing takes as many as it is given.
        o.max_iterations = o.scheme == ddt::Scheme::annealing ? 64 : ddt::most_iterations;
        schemes.push_back(o);
    };
    for (const char* name :
         {"lawson", "basic", "exproi", "maxgain", "exproi-maxgain", "exproi2-maxgain",
          "exproi5-maxgain", "one-round", "look-ahead", "annealing"})
        add(name, ddt::Start::diagonal);
    for (const char* name : {"pixel", "lawson", "one-round"})
        add(name, ddt::Start::flat);
    return schemes;
}

std::string label(const ddt::MeshOptions& options) {
    const bool flat = options.start == ddt::Start::flat;
    return ddt::scheme_name(options) + (flat ? " (flat start)" : "");
}

} // namespace paper
