// SPDX-License-Identifier: Apache-2.0
// Pixels in the memory of a host.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ddt/rect.h"

namespace ddt::host {

/// What a number in memory is. Integers stand for 0 to 1, signed ones for -1 to 1.
enum class Sample : uint8_t {
    uint8,
    int8,
    uint16,
    int16,
    half,
    float32,
    float64,
    id32, ///< 32 bits that are copied as they are: object IDs
};

/// Bytes of a number.
size_t size_of(Sample sample);

/// True if numbers below 0 cannot be stored.
inline bool is_unsigned(Sample sample) {
    return sample == Sample::uint8 || sample == Sample::uint16;
}

/// Pixels of somebody else's. Rows are counted downwards: of a host that counts them upwards, the
/// box is mirrored about y = 0 (see flipped()) and `row` is negative.
struct Buffer {
    void* data = nullptr; ///< of the first channel of the pixel (box.x0, box.y0)
    ptrdiff_t row = 0, pixel = 0, channel = 0; ///< bytes from one to the next; any sign
    Rect box;                                  ///< the pixels that are there
    Sample sample = Sample::float32;

    char* at(int x, int y) const {
        return static_cast<char*>(data) + (ptrdiff_t(y) - box.y0) * row +
               (ptrdiff_t(x) - box.x0) * pixel;
    }
};

/// A rectangle of pixels under the other sense of y. Its own inverse.
inline Rect flipped(const Rect& r) {
    return {r.x0, -r.y1, r.x1, -r.y0};
}

/// Take `channels` floats of each of `count` pixels from the buffer, from (x, y) on, as OpenImageIO
/// converts numbers; of Sample::id32 the bits.
void load(const Buffer& buffer, int x, int y, size_t count, int channels, float* values);

/// The way back: integers get the nearest number, and 0 for NaN.
void store(const Buffer& buffer, int x, int y, size_t count, int channels, const float* values);

/// The numbers as they are, of size_of(buffer.sample) bytes.
void load_numbers(const Buffer& buffer, int x, int y, size_t count, int channels, void* numbers);
void store_numbers(const Buffer& buffer, int x, int y, size_t count, int channels,
                   const void* numbers);
/// Floats of n numbers of a kind, as load() makes them.
void to_floats(Sample sample, const void* numbers, size_t n, float* values);

} // namespace ddt::host
