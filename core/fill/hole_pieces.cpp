// SPDX-License-Identifier: Apache-2.0
#include "core/fill/hole_pieces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ddt {

namespace {

/// Of the first cut; and of the last, whose thickness a byte still holds.
constexpr int first_block = 128, last_block = 2048;

/// A part is thick with more pixels than a block's size divided by this to the nearest that is
/// there.
constexpr int thickness_share = 16;

/// Numbers 0 to n - 1, each at first a set of its own.
class DisjointSets {
public:
    explicit DisjointSets(size_t n) : m_parent(n) {
        std::iota(m_parent.begin(), m_parent.end(), size_t(0));
    }

    size_t find(size_t i) {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }

    void join(size_t a, size_t b) { m_parent[find(a)] = find(b); }

private:
    std::vector<size_t> m_parent;
};

class Cutter {
public:
    Cutter(const uint8_t* missing, int width, int height, std::vector<uint8_t>& depth)
        : m_missing(missing), m_width(width), m_height(height), m_depth(depth) {}

    /// Steps along both axes to the nearest pixel that is there, at most 255: the distance
    /// transform of the chessboard in two passes (Rosenfeld & Pfaltz 1968). `pixels`: row by row.
    void measure(const std::vector<size_t>& pixels) {
        for (const size_t i : pixels)
            m_depth[i] = 255;
        const auto pass = [&](size_t i, int way) {
            const int x = int(i % size_t(m_width)), y = int(i / size_t(m_width));
            nearer(i, x - way, y);
            for (int u = x - 1; u <= x + 1; ++u)
                nearer(i, u, y - way);
        };
        std::for_each(pixels.begin(), pixels.end(), [&](size_t i) { pass(i, 1); });
        std::for_each(pixels.rbegin(), pixels.rend(), [&](size_t i) { pass(i, -1); });
    }

    /// Cut into blocks of at most this size, the order of pixels kept.
    void cut(HoleGroup whole, int block) {
        const int across = parts(whole.box.width(), block), down = parts(whole.box.height(), block);
        if (block > last_block || across * down == 1) {
            m_pieces.push_back(std::move(whole));
            return;
        }
        const std::vector<int> column = places(whole.box.width(), across),
                               row = places(whole.box.height(), down);
        const auto block_at = [&](int64_t x, int64_t y) {
            const auto u = size_t(std::clamp<int64_t>(x - whole.box.x0, 0, column.size() - 1)),
                       v = size_t(std::clamp<int64_t>(y - whole.box.y0, 0, row.size() - 1));
            return size_t(row[v]) * size_t(across) + size_t(column[u]);
        };
        const int thickness = block / thickness_share, near = 2 * thickness;
        DisjointSets sets(size_t(across) * size_t(down));
        for (const size_t i : whole.pixels) {
            if (m_depth[i] <= thickness)
                continue;
            const auto x = int64_t(i % size_t(m_width)), y = int64_t(i / size_t(m_width));
            const size_t own = block_at(x, y);
            for (const int64_t v : {y - near, y + near})
                for (const int64_t u : {x - near, x + near})
                    sets.join(own, block_at(u, v));
        }
        std::vector<std::vector<size_t>> piece(size_t(across) * size_t(down));
        for (const size_t i : whole.pixels) {
            const auto x = int64_t(i % size_t(m_width)), y = int64_t(i / size_t(m_width));
            piece[sets.find(block_at(x, y))].push_back(i);
        }
        const size_t all = std::exchange(whole.pixels, {}).size();
        for (std::vector<size_t>& pixels : piece) {
            if (pixels.empty())
                continue;
            if (pixels.size() == all) {
                whole.pixels = std::move(pixels);
                return cut(std::move(whole), 2 * block);
            }
            HoleGroup part = group_of(std::move(pixels), m_missing, m_width, m_height);
            part.reach = near;
            cut(std::move(part), 2 * block);
        }
    }

    std::vector<HoleGroup> pieces() { return std::move(m_pieces); }

private:
    static int parts(int size, int block) { return (size - 1) / block + 1; }

    /// Of so many places in a row, which of so many equal parts each lies in.
    static std::vector<int> places(int size, int parts) {
        std::vector<int> part(static_cast<size_t>(size));
        for (int i = 0; i < size; ++i)
            part[size_t(i)] = int(int64_t(i) * parts / size);
        return part;
    }

    void nearer(size_t i, int x, int y) {
        if (x < 0 || x >= m_width || y < 0 || y >= m_height)
            return;
        const int steps = m_depth[size_t(y) * size_t(m_width) + size_t(x)] + 1;
        m_depth[i] = uint8_t(std::min(int(m_depth[i]), steps));
    }

    const uint8_t* m_missing;
    int m_width, m_height;
    std::vector<uint8_t>& m_depth;
    std::vector<HoleGroup> m_pieces;
};

} // namespace

std::vector<HoleGroup> cut_hole(HoleGroup hole, const uint8_t* missing, int width, int height,
                                std::vector<uint8_t>& depth) {
    std::sort(hole.pixels.begin(), hole.pixels.end());
    Cutter cutter(missing, width, height, depth);
    cutter.measure(hole.pixels);
    cutter.cut(std::move(hole), first_block);
    return cutter.pieces();
}

} // namespace ddt
