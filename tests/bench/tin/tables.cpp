// SPDX-License-Identifier: Apache-2.0
#include "tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "ddt/names.h"
#include "functions.h"

namespace ddt::bench {

std::vector<Way> ways_of(const std::string& scheme) {
    std::vector<Way> ways;
    const auto add = [&](const std::string& name, const std::string& with,
                         const std::string& cost) {
        Way way{name, {}};
        find_scheme(with, way.options);
        find_cost(cost, way.options.cost);
        way.options.min_gain = 1e-6f;
        way.options.max_iterations = most_iterations;
        ways.push_back(way);
    };
    add("Delaunay", "pixel", "abn");
    for (const std::string& cost : cost_names())
        add(cost, scheme, cost);
    return ways;
}

namespace {

bool failed(const std::string& error) {
    std::fprintf(stderr, "%s\n", error.c_str());
    return false;
}

/// Sums of one way's errors.
struct Errors {
    double squares = 0, largest = 0;
    int64_t count = 0;
};

/// Interpolate `function` from `points` over a raster of 101 x 101.
bool measure(const TestFunction& function, PointMesh mesh, const Way& way, Errors& errors) {
    constexpr int size = 101;
    std::vector<float> values;
    for (size_t i = 0; i < mesh.x.size(); ++i)
        values.push_back(float(function.value(mesh.x[i], mesh.y[i])));
    const auto range = std::minmax_element(values.begin(), values.end());
    std::vector<float> guide;
    for (const float v : values)
        guide.push_back((v - *range.first) / (*range.second - *range.first));
    std::vector<float> raster(size * size, 0.0f);
    std::vector<uint8_t> inside(size * size);
    std::string error;
    if (!optimise(mesh, guide.data(), way.options, nullptr, &error) ||
        !draw(mesh, values.data(), 1, {0, 0, 1.0 / (size - 1), 1.0 / (size - 1), size, size},
              raster.data(), inside.data(), &error))
        return failed(error);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double wanted = function.value(double(x) / (size - 1), double(y) / (size - 1));
            const double e = std::abs(double(raster[size_t(y * size + x)]) - wanted);
            errors.squares += e * e;
            errors.largest = std::max(errors.largest, e);
            ++errors.count;
        }
    return true;
}

} // namespace

bool print_functions(const std::vector<Way>& ways, int sets) {
    for (const int count : {33, 100, 1000}) {
        std::printf("\n%d points, %d sets: RMS error / largest, in thousandths\n%-14s", count, sets,
                    "");
        for (const Way& way : ways)
            std::printf(" %15s", way.name.c_str());
        std::printf("\n");
        for (const TestFunction& function : test_functions()) {
            std::printf("%-13s%s", function.name, function.directional ? "*" : " ");
            for (const Way& way : ways) {
                Errors errors;
                for (int set = 0; set < sets; ++set) {
                    // Beyond the square, so that it is within the points' hull.
                    constexpr double margin = 0.1;
                    PointMesh mesh{{-margin, 1 + margin, -margin, 1 + margin},
                                   {-margin, -margin, 1 + margin, 1 + margin},
                                   {}};
                    test::Random random(uint64_t(set) * 7919 + uint64_t(count));
                    while (int(mesh.x.size()) < count) {
                        mesh.x.push_back(share_of(random) * (1 + 2 * margin) - margin);
                        mesh.y.push_back(share_of(random) * (1 + 2 * margin) - margin);
                    }
                    std::string error;
                    if (!delaunay(mesh, &error))
                        return failed(error);
                    if (!measure(function, mesh, way, errors))
                        return false;
                }
                std::printf(" %7.2f /%6.0f", 1e3 * std::sqrt(errors.squares / double(errors.count)),
                            1e3 * errors.largest);
            }
            std::printf("\n");
        }
    }
    std::printf("\n* has a preferred direction\n");
    return true;
}

bool print_time(const std::string& scheme, const std::vector<int>& counts) {
    // The processor's time: all is done on one thread.
    const auto since = [](std::clock_t begin) {
        return double(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    std::printf("%10s %12s %12s %10s %10s %12s\n", "points", "Delaunay, s", scheme.c_str(), "flips",
                "gains", "iterations");
    for (const int count : counts) {
        PointMesh mesh;
        test::Random random{uint64_t(count)};
        std::vector<float> guide;
        for (int i = 0; i < count; ++i) {
            mesh.x.push_back(share_of(random));
            mesh.y.push_back(share_of(random));
            guide.push_back(float(test_functions()[0].value(mesh.x.back(), mesh.y.back())));
        }
        std::string error;
        std::clock_t begin = std::clock();
        if (!delaunay(mesh, &error))
            return failed(error);
        const double first = since(begin);
        MeshOptions options = ways_of(scheme)[1].options;
        MeshReport report;
        begin = std::clock();
        if (!optimise(mesh, guide.data(), options, &report, &error, {}, Device::cpu))
            return failed(error);
        std::printf("%10d %12.3f %12.3f %10.3f %10.2f %12d\n", count, first, since(begin),
                    double(report.statistics.flips) / count,
                    double(report.statistics.evaluations) / count, report.statistics.iterations);
    }
    std::printf("flips and gains a point\n");
    return true;
}

} // namespace ddt::bench
