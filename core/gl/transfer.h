// SPDX-License-Identifier: Apache-2.0
// How numbers go to the device and come back.
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
struct Transfer {
    Numbers upload;
    /// Results: floats, 16-bit floats, or codes of this table.
    enum class Download { floats, halfs, codes } download = Download::floats;
    const CodeTable* download_codes = nullptr;
    size_t download_bytes() const {
        return download == Download::floats ? 4 : download == Download::halfs ? 2 : 1;
    }
    bool packed() const { return download != Download::floats; }
};

/// The fewest bytes that the job's source and sink allow.
Transfer transfer_of(Source& source, const Sink& sink, const Job& job);

} // namespace ddt::gl
