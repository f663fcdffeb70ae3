// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/shrink_axis.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <OpenImageIO/filter.h>

#include "core/base/float_mode.h"
#include "core/base/parallel.h"
#include "plugin/image/pixels.h"
#include "plugin/imagebuf/thread_count.h"

namespace ddt {
namespace {

/// Rows of the result that a thread makes at once.
constexpr int rows_at_once = 8;

/// Pixels from `begin` to `end` - 1, of an axis.
struct Range {
    int begin, end;
};

/// Which pixels of the source a pixel of the result is the sum of, and their weights.
class Taps {
public:
    /// `data` and `from` are the source's data and display window, `to` the result's display
    /// window, `wanted` the pixels of the result.
    Taps(Range data, Range from, Range to, Range wanted) : m_wanted(wanted.begin) {
        const std::unique_ptr<OIIO::Filter1D, void (*)(OIIO::Filter1D*)> filter(
            OIIO::Filter1D::create("lanczos3", 6), OIIO::Filter1D::destroy);
        const double ratio = double(to.end - to.begin) / (from.end - from.begin);
        const double radius = filter->width() / 2 / ratio;
        for (int i = wanted.begin; i < wanted.end; ++i) {
            const double at = from.begin + (i - to.begin + 0.5) / ratio;
            const auto begin = int(std::floor(at - radius)), end = int(std::ceil(at + radius));
            std::vector<float> weights;
            float sum = 0;
            for (int j = begin; j < end; ++j)
                sum += weights.emplace_back((*filter)(float(ratio * (j + 0.5 - at))));
            Pixel& pixel = m_pixels.emplace_back();
            pixel.first = m_weights.size();
            for (int j = begin; j < end; ++j) {
                const bool there = j >= data.begin && j < data.end;
                const int k = there ? j : std::clamp(j, from.begin, from.end - 1);
                const float weight = weights[size_t(j - begin)] / sum;
                // Without those of weight 0: of what is infinite they would make NaN.
                if (weight == 0 || k < data.begin || k >= data.end)
                    continue;
                m_weights.push_back(weight);
                m_sources.push_back(k - data.begin);
                ++pixel.count;
            }
        }
    }

    /// Call f(place within the data window, weight) for each pixel that pixel i is made of.
    template <class F>
    void each(int i, F&& f) const {
        const Pixel& pixel = m_pixels[size_t(i - m_wanted)];
        for (size_t k = pixel.first; k < pixel.first + pixel.count; ++k)
            f(m_sources[k], m_weights[k]);
    }

private:
    struct Pixel {
        size_t first = 0, count = 0;
    };

    int m_wanted;
    std::vector<Pixel> m_pixels;
    std::vector<float> m_weights;
    std::vector<int> m_sources;
};

/// Up to four channels of a pixel, whose sums stay in registers.
template <int n>
void sum_channels(const Taps& taps, int x, const float* row, size_t stride, float* sums) {
    float s[n] = {};
    taps.each(x, [&](int k, float weight) {
        const float* from = row + size_t(k) * stride;
        for (int c = 0; c < n; ++c)
            s[c] += weight * from[c];
    });
    std::copy(s, s + n, sums);
}

void sum_pixel(const Taps& taps, int x, const float* row, int channels, float* sums) {
    constexpr decltype(&sum_channels<1>) of[] = {sum_channels<1>, sum_channels<2>, sum_channels<3>,
                                                 sum_channels<4>};
    for (int c = 0; c < channels; c += 4)
        of[std::min(channels - c, 4) - 1](taps, x, row + c, size_t(channels), sums + c);
}

} // namespace

void shrink_axis(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, bool along_x, const OIIO::ROI& roi,
                 int nthreads) {
    const DefaultFloats of_caller;
    const OIIO::ROI data = src.roi(), from = src.roi_full(), to = dst.roi_full();
    const Taps taps = along_x ? Taps({data.xbegin, data.xend}, {from.xbegin, from.xend},
                                     {to.xbegin, to.xend}, {roi.xbegin, roi.xend})
                              : Taps({data.ybegin, data.yend}, {from.ybegin, from.yend},
                                     {to.ybegin, to.yend}, {roi.ybegin, roi.yend});
    const int channels = src.nchannels();
    const size_t row = size_t(roi.width()) * size_t(channels);
    const auto source = [&](int x, int y) {
        return static_cast<const float*>(address(src, x, y, 0));
    };
    const auto make_row = [&](int y, float* sums) {
        if (along_x) {
            for (int x = roi.xbegin; x < roi.xend; ++x, sums += channels)
                sum_pixel(taps, x, source(data.xbegin, y), channels, sums);
        } else {
            std::fill(sums, sums + row, 0.0f);
            taps.each(y, [&](int k, float weight) {
                const float* const line = source(roi.xbegin, data.ybegin + k);
                for (size_t i = 0; i < row; ++i)
                    sums[i] += weight * line[i];
            });
        }
    };
    const int bands = (roi.height() + rows_at_once - 1) / rows_at_once;
    for_each_index(threads_for(thread_count(nthreads)), bands, [&](int, int band) {
        const DefaultFloats of_thread;
        std::vector<float> sums(row + size_t(channels)); // write_floats() counts whole pixels
        const int begin = roi.ybegin + band * rows_at_once;
        for (int y = begin; y < std::min(begin + rows_at_once, roi.yend); ++y) {
            make_row(y, sums.data());
            write_floats(dst, {roi.xbegin, y, roi.xend, y + 1}, roi.chbegin, roi.chend,
                         sums.data() + roi.chbegin, channels);
        }
    });
}

} // namespace ddt
