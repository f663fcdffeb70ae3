// SPDX-License-Identifier: Apache-2.0
// The small job that a device is checked with: a tile of a picture, and two mappings.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt::gl {

/// A tile within its picture, whose slots are larger, and serves some of its cells. Its size and
/// that of its results are no multiples of groups of invocations.
constexpr Rect checked_window{-3, -2, 65, 50};
constexpr Tile checked_tile{{6, 5, 56, 42}, {0, 0, 63, 49}, false, false};

/// Noise, stripes and a few very bright pixels; in a corner of what is served, so that most of the
/// check is of numbers as pictures have them, also what is not finite, or is so large that sums of
/// it are not; beside that rows so steep that sums of their gradients are denormal; pixels from
/// black to white; and ones so alike that it is not their smallest that bounds how far below them a
/// corrected vertex may go. The guide has stripes of its own.
class CheckSource final : public Source {
public:
    explicit CheckSource(int channels) : m_channels(channels) {}
    bool read(const Rect& r, float* values, float* guide) override;

private:
    int m_channels;
};

/// Numbers by their bits.
using Bits = std::vector<uint32_t>;

/// Keeps what is written of a part of the result.
class CheckSink final : public Sink {
public:
    CheckSink(const Rect& part, int channels)
        : m_part(part), m_channels(size_t(channels)), m_bits(part.area() * m_channels) {}
    bool write(const Rect& r, float* values) override;
    /// What was written to these pixels, one rectangle after the other.
    Bits of(const std::vector<Rect>& runs) const;

private:
    size_t index_of(int x, int y) const {
        return (size_t(y - m_part.y0) * size_t(m_part.width()) + size_t(x - m_part.x0)) *
               m_channels;
    }
    Rect m_part;
    size_t m_channels;
    Bits m_bits;
};

/// Neither mapping enlarges by that; both tell it, so that the correction's strength is no power of
/// two, by which contracted products would have the same bits.
constexpr Mapping::Scale told_scale{1.9, 1.95};

/// The whole picture, enlarged.
class Enlarged final : public Mapping {
public:
    Enlarged();
    Rect reach(double x0, double y0, double x1, double y1) const override {
        return m_mapping.reach(x0, y0, x1, y1);
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        m_mapping.row(y, x0, x1, positions, inside);
    }
    bool separable() const override { return true; }
    Scale scale() const override { return told_scale; }

private:
    ResizeMapping m_mapping;
};

/// Positions that form no grid, among them those of cells that the tile does not serve.
class Turned final : public Mapping {
public:
    Rect reach(double, double, double, double) const override { return {0, 0, 101, 83}; }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override;
    Scale scale() const override { return told_scale; }
};

/// The job that is checked in place of `job`. `clipped` and `start` are the job's own: where others
/// differ in them alone, each is checked.
Job job_to_check(const Job& job);

} // namespace ddt::gl
