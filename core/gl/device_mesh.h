// SPDX-License-Identifier: Apache-2.0
// Triangulation of several tiles at once on the device.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/gl/buffer.h"
#include "core/gl/gpu.h"
#include "core/gl/host_buffer.h"
#include "core/tiles/grid.h"
#include "core/triangulate/schemes.h"
#include "ddt/core.h"

namespace ddt::gl {

/// What one tile's share of each buffer is made for; the same for all tiles of a job.
struct SlotShape {
    int width = 0, height = 0; ///< pixels; no tile has more
    int stride() const { return 2 * width; }
    size_t pixels() const { return size_t(width) * size_t(height); }
    size_t sites() const { return size_t(stride()) * size_t(2 * height - 1); }
    size_t edges() const { return size_t(2 * width - 1) * size_t(2 * height - 1) - pixels(); }
    /// Bytes of a list of waiting edges, two words each, in which annealing has a word a site: more
    /// where pictures are two pixels wide.
    size_t waiting_bytes() const { return std::max(edges() * 8, sites() * 4); }
};

/// A tile within its slot: its sizes, both at least 2, and the pixels about the positions that it
/// serves, from the first to the last.
struct TileSize {
    int width = 0, height = 0;
    int served_x0 = 0, served_y0 = 0, served_x1 = 0, served_y1 = 0;
    int origin_x = 0, origin_y = 0; ///< its first pixel in the image (Workspace::origin_x)
};

/// The same of a tile, in a picture of this window, whose pixels were read as width x height.
TileSize size_in_slot(const Tile& tile, const Rect& window, int width, int height);

/// What an iteration did on one tile: gains computed, those that were enough, edges flipped,
/// candidates left waiting, flippable edges that a flip had touched, rounds of accepting and
/// rejecting. The layout of Counts in shaders/counts.glsl.
struct IterationCounts {
    uint32_t evaluated = 0, candidates = 0, selected = 0, blocked = 0, dirty = 0, rounds = 0;
};

/// How far those edges go, at most, that have an end beyond a side of what a tile serves: in x to
/// the left and right, in y above and below. The layout of shaders/counts.glsl.
struct Reach {
    uint32_t left = 1, upper = 1, right = 1, lower = 1; ///< of the starting mesh
};

/// What a DeviceMesh has a buffer of, in which each tile has a part.
enum class MeshPart {
    sites,
    encoded, ///< guides as they travel
    guide,
    contours,
    gain,
    list0,
    list1,
    blocked_even,
    blocked_odd,
    work,
    marks, ///< accept_reject.comp's, made where it is used
    count
};

enum class Step;

/// Iterations of one_round done by dispatches over all tiles; the rest by one group a tile
/// (finish.comp). By then a tile has at most a few thousand edges to look at, soon a few hundred: a
/// group goes over them about as often as three dispatches an iteration would wait (docs/gpu.md).
constexpr int dispatched_iterations = 16;

/// Meshes of up to `tiles` tiles. To be used on the context's thread; throws Failure.
class DeviceMesh {
public:
    DeviceMesh(Gpu& gpu, const SlotShape& shape, int tiles);

    /// Device memory a tile takes whose mesh is made so, and its largest part.
    static size_t bytes(const SlotShape& shape, const MeshOptions& options);
    static size_t largest_bytes(const SlotShape& shape);

    /// Which tiles are in the slots.
    void set_tiles(const std::vector<TileSize>& sizes);
    /// The guide of a slot's tile as encode_guide() made it, from `at` on in `from`, once
    /// set_tiles() has told the tile's size; returns the bytes. When all are written they are to be
    /// unpacked.
    size_t write_guide(int slot, const HostBuffer& from, size_t at, size_t bytes);
    void unpack_guides();
    /// A slot's mesh as it is: shape.sites() records as shaders have them, in rows of
    /// shape.stride(). Returns the bytes.
    size_t write_sites(int slot, const void* sites);

    /// Whether triangulate() knows the scheme; for others the finished mesh must be written.
    static bool knows(const MeshOptions& options);
    void triangulate(const MeshOptions& options);
    /// On the finished mesh: the gains of all edges, for soft ones; nothing to do where
    /// triangulate() keeps them. With contours the guide must have been written.
    void find_gains(const Criterion& by);
    /// Leave all iterations of one_round() but the first n to finish.comp, n >= 1, so many (even) a
    /// dispatch: else a check's small picture would be done before it comes to finish.comp.
    void finish_after(int n, int iterations_a_dispatch) {
        m_dispatched = n;
        m_iterations_a_dispatch = iterations_a_dispatch;
    }
    /// Have accept_reject.comp end a dispatch before its loops have turned so often, for the same
    /// reason.
    void pause_after(int turns_a_dispatch) { m_turns_a_dispatch = turns_a_dispatch; }
    const Buffer& gains() const { return m_gain; }

    /// Counts of each iteration of the last triangulate(), a slot, the first in place 1; in place 0
    /// what annealing left to chance, and behind it what came after. Waits for the device.
    std::vector<std::vector<IterationCounts>> read_counts();
    /// What the last triangulate() did, a slot, but for the pixels; waits for the device.
    std::vector<Statistics> read_statistics();
    /// How far edges go, a slot; waits for the device.
    std::vector<Reach> read_reach();
    /// A slot's mesh, and after find_gains() its gains, a site each; for comparisons.
    void read_sites(int slot, void* sites);
    void read_guide(int slot, float* guide);
    void read_gains(int slot, float* gains);

    /// Bind what lattice.glsl needs.
    void bind() const;
    const SlotShape& shape() const { return m_shape; }
    int tiles() const { return m_tiles; }

    /// One invocation a pixel or site of every tile, in groups of x times y.
    void dispatch_over(int width, int height, int group_x, int group_y);
    /// One a site, in groups of gains_group_x times gains_group_y.
    void dispatch_over_sites();

private:
    size_t bytes_of_all(MeshPart part) const; ///< tiles
    // The steps of triangulate(), in device_mesh_schemes.cpp.
    void set_criterion(const Criterion& by);
    void find_contours();
    void prepare_lists(const std::vector<Reach>& reach);
    void bind_lists();
    void start(const MeshOptions& options);
    void one_round();
    void accept_reject(const Rules& rules);
    void annealing(const MeshOptions& options);
    void anneal(uint64_t salt, uint64_t seed, float temperature);
    void step(const char* shader, int iteration, Step step, const std::string& defines);
    void use(const char* shader, int first_iteration, int last_iteration,
             const std::string& defines);
    void barrier(bool with_arguments = false);

    Gpu& m_gpu;
    const Functions& m_gl;
    SlotShape m_shape;
    int m_capacity;       ///< tiles
    int m_tiles = 0;      ///< in use
    int m_iterations = 0; ///< of the last triangulate(), at most
    int m_dispatched = dispatched_iterations;
    int m_iterations_a_dispatch = 0; ///< 0: as the device allows
    int m_turns_a_dispatch = 0;      ///< 0: as the device allows
    float m_min_gain = 0;
    std::string m_criterion; ///< the macros that choose it
    float m_contour_weight = 0;
    bool m_gains_known = false;
    std::vector<Statistics> m_before; ///< what annealing did before chance, a slot
    Buffer m_batch, m_sites, m_encoded, m_guide, m_contours, m_gain, m_list0, m_list1,
        m_blocked_even, m_blocked_odd, m_work;
    std::unique_ptr<Buffer> m_marks;
    const Buffer *m_from = &m_list0, *m_to = &m_list1; ///< in turn
};

} // namespace ddt::gl
