// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/checked_job.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

#include "core/base/arith.h"

namespace ddt::gl {

namespace {

uint32_t hash(uint32_t x, uint32_t y) {
    uint32_t h = x * 0x9e3779b9u ^ y * 0x85ebca6bu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return h ^ (h >> 15);
}

float noise_of(uint32_t h) {
    return float(h >> 20) * (1.0f / 4096.0f);
}

float stripe_at(int x, int y) {
    return (2 * x + 3 * y) % 29 < 11 ? 0.5f : 0.0f;
}

float odd_number(uint32_t i) {
    constexpr float infinity = std::numeric_limits<float>::infinity(), large = 3e38f;
    constexpr float reciprocal_squared_is_denormal = 5e36f;
    constexpr float all[] = {
        std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -0.0f, large, -large,
        reciprocal_squared_is_denormal,          -0.8f,    -30.0f};
    return all[i % std::size(all)];
}

/// Here the guide's stripes are upright, so that contours tell of no diagonal which way it
/// goes: its ends do, which differ by little. Values go from black to white, for what fitted
/// vertices make of pixels near both.
bool between_stripes(int x, int y) {
    return x >= 24 && x < 48 && y >= 22 && y < 40;
}

/// The guide's rows after this one are it and the next by turns: there edges have the gains of
/// others near them, and which of them flips is a matter of their places.
constexpr int repeated = 40;

/// Of multiples of guide_unit from 0 to 1 squares are exact in most places, and a sum of them
/// has the same bits where a device contracts it: some contrasts are neither.
float guide_at(int x, int y) {
    if (y > repeated)
        y = repeated + (y - repeated) % 2;
    const uint32_t h = hash(uint32_t(x), uint32_t(y));
    if (between_stripes(x, y))
        return (x % 7 < 3 ? 0.5f : 0.25f) + float(h >> 30) * guide_unit;
    return (0.5f * noise_of(h) + stripe_at(x, y)) * (h % 7 == 0 ? 11.3f : 1.0f);
}

ResizeMapping enlarged() {
    constexpr int scale = 3;
    const auto axis = [](int window0, int window1) {
        const int n = window1 - window0;
        return ResizeMapping::Axis{window0, n, 0, scale * n, window0, window1, 0, scale * n};
    };
    return {axis(checked_window.x0, checked_window.x1), axis(checked_window.y0, checked_window.y1)};
}

} // namespace

bool CheckSource::read(const Rect& r, float* values, float* guide) {
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
            const uint32_t h = hash(uint32_t(x), uint32_t(y));
            const float noise = noise_of(h), stripe = stripe_at(x, y);
            const float bright = h % 101 == 0 ? 1000.0f : 1.0f;
            *guide++ = guide_at(x, y);
            const bool odd = x < 18 && y < 15 && h % 4 == 0;
            const bool steep = x >= 20 && x < 38 && y < 15;
            const bool smooth = x >= 7 && x < 22 && y >= 24 && y < 39;
            const float usual = smooth ? 0.7f + 0.02f * noise : (0.3f * noise + stripe) * bright;
            for (int c = 0; c < m_channels; ++c)
                *values++ = odd     ? odd_number(h / 4 + uint32_t(c))
                            : steep ? (y % 2 != 0 ? 0x1p46f : 0x1p-79f * (1 + noise))
                            : between_stripes(x, y) ? float(hash(h, uint32_t(c)) >> 8) * 0x1p-24f
                                                    : usual * float(c + 1) * 0.37f;
        }
    return true;
}

bool CheckSink::write(const Rect& r, float* values) {
    const size_t row = size_t(r.width()) * m_channels;
    for (int y = r.y0; y < r.y1; ++y, values += row)
        std::memcpy(&m_bits[index_of(r.x0, y)], values, row * sizeof(float));
    return true;
}

Bits CheckSink::of(const std::vector<Rect>& runs) const {
    Bits all;
    for (const Rect& r : runs)
        for (int y = r.y0; y < r.y1; ++y)
            all.insert(all.end(), m_bits.begin() + ptrdiff_t(index_of(r.x0, y)),
                       m_bits.begin() + ptrdiff_t(index_of(r.x1 - 1, y) + m_channels));
    return all;
}

Enlarged::Enlarged() : m_mapping(enlarged()) {}

void Turned::row(int y, int x0, int x1, Position* positions, uint8_t* inside) const {
    constexpr int one = position_one;
    for (int x = x0; x < x1; ++x) {
        const Position p{14 * one + 31337 * x - 10007 * y, 10007 * x + 31337 * y};
        *inside++ = p.x >= checked_window.x0 * one && p.x <= (checked_window.x1 - 1) * one &&
                    p.y >= checked_window.y0 * one && p.y <= (checked_window.y1 - 1) * one;
        *positions++ = p;
    }
}

Job job_to_check(const Job& job) {
    Job check;
    check.window = checked_window;
    check.channels = job.channels % group_size == 0 ? group_size : group_size + 1;
    check.kinds.assign(size_t(check.channels), Channel::blend);
    check.kinds[2] = Channel::nearest;
    check.kinds[3] = Channel::alpha;
    check.mesh.scheme = job.mesh.scheme;
    check.mesh.cost = job.mesh.cost;
    check.mesh.start = job.mesh.start;
    check.mesh.contour = job.mesh.contour > 0 ? 0.4f : 0.0f;
    if (job.mesh.scheme == Scheme::annealing)
        check.mesh.max_iterations = 6;
    if (job.mesh.max_iterations == 0)
        check.mesh.max_iterations = 0;
    check.mesh.min_gain = -1.0f; // many flips, and late ones
    check.mesh.blur = 0.07f;     // several meshes differ by it
    // What is right for two meshes counts for more of them (job_key_of), yet of two surfaces the
    // mean is of halves, which are exact: contracted it has the same bits; of three it has others.
    check.mesh.meshes = job.mesh.meshes > 1 ? 3 : 1;
    check.surface.kind = job.surface.kind;
    check.surface.consistency = std::min(job.surface.consistency, 2);
    check.surface.limit = 0.3f; // its default is a power of two, products with which are exact
    check.surface.soft = job.surface.soft > 0 ? 0.3f : 0.0f;
    check.surface.fitted = job.surface.fitted;
    check.surface.clipped = job.surface.clipped;
    return check;
}

} // namespace ddt::gl
