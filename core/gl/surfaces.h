// SPDX-License-Identifier: Apache-2.0
// The surfaces over the meshes of several tiles, and reading them.
#pragma once

#include <memory>
#include <vector>

#include "core/gl/device_mesh.h"
#include "core/gl/host_buffer.h"
#include "core/gl/transfer.h"

namespace ddt::gl {

/// A job's channels, in groups of group_size.
struct GroupKinds {
    unsigned nearest = 0, bounded = 0; ///< a bit a lane: Channel::nearest, bounded_channels()
};

/// Positions to read one tile's surface at.
struct SamplePlan {
    int slot = 0;
    /// Slots from that one on which hold as many meshes of the tile: their surfaces are averaged.
    int meshes = 1;
    /// Separable: columns x rows positions, of which the x of the columns and then the y of the
    /// rows are there; else `count` positions, x and y by turns.
    bool separable = true;
    int columns = 0, rows = 0;
    int count = 0; ///< positions in all
};

/// Where positions are read from and results go: what is under way needs one of its own. To be
/// destroyed on the context's thread.
struct SampleMemory {
    std::unique_ptr<Buffer> positions, results, packed;
    std::unique_ptr<HostBuffer> sent; ///< positions, on their way
};

/// Values and gradients of all tiles of a DeviceMesh. To be used on the context's thread; throws
/// Failure.
class Surfaces {
public:
    /// strength: correction_strength() of core/surface/corrections.h.
    Surfaces(Gpu& gpu, const SlotShape& shape, int tiles, const std::vector<GroupKinds>& groups,
             const SurfaceOptions& options, float strength);

    /// Device memory a tile takes, and the largest single buffer of it.
    static size_t bytes(const SlotShape& shape, size_t groups, const SurfaceOptions& options);
    static size_t largest_bytes(const SlotShape& shape, const SurfaceOptions& options);

    /// What the numbers of the slots' tiles are, each of which takes `meshes` slots. To be called
    /// before anything below.
    void expect(const Numbers& numbers, int channels, int meshes);
    /// Have a tile's numbers, from `at` on in `from`, copied to the device; returns the bytes.
    size_t write_numbers(int tile, const TileSize& size, const HostBuffer& from, size_t at);
    /// Make the values of all slots from what was written.
    void unpack(DeviceMesh& mesh);
    /// After the mesh is finished; `by` is what it was made by.
    void make(DeviceMesh& mesh, const Criterion& by);

    // What make() left, for comparisons: a group's vertices, and their gradients where there are
    // some; and binding them all as net.glsl wants it.
    const Buffer& vertices(int group) const { return *m_groups[size_t(group)].values; }
    const Buffer& gradients(int group) const { return *m_groups[size_t(group)].gradients; }
    void bind_net(const DeviceMesh& mesh, int group);

    /// Make room for a plan's coordinates of positions and numbers of results, so many, if there is
    /// none. Throws OutOfMemory.
    void make_room(size_t coordinates, size_t numbers, const Transfer& transfer,
                   SampleMemory& memory);
    /// The positions that a plan refers to, for which there must be room.
    void write_positions(const std::vector<int32_t>& positions, SampleMemory& memory);
    /// Dispatch the reading of the surface, for whose results there must be room: a float a channel
    /// and position.
    void sample(DeviceMesh& mesh, const SamplePlan& plan, const SampleMemory& memory);
    /// Have so many results, from the first on, copied to `to` as they travel: there when a Fence
    /// has passed. Returns the bytes.
    size_t download(size_t count, const Transfer& transfer, SampleMemory& memory, HostBuffer& to);

private:
    struct Group {
        GroupKinds kinds;
        std::unique_ptr<Buffer> source;       ///< values as they were read
        std::unique_ptr<Buffer> corrected[2]; ///< by consistency rounds, in turn
        std::unique_ptr<Buffer> gradients;
        std::unique_ptr<Buffer> bends;  ///< fitted ones, of edges; at vertices their indices
        const Buffer* values = nullptr; ///< what the surface goes through now
    };
    bool fitted() const { return m_table != nullptr; }
    const Buffer& edges_of(const Group& group) const {
        return fitted() ? *group.bends : *group.gradients;
    }
    void bind_net(const DeviceMesh& mesh, const Group& group, const Buffer& edges);
    /// margin: how far about the positions that tiles serve something is made, in edges' lengths.
    void find_gradients(DeviceMesh& mesh, const Group& group, int margin);
    void correct(DeviceMesh& mesh, Group& group, int round, int margin);
    void fit(DeviceMesh& mesh, Group& group);
    bool has_edges() const { return m_edges != nullptr; }
    void find_edges(DeviceMesh& mesh, const Group& group, int margin);
    void bend_edges(DeviceMesh& mesh, const Group& group, int margin);
    void pack(size_t count, const Transfer& transfer, SampleMemory& memory);
    void set_channels(int group) const;
    size_t tile_bytes() const; ///< of its numbers
    void reserve(std::unique_ptr<Buffer>& buffer, size_t bytes);
    void sample_mesh(DeviceMesh& mesh, const SamplePlan& plan, int index,
                     const SampleMemory& memory);

    Gpu& m_gpu;
    const Functions& m_gl;
    SlotShape m_shape;
    int m_slots;
    SurfaceOptions m_options;
    float m_strength;
    std::vector<Group> m_groups;
    Numbers m_expected;
    int m_channels = 0, m_meshes = 1;
    std::unique_ptr<Buffer> m_numbers, m_codes; ///< as they travel; what codes stand for
    std::unique_ptr<Buffer> m_code_table;       ///< CodeTable::entries
    std::unique_ptr<Buffer> m_table;            ///< FittedTable, if the surface is fitted
    std::unique_ptr<Buffer> m_edges; ///< by net_edges.comp, of the group that is corrected
};

} // namespace ddt::gl
