// SPDX-License-Identifier: Apache-2.0
#include "core/fill/hole_groups.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/fill/hole_pieces.h"

namespace ddt {

namespace {

/// Call `f` with the place of each pixel about the pixel i, itself among them, and whether it lies
/// in its row or column.
template <class F>
void each_about(size_t i, int width, int height, F&& f) {
    const int x = int(i % size_t(width)), y = int(i / size_t(width));
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
            f(size_t(v) * size_t(width) + size_t(u), u == x || v == y);
}

class Grouping {
public:
    Grouping(const uint8_t* missing, int width, int height)
        : m_missing(missing), m_width(width), m_height(height),
          m_seen(size_t(width) * size_t(height), 0), m_blocks_across(width / hole_block + 1),
          m_of_block(size_t(m_blocks_across) * size_t(height / hole_block + 1), none) {}

    std::vector<HoleGroup> groups() {
        for (size_t i = 0; i < m_seen.size(); ++i)
            if (m_missing[i] && !m_seen[i])
                add(group_of(hole_at(i), m_missing, m_width, m_height));
        for (HoleGroup& group : m_groups)
            std::sort(group.pixels.begin(), group.pixels.end());
        return std::move(m_groups);
    }

private:
    static constexpr size_t none = std::numeric_limits<size_t>::max();

    /// The hole with the pixel i, which nobody has seen.
    std::vector<size_t> hole_at(size_t i) {
        m_seen[i] = 1;
        std::vector<size_t> hole{i};
        for (size_t k = 0; k < hole.size(); ++k)
            each_about(hole[k], m_width, m_height, [&](size_t other, bool) {
                if (!m_missing[other] || m_seen[other])
                    return;
                m_seen[other] = 1;
                hole.push_back(other);
            });
        return hole;
    }

    void add(HoleGroup hole) {
        if (hole.box.width() > hole_block || hole.box.height() > hole_block) {
            std::vector<HoleGroup> pieces =
                cut_hole(std::move(hole), m_missing, m_width, m_height, m_seen);
            std::move(pieces.begin(), pieces.end(), std::back_inserter(m_groups));
            return;
        }
        size_t& group = m_of_block[size_t(hole.box.y0 / hole_block) * size_t(m_blocks_across) +
                                   size_t(hole.box.x0 / hole_block)];
        if (group == none) {
            group = m_groups.size();
            m_groups.push_back(std::move(hole));
            return;
        }
        HoleGroup& to = m_groups[group];
        to.box = {std::min(to.box.x0, hole.box.x0), std::min(to.box.y0, hole.box.y0),
                  std::max(to.box.x1, hole.box.x1), std::max(to.box.y1, hole.box.y1)};
        to.pixels.insert(to.pixels.end(), hole.pixels.begin(), hole.pixels.end());
        to.rim += hole.rim;
        to.deep |= hole.deep;
    }

    const uint8_t* m_missing;
    int m_width, m_height;
    std::vector<uint8_t> m_seen; ///< 0 where nothing is missing, or nobody was yet
    int m_blocks_across;
    std::vector<size_t> m_of_block; ///< the group of each block's small holes
    std::vector<HoleGroup> m_groups;
};

} // namespace

HoleGroup group_of(std::vector<size_t> pixels, const uint8_t* missing, int width, int height) {
    HoleGroup group;
    group.box = {width, height, 0, 0};
    for (const size_t i : pixels) {
        const int x = int(i % size_t(width)), y = int(i / size_t(width));
        group.box = {std::min(group.box.x0, x), std::min(group.box.y0, y),
                     std::max(group.box.x1, x + 1), std::max(group.box.y1, y + 1)};
        bool all = true;
        each_about(i, width, height, [&](size_t other, bool beside) {
            if (missing[other])
                return;
            all = false;
            group.rim += beside;
        });
        group.deep |= all;
    }
    group.pixels = std::move(pixels);
    return group;
}

std::vector<HoleGroup> group_holes(const uint8_t* missing, int width, int height) {
    return Grouping(missing, width, height).groups();
}

} // namespace ddt
