// SPDX-License-Identifier: Apache-2.0
// The rounds of consistency (consistency.h), row by row.
#pragma once

#include <vector>

#include "core/surface/consistency/mean_rows.h"

namespace ddt {

/// What a group's vertices are corrected by.
struct CorrectionRecipe {
    Surface surface = Surface::patch;
    EdgeRecipe edges;
    int rounds = 1; ///< SurfaceOptions::consistency; one at least
    Correction correction = {};
    /// Lanes whose bit is set keep their source values: IDs are nothing to correct.
    unsigned kept_lanes = 0;
};

/// Makes one group's corrected values. A round is some rows ahead of the next, which asks it for
/// them.
class CorrectedRows : public ValueRows {
public:
    /// Start on the vertices that the edges in `part`, a part of the lattice in pixels, are made
    /// from; others keep the source's values. `source`: the group's, which must stay where they
    /// are.
    void begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
               const GroupValues& source);

    int count() const override { return m_source.count; }
    const float* row(int y) override { return m_rounds.back().row(y); }

    /// Rows of pixels from the one whose gradients the first of so many rounds makes to the one
    /// whose gradients are then made of the last one's values, in most tiles at most.
    static int usual_rows_ahead(int rounds);
    /// The same of a lattice.
    static int rows_ahead(const Lattice& lattice, int rounds);

    /// About the bytes that this takes of `count` channels where edges are of the usual length.
    static MemoryNeeded memory(int width, int height, int count, const CorrectionRecipe& recipe);

private:
    class Round : public ValueRows {
    public:
        /// To be called of all rounds before the first begins.
        void belong_to(CorrectedRows& all) { m_all = &all; }
        /// before: the round whose values are corrected; null: the source's are.
        void begin(const Rect& moved, Round* before);
        int count() const override { return m_all->m_source.count; }
        const float* row(int y) override;
        const Rect& part() const { return m_means.part(); }

    private:
        void correct();
        const float* source_row(int y);

        CorrectedRows* m_all = nullptr;
        MeanRows m_means;
        Rect m_moved;
        int m_rows = 0; ///< of them those above this one are done
        struct SourceRow {
            int y = -1;
            const float* row = nullptr;
            std::vector<float> copied; ///< of a source with more channels
        };
        SourceRow m_source_rows[3]; ///< row y at [y % 3]
        std::vector<float> m_row;   ///< what was made of the last row
    };

    const Lattice* m_lattice = nullptr;
    CorrectionRecipe m_recipe;
    GroupValues m_source;
    CrossedRows m_crossed; ///< the rounds'
    std::vector<Round> m_rounds;
};

} // namespace ddt
