// SPDX-License-Identifier: Apache-2.0
#include "paper/table3.h"

#include <cmath>
#include <cstdio>

#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"
#include "light.h"
#include "metrics/correlation.h"
#include "metrics/mse.h"
#include "metrics/snr.h"
#include "metrics/ssim.h"
#include "metrics/uiqi.h"
#include "paper/subject.h"
#include "paper/table.h"
#include "tests/core/plain.h"

namespace paper {

namespace {

using metrics::Plane;

/// A way of enlarging; an empty filter: OpenImageIO's by the name in `label`.
struct Way {
    std::string label;
    ddt::Options options;
    const char* oiio_filter = nullptr;
};

std::vector<Way> all_ways() {
    std::vector<Way> ways{
        {"bilinear", {}, "triangle"}, {"b-spline", {}, "bspline"}, {"lanczos", {}, "lanczos3"}};
    for (const ddt::MeshOptions& o : all_schemes()) {
        Way way{label(o), {}, nullptr};
        way.options.mesh = o;
        way.options.surface = ddt::test::plain_surface(ddt::Surface::linear);
        ways.push_back(way);
    }
    for (const char* filter : {"ddt-linear", "ddt", "ddt-sharp"}) {
        Way way{std::string("filter ") + filter, {}, nullptr};
        std::string error;
        ddt::parse_filter(filter, way.options, error);
        ways.push_back(way);
    }
    for (Way& way : ways)
        way.options.light = "encoded";
    return ways;
}

Plane enlarged(const Way& way, const Subject& s) {
    const OIIO::ImageBuf small = bench::to_light(s.reduced, bench::Light::encoded);
    const OIIO::ROI roi(0, s.original.width(), 0, s.original.height(), 0, 1, 0, 3);
    OIIO::ImageBuf large;
    if (way.oiio_filter)
        OIIO::ImageBufAlgo::resize(large, small, way.oiio_filter, 0, roi);
    else
        ddt::resize(large, small, way.options, roi);
    if (large.has_error()) {
        std::fprintf(stderr, "%s: %s\n", way.label.c_str(), large.geterror().c_str());
        return {};
    }
    return luma(
        bench::stored(bench::to_display(large, bench::Light::encoded), bench::Light::encoded));
}

struct Metric {
    const char* name;
    int decimals;
    double (*value)(const Plane& reference, const Plane& test);
};
constexpr Metric all_metrics[] = {
    {"correlation", 5, metrics::correlation},
    {"cross-correlation", 5, metrics::cross_correlation},
    {"mse", 2, metrics::mse},
    {"snr dB", 3, metrics::snr},
    {"uiqi", 4, metrics::uiqi},
    {"ssim", 4, metrics::ssim},
};

} // namespace

bool table3(const std::string& folder, int factor, Reduce how, const std::string& csv_folder) {
    const auto ways = all_ways();
    std::vector<std::vector<double>> sums(ways.size(), std::vector<double>(std::size(all_metrics)));
    int images = 0;
    bool fine = true;
    const bool found = each_subject(folder, factor, how, [&](const Subject& s) {
        const Plane reference = without_border(luma(s.original), factor);
        for (size_t w = 0; w < ways.size(); ++w) {
            const Plane large = enlarged(ways[w], s);
            if (large.empty()) {
                fine = false;
                continue;
            }
            const Plane test = without_border(large, factor);
            for (size_t m = 0; m < std::size(all_metrics); ++m)
                sums[w][m] += all_metrics[m].value(reference, test);
        }
        ++images;
    });
    if (!found) {
        std::fprintf(stderr, "paper_tables: no image in \"%s\"\n", folder.c_str());
        return false;
    }
    std::vector<std::string> columns{"method"};
    for (const Metric& m : all_metrics)
        columns.emplace_back(m.name);
    Table table("table3-x" + std::to_string(factor), columns);
    for (size_t w = 0; w < ways.size(); ++w) {
        std::vector<std::string> cells{ways[w].label};
        for (size_t m = 0; m < std::size(all_metrics); ++m)
            cells.push_back(number(sums[w][m] / images, all_metrics[m].decimals));
        table.add(cells);
    }
    return table.show(csv_folder) && fine;
}

} // namespace paper
