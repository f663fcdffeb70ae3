// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gpu/picture.h"

#include <cmath>
#include <cstring>
#include <fstream>

#include "ddt/guide.h"

namespace ddt::bench {

namespace {

/// 0 to 1, by the place alone.
float noise(int x, int y) {
    uint32_t h = uint32_t(x) * 0x9e3779b9u ^ uint32_t(y) * 0x85ebca6bu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return float((h ^ (h >> 15)) >> 8) * (1.0f / 16777216.0f);
}

/// i walks forth and back through 0 .. n - 1.
int mirrored(int i, int n) {
    const int k = i % (2 * n);
    return k < n ? k : 2 * n - 1 - k;
}

} // namespace

Picture::Picture(int width, int height)
    : m_width(width), m_height(height), m_values(size_t(width) * size_t(height) * 4),
      m_guide(size_t(width) * size_t(height)) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto u = float(x), v = float(y);
            const float disc =
                std::fmod(std::hypot(u - 500.0f, v - 300.0f), 90.0f) < 40 ? 0.25f : 0;
            const float stripe = std::fmod(0.8f * u + 0.6f * v, 130.0f) < 20 ? -0.2f : 0;
            const float shade = 0.45f + 0.2f * std::sin(u * 0.013f) * std::cos(v * 0.017f);
            const float z = shade + disc + stripe + 0.03f * noise(x, y);
            set(x, y, z, 0.9f * z, 0.8f * z + 0.1f);
        }
}

void Picture::set(int x, int y, float r, float g, float b) {
    const size_t i = size_t(y) * size_t(m_width) + size_t(x);
    const float rgba[] = {r, g, b, 1.0f};
    for (size_t c = 0; c < 4; ++c)
        m_values[4 * i + c] = rgba[c];
    m_guide[i] = std::round((luminance_weights[0] * r + luminance_weights[1] * g +
                             luminance_weights[2] * b) *
                            4096.0f) /
                 4096.0f;
}

bool Picture::paint(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string kind;
    int width = 0, height = 0, most = 0;
    in >> kind >> width >> height >> most;
    in.get();
    if (!in || kind != "P6" || most != 255 || width < 1 || height < 1)
        return false;
    std::vector<char> bytes(size_t(width) * size_t(height) * 3);
    if (!in.read(bytes.data(), std::streamsize(bytes.size())))
        return false;
    for (int y = 0; y < m_height; ++y)
        for (int x = 0; x < m_width; ++x) {
            const char* p =
                &bytes[(size_t(mirrored(y, height)) * size_t(width) + size_t(mirrored(x, width))) *
                       3];
            const auto number = [&](int c) { return float(uint8_t(p[c])) * (1.0f / 255.0f); };
            set(x, y, number(0), number(1), number(2));
        }
    return true;
}

bool Picture::read(const Rect& r, float* values, float* guide) {
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
            const size_t i = size_t(y) * size_t(m_width) + size_t(x);
            for (size_t c = 0; c < 4; ++c)
                *values++ = m_values[4 * i + c];
            *guide++ = m_guide[i];
        }
    return true;
}

ResizeMapping Picture::twofold() const {
    return {ResizeMapping::Axis::whole(m_width, 2 * m_width),
            ResizeMapping::Axis::whole(m_height, 2 * m_height)};
}

// Not zeros, which would be pages that are not there before they are written.
TwiceTheSize::TwiceTheSize(const Picture& picture)
    : m_row(2 * size_t(picture.width()) * 4), m_values(m_row * 2 * size_t(picture.height()), 1.0f) {
}

bool TwiceTheSize::write(const Rect& r, float* values) {
    const size_t n = size_t(r.width()) * 4;
    size_t row;
    for (int y = r.y0; y < r.y1; ++y, values += n)
        std::memcpy(place({r.x0, y, r.x1, y + 1}, row), values, n * sizeof(float));
    return true;
}

float* TwiceTheSize::place(const Rect& r, size_t& row) {
    row = m_row;
    return &m_values[size_t(r.y0) * m_row + size_t(r.x0) * 4];
}

} // namespace ddt::bench
