// SPDX-License-Identifier: Apache-2.0
// The rounds of consistency (consistency.h), row by row.
#pragma once

#include <vector>

#include "core/surface/mean_rows.h"

namespace ddt {

/// What a group's vertices are corrected by.
struct CorrectionRecipe {
    Surface surface = Surface::patch;
    EdgeRecipe edges;
    /// SurfaceOptions::consistency, limit and clipped; one round at least.
    int rounds = 1;
    float limit = 0;
    bool clipped = false;
    /// Lanes whose bit is set keep their source values: identifiers are nothing to correct.
    unsigned kept_lanes = 0;
};

/// Corrects one group's vertices, from the top row downwards. A round is some rows ahead of the
/// next.
class CorrectedRows {
public:
    /// Start on the vertices that the edges in `part`, a part of the lattice in pixels, are made
    /// from. `source`: the group's values; `values`: a copy of the pixels they are of, in which the
    /// corrected ones will take their place. Both must stay where they are. strict: Net::strict.
    void begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
               const GroupValues& source, float* values, const float* strict);

    /// Correct the rows of pixels before `end`, as far as they are not.
    void to_row(int end) { make(m_recipe.rounds - 1, end); }

    /// About the bytes that this takes where edges are of the usual length.
    static size_t memory(int width, int height, int channels, const CorrectionRecipe& recipe);

private:
    struct Round {
        MeanRows means;
        Rect moved;
        int rows; ///< those above this one are done
        /// The source's rows round the next one, group_size floats a pixel.
        std::vector<float> near;
    };
    void make(int round, int end);
    void make_row(Round& round);
    const float* source_near(Round& round) const;

    const Lattice* m_lattice = nullptr;
    CorrectionRecipe m_recipe;
    GroupValues m_source;
    float* m_values = nullptr;
    LaneLimits m_limits;
    LimitRow m_limit_row;
    std::vector<float> m_moved; ///< a row of vertices
    std::vector<Round> m_rounds;
};

} // namespace ddt
