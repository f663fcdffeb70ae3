// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/size.h"

#include <charconv>

#include "plugin/image/largest_side.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

/// Takes pieces off the front of a text.
class Scanner {
public:
    explicit Scanner(const std::string& text)
        : m_at(text.data()), m_end(text.data() + text.size()) {}

    template <class Number>
    bool number(Number& n) {
        const auto parsed = std::from_chars(m_at, m_end, n);
        if (parsed.ec != std::errc())
            return false;
        m_at = parsed.ptr;
        return true;
    }
    /// A number with its sign.
    bool offset(int& n) {
        if (m_at == m_end || (*m_at != '+' && *m_at != '-'))
            return false;
        if (*m_at == '+' && (++m_at == m_end || *m_at == '-'))
            return false;
        return number(n);
    }
    bool character(char c) {
        if (m_at == m_end || *m_at != c)
            return false;
        ++m_at;
        return true;
    }
    bool end() const { return m_at == m_end; }

private:
    const char *m_at, *m_end;
};

/// To the nearest whole number; 0, which is not allowed, for what is too large.
int whole(float size) {
    size += 0.5f;
    return size >= 0 && size <= float(largest_side) ? int(size) : 0;
}

/// Single precision, as oiiotool does it: the last pixel may depend on it.
int scaled(int pixels, float factor) {
    return whole(float(pixels) * factor);
}

bool by_pixels(const std::string& text, const Size& from, Size& to) {
    Scanner scan(text);
    Size size = from;
    if (!scan.number(size.width) || !scan.character('x') || !scan.number(size.height))
        return false;
    if (!scan.end() && !(scan.offset(size.x) && scan.offset(size.y) && scan.end()))
        return false;
    if (size.width == 0 && size.height > 0)
        size.width = whole(float(size.height) * float(from.width) / float(from.height));
    else if (size.height == 0 && size.width > 0)
        size.height = whole(float(size.width) * float(from.height) / float(from.width));
    to = size;
    return true;
}

bool by_percent(const std::string& text, const Size& from, Size& to) {
    Scanner scan(text);
    float x = 0, y = 0;
    if (!scan.number(x) || !scan.character('%'))
        return false;
    y = x;
    if (!scan.end()) {
        if (!scan.character('x') || !scan.number(y) || !scan.character('%') || !scan.end())
            return false;
        if (x == 0)
            x = y;
        if (y == 0)
            y = x;
    }
    to = {scaled(from.width, x * 0.01f), scaled(from.height, y * 0.01f), from.x, from.y};
    return true;
}

bool by_factor(const std::string& text, const Size& from, Size& to) {
    Scanner scan(text);
    float factor = 0;
    if (!scan.number(factor) || !scan.end())
        return false;
    to = {scaled(from.width, factor), scaled(from.height, factor), from.x, from.y};
    return true;
}

} // namespace

bool parse_size(const std::string& text, const Size& from, Size& to) {
    Size size;
    if (!by_pixels(text, from, size) && !by_percent(text, from, size) &&
        !by_factor(text, from, size))
        return false;
    if (size.width < 1 || size.height < 1 || size.width > largest_side ||
        size.height > largest_side)
        return false;
    to = size;
    return true;
}

bool is_size(const std::string& text) {
    // What is too large for the smallest and too small for the largest is so for all.
    Size to;
    for (const int width : {1, largest_side})
        for (const int height : {1, largest_side})
            if (parse_size(text, {width, height}, to))
                return true;
    return false;
}

std::string wrong_size(const std::string& text) {
    return format("size \"{}\" is not allowed; allowed are {}, 1 to {} pixels a side", text,
                  allowed_sizes, largest_side);
}

} // namespace ddt::tool
