// SPDX-License-Identifier: Apache-2.0
#include "plugin/reader/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/tiles/cuts.h"
#include "plugin/image/memory.h"
#include "plugin/image/windows.h"

namespace ddt {
namespace {

constexpr size_t most_at_once = size_t(32) << 20; // bytes
constexpr size_t largest_piece = size_t(8) << 20; // bytes
constexpr int shortest = 64, longest = 1024;      // sides of pieces in pixels, about

} // namespace

Pieces::Pieces(const OIIO::ImageBuf& source, const OIIO::ImageSpec& spec, const Options& options,
               size_t most_kept)
    : m_source(source), m_spec(spec), m_options(options), m_most_kept(most_kept) {
    const auto pixel = double(spec.pixel_bytes());
    const auto clamped = [](double v, int low, int high) {
        return int(std::clamp(v, double(low), double(high)));
    };
    const int width = clamped(std::sqrt(double(largest_piece) / pixel), shortest, longest);
    // A row of pieces is kept whole: most programs read row by row.
    const int height =
        clamped(0.75 * double(most_kept) / (pixel * double(spec.width)), shortest, width);
    const ResizeMapping::Axis x = x_axis(source.spec(), spec, spec.roi()),
                              y = y_axis(source.spec(), spec, spec.roi());
    // Holes are those of the whole image: one piece, so that they are filled once.
    const bool whole = options.holes != Holes::keep;
    m_x = whole ? std::vector<int>{x.out0, x.out1} : cuts_between_tiles(x, shortest, width);
    m_y = whole ? std::vector<int>{y.out0, y.out1} : cuts_between_tiles(y, shortest, height);
}

Rect Pieces::rect(size_t row, size_t column) const {
    return {m_x[column], m_y[row], m_x[column + 1], m_y[row + 1]};
}

bool Pieces::read(const Rect& r, int threads, void* out, size_t stride, std::string& error) {
    error = m_failure;
    if (!error.empty())
        return false;
    for (size_t row = piece_of(m_y, r.y0); row + 1 < m_y.size() && m_y[row] < r.y1; ++row)
        if (!read_row(row, r, threads, static_cast<char*>(out), stride, error)) {
            m_failure = error;
            return false;
        }
    return true;
}

bool Pieces::read_row(size_t row, const Rect& r, int threads, char* out, size_t stride,
                      std::string& error) {
    const size_t end = piece_of(m_x, r.x1 - 1) + 1;
    const size_t height = size_t(m_y[row + 1] - m_y[row]);
    for (size_t column = piece_of(m_x, r.x0); column < end;) {
        if (const auto kept = m_kept.find({row, column}); kept != m_kept.end()) {
            kept->second.used = ++m_clock;
            copy(rect(row, column), kept->second.pixels.data(), r, out, stride);
            ++column;
            continue;
        }
        // As many at once as there are: the filter's threads share them.
        size_t last = column + 1;
        while (last < end && m_kept.find({row, last}) == m_kept.end() &&
               m_spec.pixel_bytes() * size_t(m_x[last + 1] - m_x[column]) * height <= most_at_once)
            ++last;
        OIIO::ImageBuf band;
        if (!compute(row, column, last, threads, band, error))
            return false;
        copy(rect_of(band.roi()), static_cast<const char*>(band.localpixels()), r, out, stride);
        keep(row, column, last, band);
        column = last;
    }
    return true;
}

bool Pieces::compute(size_t row, size_t first, size_t last, int threads, OIIO::ImageBuf& band,
                     std::string& error) const {
    const OIIO::ROI roi(m_x[first], m_x[last], m_y[row], m_y[row + 1], 0, 1, 0, m_spec.nchannels);
    OIIO::ImageSpec spec = m_spec;
    OIIO::set_roi(spec, roi);
    if (!take_memory(band, spec, error))
        error = "ddt: " + error;
    else if (!resize(band, m_source, m_options, roi, threads))
        error = band.geterror();
    return error.empty();
}

void Pieces::keep(size_t row, size_t first, size_t last, const OIIO::ImageBuf& band) {
    const Rect whole = rect_of(band.roi());
    for (size_t column = first; column < last; ++column) {
        const Rect r = rect(row, column);
        const size_t stride = m_spec.pixel_bytes() * size_t(r.width());
        std::vector<char> pixels(stride * size_t(r.height()));
        copy(whole, static_cast<const char*>(band.localpixels()), r, pixels.data(), stride);
        m_bytes += pixels.size();
        m_kept[{row, column}] = {std::move(pixels), ++m_clock};
        while (m_bytes > m_most_kept && m_kept.size() > 1)
            forget_oldest();
    }
}

void Pieces::forget_oldest() {
    const auto oldest =
        std::min_element(m_kept.begin(), m_kept.end(), [](const auto& a, const auto& b) {
            return a.second.used < b.second.used;
        });
    m_bytes -= oldest->second.pixels.size();
    m_kept.erase(oldest);
}

/// Copy what the pixels of `from`, rows without gaps, and `r` have in common to the place of `r`.
void Pieces::copy(const Rect& from, const char* pixels, const Rect& r, char* out,
                  size_t stride) const {
    const size_t pixel = m_spec.pixel_bytes();
    const int x0 = std::max(from.x0, r.x0), x1 = std::min(from.x1, r.x1);
    for (int y = std::max(from.y0, r.y0); x0 < x1 && y < std::min(from.y1, r.y1); ++y)
        std::memcpy(out + size_t(y - r.y0) * stride + size_t(x0 - r.x0) * pixel,
                    pixels +
                        (size_t(y - from.y0) * size_t(from.width()) + size_t(x0 - from.x0)) * pixel,
                    size_t(x1 - x0) * pixel);
}

} // namespace ddt
