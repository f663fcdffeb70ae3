// SPDX-License-Identifier: Apache-2.0
#include "ways.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"
#include "plugin/message/format.h"

namespace speed {

namespace {

OIIO::ROI enlarged(const Task& task) {
    if (task.part.defined())
        return task.part;
    return {0, task.width(), 0, task.height(), 0, 1, 0, 3};
}

/// Time `resize`, a function that fills the image it is given.
template <class Resize>
double seconds(const std::string& name, const Task& task, Resize&& resize) {
    OIIO::ImageBuf fresh;
    OIIO::ImageBuf& result = task.into ? *task.into : fresh;
    const auto start = std::chrono::steady_clock::now();
    const bool done = resize(result);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (!done)
        std::fprintf(stderr, "%s: %s\n", name.c_str(), result.geterror().c_str());
    return done ? time.count() : -1;
}

} // namespace

OIIO::ImageBuf warm_image(const Task& task) {
    OIIO::ImageSpec spec = task.image.spec();
    spec.width = spec.full_width = task.width();
    spec.height = spec.full_height = task.height();
    OIIO::ImageBuf image(spec);
    const std::vector<float> grey(size_t(spec.nchannels), 0.5f);
    OIIO::ImageBufAlgo::fill(image, grey);
    return image;
}

Way ddt_way(const std::string& filter, ddt::Statistics* statistics) {
    return {filter, [=](const Task& task) {
                return seconds(filter, task, [&](OIIO::ImageBuf& result) {
                    ddt::Options options;
                    std::string error;
                    options.statistics = statistics;
                    if (ddt::parse_filter(filter, options, error))
                        return ddt::resize(result, task.image, options, enlarged(task),
                                           task.threads);
                    ddt::set_error(result, error);
                    return false;
                });
            }};
}

std::vector<Way> oiio_ways() {
    std::vector<Way> ways;
    for (const char* filter : {"triangle", "blackman-harris", "lanczos3"})
        ways.push_back({filter, [filter](const Task& task) {
                            return seconds(filter, task, [&](OIIO::ImageBuf& result) {
                                return OIIO::ImageBufAlgo::resize(result, task.image, filter, 0,
                                                                  enlarged(task), task.threads);
                            });
                        }});
    return ways;
}

} // namespace speed
