// SPDX-License-Identifier: Apache-2.0
#include "core/gl/transfer.h"

#include <algorithm>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/base/zero_small.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"

namespace ddt::gl {

size_t encode_guide(const std::vector<float>& guide, std::byte* to) {
    std::byte* const first = to + sizeof(uint32_t);
    auto* steps = reinterpret_cast<uint16_t*>(first);
    // Without a way out, and with floats compared as the numbers that their bits are, compilers
    // make vectors of this loop.
    const auto most = int32_t(bits_of(65535.0f));
    uint32_t differing = 0;
    for (size_t i = 0; i < guide.size(); ++i) {
        const auto scaled = int32_t(bits_of((guide[i] - guide_of_nothing) * (1.0f / guide_unit)));
        const auto above = int32_t(choose(scaled < 0, 0, uint32_t(scaled)));
        const auto within = choose(above < most, uint32_t(above), uint32_t(most));
        const auto step = int32_t(float_of(within));
        steps[i] = uint16_t(step);
        differing |= bits_of(float(step) * guide_unit + guide_of_nothing) ^ bits_of(guide[i]);
    }
    const uint32_t are_steps = differing == 0;
    if (!are_steps)
        std::memcpy(first, guide.data(), guide.size() * sizeof(float));
    std::memcpy(to, &are_steps, sizeof are_steps);
    return sizeof are_steps + guide.size() * (are_steps ? sizeof(uint16_t) : sizeof(float));
}

size_t Numbers::room(size_t count) const {
    return whole_words(count * size_t(bytes));
}

Transfer transfer_of(Source& source, const Sink& sink, const Job& job) {
    Transfer transfer;
    // IDs are bits that are not to change.
    if (any_nearest(job))
        return transfer;
    const CodeTable* taken = sink.takes_codes();
    if (taken && !taken->entries.empty())
        transfer.download_codes = taken;
    transfer.download = transfer.download_codes ? Transfer::Download::codes
                        : sink.takes_halfs()    ? Transfer::Download::halfs
                                                : Transfer::Download::floats;
    // Rows and columns that are alone are repeated as floats.
    if (std::min(job.window.width(), job.window.height()) < 2)
        return transfer;
    Numbers& numbers = transfer.upload;
    numbers.table = source.codes();
    if (numbers.table.size() != 256 && numbers.table.size() != 65536)
        numbers.table.clear();
    zero_small(numbers.table.data(), numbers.table.size(), least_value);
    if (numbers.coded())
        numbers.bytes = numbers.table.size() == 256 ? 1 : 2;
    return transfer;
}

} // namespace ddt::gl
