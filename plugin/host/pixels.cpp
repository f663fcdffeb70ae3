// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/pixels.h"

#include <algorithm>

#include "plugin/colour/colour_pixels.h"

namespace ddt::host {
namespace {

/// Colour times or divided by alpha: OpenImageIO's premult and unpremult.
void associate(const ColourLayout& colour, float* pixels, size_t count, int channels) {
    for (size_t i = 0; i < count; ++i, pixels += channels)
        for (int k = 0; k < colour.count; ++k)
            pixels[colour.channel[k]] *= pixels[colour.alpha];
}
void dissociate(const ColourLayout& colour, float* pixels, size_t count, int channels) {
    for (size_t i = 0; i < count; ++i, pixels += channels)
        if (const float alpha = pixels[colour.alpha]; alpha != 0.0f)
            for (int k = 0; k < colour.count; ++k)
                pixels[colour.channel[k]] /= alpha;
}

} // namespace

bool must_associate(const Layout& layout) {
    return !layout.associated && layout.colour.alpha >= 0;
}

void to_work(const Enlargement& work, float* values, size_t count) {
    const Layout& layout = work.layout;
    if (must_associate(layout))
        associate(layout.colour, values, count, layout.channels);
    to_light(*work.meaning.light, layout.colour, values, count, layout.channels);
}

void from_work(const Enlargement& work, float* values, size_t count) {
    const Layout& layout = work.layout;
    from_light(*work.meaning.light, layout.colour, values, count, layout.channels);
    if (must_associate(layout))
        dissociate(layout.colour, values, count, layout.channels);
}

HostSource::HostSource(const Enlargement& work)
    : m_work(work), m_guide(guide_recipe(work.layout, work.meaning)) {}

void HostSource::read_row(int y, const Rect& r, float* values) const {
    const Rect& box = m_work.from.box;
    const int channels = m_work.layout.channels;
    const int x0 = std::clamp(box.x0, r.x0, r.x1), x1 = std::clamp(box.x1, x0, r.x1);
    const bool there = y >= box.y0 && y < box.y1 && x0 < x1;
    if (!there || x0 > r.x0 || x1 < r.x1)
        std::fill_n(values, size_t(r.width()) * size_t(channels), 0.0f);
    if (there)
        load(m_work.from, x0, y, size_t(x1 - x0), channels,
             values + size_t(x0 - r.x0) * size_t(channels));
}

bool HostSource::read(const Rect& r, float* values, float* guide) {
    const Layout& layout = m_work.layout;
    const auto width = size_t(r.width());
    for (int y = r.y0; y < r.y1; ++y, values += width * size_t(layout.channels), guide += width) {
        read_row(y, r, values);
        if (layout.is_ids()) {
            std::fill_n(guide, width, 0.0f);
            continue;
        }
        to_work(m_work, values, width);
        make_guide(m_guide, values, width, layout.channels, guide);
    }
    return true;
}

std::vector<float> HostSource::codes() {
    const Layout& layout = m_work.layout;
    const Sample sample = m_work.from.sample;
    const Rect &box = m_work.from.box, &window = m_work.place.window;
    if (!(sample == Sample::uint8 || sample == Sample::half) || layout.is_ids() ||
        !box.contains(window) || must_associate(layout))
        return {};
    return light_of_codes(*m_work.meaning.light, layout.colour, layout.channels,
                          sample == Sample::uint8 ? 8 : 16,
                          [&](const void* numbers, int n, float* values) {
                              to_floats(sample, numbers, size_t(n), values);
                          });
}

bool HostSource::read_codes(const Rect& r, void* codes, float* guide) {
    const int channels = m_work.layout.channels;
    const auto width = size_t(r.width());
    const size_t row = width * size_t(channels);
    std::vector<float> values(row);
    char* to = static_cast<char*>(codes);
    for (int y = r.y0; y < r.y1; ++y, to += row * size_of(m_work.from.sample), guide += width) {
        load_numbers(m_work.from, r.x0, y, width, channels, to);
        to_floats(m_work.from.sample, to, row, values.data());
        to_work(m_work, values.data(), width);
        make_guide(m_guide, values.data(), width, channels, guide);
    }
    return true;
}

bool HostSink::write(const Rect& r, float* values) {
    const Layout& layout = m_work.layout;
    if (write_codes(r, values))
        return true;
    if (!layout.is_ids())
        from_work(m_work, values, r.area());
    const size_t row = size_t(r.width()) * size_t(layout.channels);
    for (int y = r.y0; y < r.y1; ++y, values += row)
        store(m_work.to, r.x0, y, size_t(r.width()), layout.channels, values);
    return true;
}

/// Whether numbers are stored without a conversion but to the memory's kind.
bool HostSink::as_they_are() const {
    const Layout& layout = m_work.layout;
    return !must_associate(layout) && ddt::as_they_are(*m_work.meaning.light, layout.colour);
}

/// Floats that stay as they are.
float* HostSink::place(const Rect& r, size_t& row) {
    const Buffer& to = m_work.to;
    constexpr ptrdiff_t size = sizeof(float);
    const bool as_floats =
        to.sample == Sample::id32 || (to.sample == Sample::float32 && as_they_are());
    char* p = to.at(r.x0, r.y0);
    if (!as_floats || to.channel != size || to.pixel != size * m_work.layout.channels ||
        to.row < 0 || to.row % size != 0 || reinterpret_cast<uintptr_t>(p) % alignof(float) != 0)
        return nullptr;
    row = size_t(to.row / size);
    return reinterpret_cast<float*>(p);
}

bool HostSink::takes_halfs() const {
    return m_work.to.sample == Sample::half && !m_work.layout.is_ids() && as_they_are();
}

const CodeTable* HostSink::takes_codes() const {
    const Layout& layout = m_work.layout;
    const Light& light = *m_work.meaning.light;
    return m_work.to.sample == Sample::uint8 && !layout.is_ids() &&
                   all_alike(light, layout.colour, layout.channels)
               ? light.codes()
               : nullptr;
}

bool HostSink::write_packed(const Rect& r, const void* numbers) {
    const auto* from = static_cast<const char*>(numbers);
    const int channels = m_work.layout.channels;
    const auto width = size_t(r.width());
    const size_t row = width * size_t(channels) * size_of(m_work.to.sample);
    for (int y = r.y0; y < r.y1; ++y, from += row)
        store_numbers(m_work.to, r.x0, y, width, channels, from);
    return true;
}

/// The usual case at once.
bool HostSink::write_codes(const Rect& r, const float* values) const {
    const Buffer& to = m_work.to;
    const int channels = m_work.layout.channels;
    const CodeTable* codes = takes_codes();
    if (!codes || to.channel != 1 || to.pixel != channels)
        return false;
    const size_t row = size_t(r.width()) * size_t(channels);
    for (int y = r.y0; y < r.y1; ++y, values += row)
        codes->encode(values, reinterpret_cast<uint8_t*>(to.at(r.x0, y)), row);
    return true;
}

} // namespace ddt::host
