// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/buffer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/codes.h"
#include "core/base/half.h"

namespace ddt::host {
namespace {

template <class Number>
Number read(const char* p) {
    Number n;
    std::memcpy(&n, p, sizeof n);
    return n;
}
template <class Number>
void write(char* p, Number n) {
    std::memcpy(p, &n, sizeof n);
}

// Kinds of numbers: memory holds Stored; to() and from() convert. As Codes and Halfs, but for rows.
template <class Code>
struct Signed {
    using Stored = Code;
    static constexpr float most = std::numeric_limits<Code>::max();
    static float to(Code c) { return float(c) * (1.0f / most); }
    static Code from(float v) {
        if (std::isnan(v))
            return 0;
        const float scaled = v * most + (v < 0 ? -0.5f : 0.5f);
        return Code(std::clamp(scaled, float(std::numeric_limits<Code>::min()), most));
    }
};
template <class Number>
struct Plain {
    using Stored = Number;
    static float to(Number n) { return float(n); }
    static Number from(float v) { return v; }
};

/// Whether a row's numbers have no gaps between them.
bool is_dense(const Buffer& b, int channels) {
    const auto size = ptrdiff_t(size_of(b.sample));
    return b.channel == size && b.pixel == size * channels;
}

/// The kinds whose rows convert at once.
template <class Kind>
constexpr bool has_rows = false;
template <class Code>
constexpr bool has_rows<Codes<Code>> = true;
template <>
constexpr bool has_rows<Halfs> = true;

/// Whether numbers at p are a row that does.
template <class Kind>
bool is_row(const Buffer& b, const char* p, int channels) {
    return is_dense(b, channels) &&
           reinterpret_cast<uintptr_t>(p) % alignof(typename Kind::Stored) == 0;
}

template <class Kind>
void load_as(const Buffer& b, const char* p, size_t count, int channels, float* values) {
    using Stored = typename Kind::Stored;
    if constexpr (has_rows<Kind>)
        if (is_row<Kind>(b, p, channels))
            return Kind::row_to(reinterpret_cast<const Stored*>(p), count * size_t(channels),
                                values);
    for (size_t i = 0; i < count; ++i, p += b.pixel) {
        const char* number = p;
        for (int c = 0; c < channels; ++c, number += b.channel)
            *values++ = Kind::to(read<Stored>(number));
    }
}
template <class Kind>
void store_as(const Buffer& b, char* p, size_t count, int channels, const float* values) {
    using Stored = typename Kind::Stored;
    if constexpr (has_rows<Kind>)
        if (is_row<Kind>(b, p, channels))
            return Kind::row_from(values, count * size_t(channels), reinterpret_cast<Stored*>(p));
    for (size_t i = 0; i < count; ++i, p += b.pixel) {
        char* number = p;
        for (int c = 0; c < channels; ++c, number += b.channel)
            write<Stored>(number, Kind::from(*values++));
    }
}

/// Call `f` with an instance of the kind of number.
template <class F>
void with_kind(Sample sample, F&& f) {
    switch (sample) {
    case Sample::uint8:
        return f(Codes<uint8_t>());
    case Sample::int8:
        return f(Signed<int8_t>());
    case Sample::uint16:
        return f(Codes<uint16_t>());
    case Sample::int16:
        return f(Signed<int16_t>());
    case Sample::half:
        return f(Halfs());
    case Sample::float64:
        return f(Plain<double>());
    case Sample::float32:
    case Sample::id32:
        return f(Plain<float>());
    }
}

/// Whether they are a row of floats, or of as many bits that are none.
bool is_floats(const Buffer& b, int channels) {
    return size_of(b.sample) == sizeof(float) && is_dense(b, channels);
}

/// Call copy(in the buffer, in the row, bytes) for as many numbers at once as have no gaps.
template <class Byte, class Copy>
void each_piece(const Buffer& b, int x, int y, size_t count, int channels, Byte* numbers,
                Copy&& copy) {
    char* p = b.at(x, y);
    const size_t size = size_of(b.sample);
    if (is_dense(b, channels))
        return copy(p, numbers, count * size_t(channels) * size);
    for (size_t i = 0; i < count; ++i, p += b.pixel)
        for (int c = 0; c < channels; ++c, numbers += size)
            copy(p + c * b.channel, numbers, size);
}

} // namespace

size_t size_of(Sample sample) {
    size_t size = 0;
    with_kind(sample, [&](auto kind) { size = sizeof(typename decltype(kind)::Stored); });
    return size;
}

void load(const Buffer& b, int x, int y, size_t count, int channels, float* values) {
    const char* p = b.at(x, y);
    // Also because bits that are no number must stay the bits they are.
    if (is_floats(b, channels))
        std::memcpy(values, p, count * size_t(channels) * sizeof(float));
    else
        with_kind(b.sample,
                  [&](auto kind) { load_as<decltype(kind)>(b, p, count, channels, values); });
}

void store(const Buffer& b, int x, int y, size_t count, int channels, const float* values) {
    char* p = b.at(x, y);
    if (is_floats(b, channels))
        std::memcpy(p, values, count * size_t(channels) * sizeof(float));
    else
        with_kind(b.sample,
                  [&](auto kind) { store_as<decltype(kind)>(b, p, count, channels, values); });
}

void load_numbers(const Buffer& b, int x, int y, size_t count, int channels, void* numbers) {
    each_piece(b, x, y, count, channels, static_cast<char*>(numbers),
               [](const char* p, char* to, size_t bytes) { std::memcpy(to, p, bytes); });
}

void store_numbers(const Buffer& b, int x, int y, size_t count, int channels, const void* numbers) {
    each_piece(b, x, y, count, channels, static_cast<const char*>(numbers),
               [](char* p, const char* from, size_t bytes) { std::memcpy(p, from, bytes); });
}

void to_floats(Sample sample, const void* numbers, size_t n, float* values) {
    const auto size = ptrdiff_t(size_of(sample));
    const Buffer row{const_cast<void*>(numbers), 0, size, size, {0, 0, int(n), 1}, sample};
    load(row, 0, 0, n, 1, values);
}

} // namespace ddt::host
