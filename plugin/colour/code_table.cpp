// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/code_table.h"

#include <algorithm>
#include <array>

#include "core/base/codes.h"

namespace ddt {

namespace {

constexpr uint32_t no_border = 0xffffff;

/// Bits of the first float whose code is not below `code`; the curve rises.
uint32_t border_of(const Curve& curve, int code) {
    uint32_t below = 0, at = Curve::last - 1;
    while (at - below > 1) {
        const uint32_t middle = below + (at - below) / 2;
        (code_of<uint8_t>(curve(float_of(middle))) < code ? below : at) = middle;
    }
    return at;
}

} // namespace

bool fill_codes(const Curve& curve, CodeTable& table) {
    const float *positive = curve.values(), *negative = positive + Curve::half;
    if (!std::is_sorted(positive, negative) || code_of<uint8_t>(positive[0]) != 0 ||
        code_of<uint8_t>(curve(float_of(Curve::last - 1))) != 255 ||
        std::any_of(negative, negative + Curve::half, code_of<uint8_t>))
        return false;
    std::array<uint32_t, 256> borders{};
    for (int code = 1; code < 256; ++code)
        borders[size_t(code)] = border_of(curve, code);
    const auto meet = [&](uint32_t a, uint32_t b) { return a >> table.shift == b >> table.shift; };
    for (table.shift = 17;
         std::adjacent_find(borders.begin() + 1, borders.end(), meet) != borders.end();)
        if (--table.shift < 12)
            return false; // steps rather than a curve
    table.first = borders[1] >> table.shift;
    table.lowest = float_of(table.first << table.shift);
    table.top = float_of(borders[255]);
    // Should the first piece begin with its border, what is below it must still be 0.
    if (borders[1] == table.first << table.shift)
        table.lowest = float_of(--table.first << table.shift);
    table.entries.clear();
    for (uint32_t piece = table.first, code = 0; piece <= borders[255] >> table.shift; ++piece) {
        const bool border = code < 255 && borders[code + 1] >> table.shift == piece;
        const uint32_t within =
            borders[std::min(code + 1, 255u)] & ((1u << unsigned(table.shift)) - 1);
        table.entries.push_back(code << 24 | (border ? within : no_border));
        code += border;
    }
    return true;
}

} // namespace ddt
