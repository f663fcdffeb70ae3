// SPDX-License-Identifier: Apache-2.0
// What numbers are on their way to the device and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/constants.h"
#include "ddt/core.h"

namespace ddt::gl {

/// Bytes in which whole words have room: what shaders read and write.
constexpr size_t whole_words(size_t bytes) {
    constexpr size_t word = sizeof(uint32_t);
    return (bytes + word - 1) / word * word;
}

/// A guide on its way to the device: a word that tells whether 16-bit steps of guide_unit follow,
/// from guide_of_nothing on, which do for the usual guide below 15.5, or floats; then these, rows
/// without gaps. Decoded by shaders/unpack_guide.comp.
///
/// Room for so many, and what encode_guide() makes of the guide: the bytes of `to` that it takes.
constexpr size_t guide_room(size_t pixels) {
    return sizeof(uint32_t) + pixels * sizeof(float);
}
/// `to` is aligned as floats are.
size_t encode_guide(const std::vector<float>& guide, std::byte* to);

/// Numbers of the source: floats, or the codes that it has for them.
struct Numbers {
    int bytes = sizeof(float); ///< each takes
    std::vector<float> table;  ///< what codes of 1 or 2 bytes stand for; empty: they are floats
    bool coded() const { return !table.empty(); }
    /// Of so many numbers, in whole words.
    size_t room(size_t count) const;
};

/// A job's numbers, both ways.
struct Travel {
    Numbers there;
    /// Results: floats, 16-bit floats, or codes of this table.
    enum class Back { floats, halfs, codes } back = Back::floats;
    const CodeTable* codes_back = nullptr;
    size_t bytes_back() const { return back == Back::floats ? 4 : back == Back::halfs ? 2 : 1; }
    bool packed() const { return back != Back::floats; }
};

/// The fewest bytes that the job's source and sink allow.
Travel travel_of(Source& source, const Sink& sink, const Job& job);

} // namespace ddt::gl
