// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

#ifdef DDT_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif
#ifdef DDT_HAS_ZIMG
#include <zimg.h>
#endif

#include "ways.h"

namespace speed {

namespace {

using Clock = std::chrono::steady_clock;

[[maybe_unused]] double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

[[maybe_unused]] bool is_float(const OIIO::ImageBuf& image) {
    return image.spec().format.is_floating_point();
}

#ifdef DDT_HAS_OPENCV
cv::Mat matrix(OIIO::ImageBuf& image) {
    return {image.spec().height, image.spec().width, is_float(image) ? CV_32FC3 : CV_8UC3,
            image.localpixels()};
}

Way opencv(const char* name, int interpolation) {
    return {name, [=](const Task& task) {
                OIIO::ImageBuf source = task.image;
                const cv::Mat from = matrix(source);
                cv::Mat to;
                if (task.into)
                    to = matrix(*task.into);
                cv::setNumThreads(task.threads);
                const auto start = Clock::now();
                cv::resize(from, to, {task.width(), task.height()}, 0, 0, interpolation);
                return since(start);
            }};
}
#endif

#ifdef DDT_HAS_ZIMG
/// Three planes in rows of whole cache lines.
struct Planes {
    size_t row, plane; ///< bytes
    std::unique_ptr<char, decltype(&std::free)> memory{nullptr, &std::free};

    Planes(int width, int height, size_t sample)
        : row((size_t(width) * sample + 63) / 64 * 64), plane(row * size_t(height)) {
        memory.reset(static_cast<char*>(std::aligned_alloc(64, 3 * plane)));
    }
    template <class Buffer>
    void put(Buffer& buffer) const {
        for (size_t p = 0; p < 3; ++p) {
            buffer.plane[p].data = memory.get() + p * plane;
            buffer.plane[p].stride = ptrdiff_t(row);
            buffer.plane[p].mask = ZIMG_BUFFER_MAX;
        }
    }
};

zimg_image_format format_of(int width, int height, bool floats) {
    zimg_image_format format;
    zimg_image_format_default(&format, ZIMG_API_VERSION);
    format.width = unsigned(width);
    format.height = unsigned(height);
    format.pixel_type = floats ? ZIMG_PIXEL_FLOAT : ZIMG_PIXEL_BYTE;
    format.color_family = ZIMG_COLOR_RGB;
    format.matrix_coefficients = ZIMG_MATRIX_RGB;
    format.pixel_range = ZIMG_RANGE_FULL;
    return format;
}

double run_zimg(const Task& task, zimg_resample_filter_e filter) {
    const bool floats = is_float(task.image);
    const size_t sample = floats ? sizeof(float) : 1;
    const OIIO::ImageSpec& spec = task.image.spec();
    const Planes from(spec.width, spec.height, sample);
    for (int c = 0; c < 3; ++c)
        task.image.get_pixels(OIIO::ROI(0, spec.width, 0, spec.height, 0, 1, c, c + 1), spec.format,
                              from.memory.get() + size_t(c) * from.plane, OIIO::stride_t(sample),
                              OIIO::stride_t(from.row));
    // Kept from one run to the next where it is to be warm.
    static std::unique_ptr<Planes> kept;
    static int kept_width = 0, kept_height = 0;
    static size_t kept_sample = 0;
    const bool fits =
        kept && kept_width == task.width() && kept_height == task.height() && kept_sample == sample;
    if (!task.into || !fits) {
        kept = std::make_unique<Planes>(task.width(), task.height(), sample);
        if (task.into)
            std::fill_n(kept->memory.get(), 3 * kept->plane, 1);
    }
    kept_width = task.width();
    kept_height = task.height();
    kept_sample = sample;

    const auto start = Clock::now();
    const zimg_image_format source = format_of(spec.width, spec.height, floats),
                            result = format_of(task.width(), task.height(), floats);
    zimg_graph_builder_params params;
    zimg_graph_builder_params_default(&params, ZIMG_API_VERSION);
    params.resample_filter = filter;
    params.filter_param_a = filter == ZIMG_RESIZE_LANCZOS ? 3 : params.filter_param_a;
    params.cpu_type = ZIMG_CPU_AUTO_64B;
    const std::unique_ptr<zimg_filter_graph, decltype(&zimg_filter_graph_free)> graph(
        zimg_filter_graph_build(&source, &result, &params), &zimg_filter_graph_free);
    size_t size = 0;
    if (!graph || zimg_filter_graph_get_tmp_size(graph.get(), &size) != 0) {
        std::fprintf(stderr, "zimg failed\n");
        return -1;
    }
    const std::unique_ptr<void, decltype(&std::free)> scratch(
        std::aligned_alloc(64, (size + 63) / 64 * 64), &std::free);
    zimg_image_buffer_const in{ZIMG_API_VERSION, {}};
    zimg_image_buffer out{ZIMG_API_VERSION, {}};
    from.put(in);
    kept->put(out);
    if (zimg_filter_graph_process(graph.get(), &in, &out, scratch.get(), nullptr, nullptr, nullptr,
                                  nullptr) != 0) {
        std::fprintf(stderr, "zimg failed\n");
        return -1;
    }
    return since(start);
}
#endif

} // namespace

std::vector<Way> neighbour_ways() {
    std::vector<Way> ways;
#ifdef DDT_HAS_OPENCV
    ways.push_back(opencv("OpenCV cubic", cv::INTER_CUBIC));
    ways.push_back(opencv("OpenCV lanczos4", cv::INTER_LANCZOS4));
#endif
#ifdef DDT_HAS_ZIMG
    ways.push_back(
        {"zimg bicubic", [](const Task& t) { return run_zimg(t, ZIMG_RESIZE_BICUBIC); }});
    ways.push_back(
        {"zimg lanczos3", [](const Task& t) { return run_zimg(t, ZIMG_RESIZE_LANCZOS); }});
#endif
    return ways;
}

} // namespace speed
