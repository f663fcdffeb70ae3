// SPDX-License-Identifier: Apache-2.0
// Which tile is begun next, and by whom.
#pragma once

#include <algorithm>
#include <vector>

namespace ddt {

/// Tiles are begun in order, from the first. On a machine with several nodes of memory the threads
/// of each node have a run of neighbouring tiles of their own: what they read and write lies
/// together, and the system puts a result's pages on the node that writes them first. The number of
/// nodes need not be known: the first node that asks gets all tiles; a node without tiles gets the
/// second half of the longest run that another node has left, cut between rows of tiles where it
/// can be.
class TileOrder {
public:
    TileOrder(int tiles, int columns) : m_columns(columns), m_shares{{nobody, 0, tiles}} {}

    bool empty() const {
        return std::all_of(m_shares.begin(), m_shares.end(),
                           [](const Share& r) { return r.left() == 0; });
    }

    /// The next tile for threads of a node (a number of at least 0); not if empty().
    int next(int node) { return share_of(node).begin++; }

private:
    static constexpr int nobody = -1;
    struct Share {
        int node, begin, end;
        int left() const { return end - begin; }
    };

    /// A node's share, with tiles in it.
    Share& share_of(int node) {
        const auto own = std::find_if(m_shares.begin(), m_shares.end(),
                                      [&](const Share& r) { return r.node == node; });
        if (own != m_shares.end() && own->left() > 0)
            return *own;
        Share& longest =
            *std::max_element(m_shares.begin(), m_shares.end(),
                              [](const Share& a, const Share& b) { return a.left() < b.left(); });
        if (longest.node == nobody) {
            longest.node = node;
            return longest;
        }
        const Share half{node, middle(longest), longest.end};
        longest.end = half.begin;
        if (own != m_shares.end())
            return *own = half;
        m_shares.push_back(half);
        return m_shares.back();
    }

    /// Where a share with tiles in it is cut; what follows has tiles too.
    int middle(const Share& share) const {
        const int half = share.begin + share.left() / 2, row = half - half % m_columns;
        return row > share.begin ? row : half;
    }

    const int m_columns;
    std::vector<Share> m_shares; ///< one a node
};

} // namespace ddt
