// SPDX-License-Identifier: Apache-2.0
#include "core/enlarge/hole_groups.h"

#include <algorithm>
#include <limits>

namespace ddt {

namespace {

class Grouping {
public:
    Grouping(const uint8_t* missing, int width, int height)
        : m_missing(missing), m_width(width), m_height(height),
          m_seen(size_t(width) * size_t(height), 0), m_blocks_across(width / hole_block + 1),
          m_of_block(size_t(m_blocks_across) * size_t(height / hole_block + 1), none) {}

    std::vector<HoleGroup> groups() {
        for (size_t i = 0; i < m_seen.size(); ++i)
            if (m_missing[i] && !m_seen[i])
                add(hole_at(i));
        for (HoleGroup& group : m_groups)
            std::sort(group.pixels.begin(), group.pixels.end());
        return std::move(m_groups);
    }

private:
    static constexpr size_t none = std::numeric_limits<size_t>::max();

    /// The hole with the pixel i, which nobody has seen.
    HoleGroup hole_at(size_t i) {
        HoleGroup hole;
        hole.box = {m_width, m_height, 0, 0};
        m_seen[i] = 1;
        hole.pixels.push_back(i);
        for (size_t k = 0; k < hole.pixels.size(); ++k)
            look_around(hole.pixels[k], hole);
        return hole;
    }

    void look_around(size_t i, HoleGroup& hole) {
        const int x = int(i % size_t(m_width)), y = int(i / size_t(m_width));
        hole.box = {std::min(hole.box.x0, x), std::min(hole.box.y0, y),
                    std::max(hole.box.x1, x + 1), std::max(hole.box.y1, y + 1)};
        bool all = true;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, m_height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, m_width - 1); ++u) {
                const size_t other = size_t(v) * size_t(m_width) + size_t(u);
                if (!m_missing[other]) {
                    all = false;
                    hole.rim += u == x || v == y;
                } else if (!m_seen[other]) {
                    m_seen[other] = 1;
                    hole.pixels.push_back(other);
                }
            }
        hole.deep |= all;
    }

    void add(HoleGroup hole) {
        if (hole.box.width() > hole_block || hole.box.height() > hole_block) {
            m_groups.push_back(std::move(hole));
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
    std::vector<uint8_t> m_seen;
    int m_blocks_across;
    std::vector<size_t> m_of_block; ///< the group of each block's small holes
    std::vector<HoleGroup> m_groups;
};

} // namespace

std::vector<HoleGroup> group_holes(const uint8_t* missing, int width, int height) {
    return Grouping(missing, width, height).groups();
}

} // namespace ddt
