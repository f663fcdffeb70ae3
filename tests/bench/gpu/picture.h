// SPDX-License-Identifier: Apache-2.0
// The picture that is measured, and where it goes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddt/core.h"

namespace ddt::bench {

/// RGBA; the guide a multiple of 2^-12.
class Picture final : public Source {
public:
    /// Shades, discs and stripes with a little noise, about as hard to triangulate as photographs.
    Picture(int width, int height);
    /// A binary PPM file (P6, 8 bits), mirrored over and over to the size. False if it is not one.
    bool paint(const std::string& file);

    int width() const { return m_width; }
    int height() const { return m_height; }
    /// To twice its size.
    ResizeMapping twofold() const;
    bool read(const Rect& r, float* values, float* guide) override;

private:
    void set(int x, int y, float r, float g, float b);

    int m_width, m_height;
    std::vector<float> m_values; ///< 4 a pixel
    std::vector<float> m_guide;
};

/// Twice the picture: RGBA floats. Devices hand rows over, the CPU may write into their place.
class TwiceTheSize final : public Sink {
public:
    explicit TwiceTheSize(const Picture& picture);
    bool write(const Rect& r, float* values) override;
    float* place(const Rect& r, size_t& row) override;
    const std::vector<float>& values() const { return m_values; }

private:
    size_t m_row; ///< floats
    std::vector<float> m_values;
};

} // namespace ddt::bench
