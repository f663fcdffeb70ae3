// SPDX-License-Identifier: Apache-2.0
#include "ways.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"

namespace speed {

namespace {

OIIO::ROI enlarged(const OIIO::ImageBuf& image, double scale) {
    const auto size = [&](int length) { return int(std::lround(length * scale)); };
    return {0, size(image.spec().width), 0, size(image.spec().height), 0, 1, 0, 3};
}

/// Time `resize`, a function that fills the image it is given.
template <class Resize>
double seconds(const std::string& name, Resize&& resize) {
    OIIO::ImageBuf result;
    const auto start = std::chrono::steady_clock::now();
    const bool done = resize(result);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (!done)
        std::fprintf(stderr, "%s: %s\n", name.c_str(), result.geterror().c_str());
    return done ? time.count() : -1;
}

} // namespace

Way ddt_way(const std::string& filter, ddt::Statistics* statistics) {
    return {filter, [=](const OIIO::ImageBuf& image, double scale, int threads) {
                return seconds(filter, [&](OIIO::ImageBuf& result) {
                    ddt::Options options;
                    std::string error;
                    options.statistics = statistics;
                    if (ddt::parse_filter(filter, options, error))
                        return ddt::resize(result, image, options, enlarged(image, scale), threads);
                    result.errorfmt("{}", error);
                    return false;
                });
            }};
}

std::vector<Way> oiio_ways() {
    std::vector<Way> ways;
    for (const char* filter : {"triangle", "blackman-harris", "lanczos3"})
        ways.push_back({filter, [filter](const OIIO::ImageBuf& image, double scale, int threads) {
                            return seconds(filter, [&](OIIO::ImageBuf& result) {
                                return OIIO::ImageBufAlgo::resize(result, image, filter, 0,
                                                                  enlarged(image, scale), threads);
                            });
                        }});
    return ways;
}

} // namespace speed
