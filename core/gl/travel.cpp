// SPDX-License-Identifier: Apache-2.0
#include "core/gl/travel.h"

#include <algorithm>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/base/zero_small.h"
#include "core/tiles/tile_io.h"

namespace ddt::gl {

size_t encode_guide(const std::vector<float>& guide, std::byte* to) {
    std::vector<uint16_t> steps;
    steps.reserve(guide.size());
    for (const float v : guide) {
        constexpr float least = 1.0f / guide_unit;
        const float scaled = v * least;
        const auto step = uint16_t(scaled >= 0.0f && scaled < 65536.0f ? scaled : 0.0f);
        if (bits_of(float(step) * guide_unit) != bits_of(v))
            break;
        steps.push_back(step);
    }
    const uint32_t are_steps = steps.size() == guide.size();
    std::memcpy(to, &are_steps, sizeof are_steps);
    const size_t bytes = guide.size() * (are_steps ? sizeof(uint16_t) : sizeof(float));
    std::memcpy(to + sizeof are_steps,
                are_steps ? static_cast<const void*>(steps.data()) : guide.data(), bytes);
    return sizeof are_steps + bytes;
}

size_t Numbers::room(size_t count) const {
    return whole_words(count * size_t(bytes));
}

Travel travel_of(Source& source, const Sink& sink, const Job& job) {
    Travel travel;
    // Identifiers are bits that are not to change.
    if (any_nearest(job))
        return travel;
    travel.codes_back = sink.takes_codes();
    travel.back = travel.codes_back    ? Travel::Back::codes
                  : sink.takes_halfs() ? Travel::Back::halfs
                                       : Travel::Back::floats;
    // Rows and columns that are alone are repeated as floats.
    if (std::min(job.window.width(), job.window.height()) < 2)
        return travel;
    Numbers& numbers = travel.there;
    numbers.table = source.codes();
    zero_small(numbers.table.data(), numbers.table.size(), least_value);
    if (numbers.coded())
        numbers.bytes = numbers.table.size() == 256 ? 1 : 2;
    return travel;
}

} // namespace ddt::gl
