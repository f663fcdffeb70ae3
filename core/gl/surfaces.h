// SPDX-License-Identifier: Apache-2.0
// The surfaces over the meshes of several tiles, and reading them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/gl/device_mesh.h"

namespace ddt::gl {

/// A job's channels, in groups of group_size.
struct GroupKinds {
    unsigned nearest = 0, strict = 0; ///< a bit a lane: Channel::nearest, is_strict()
};

/// Positions to read one tile's surface at.
struct SamplePlan {
    int slot = 0;
    /// Slots from that one on which hold as many meshes of the tile: their surfaces are averaged.
    int meshes = 1;
    /// Separable: columns x rows positions, the x at x[column], the y at y[row]; else `count`
    /// positions, x and y by turns in `points`.
    bool separable = true;
    int columns = 0, rows = 0;
    int first_x = 0, first_y = 0; ///< separable: where in the positions the x and the y begin
    int count = 0;                ///< positions in all
    int first_result = 0;         ///< where in the results they begin
};

/// Values and gradients of all tiles of a DeviceMesh. To be used on the context's thread; throws
/// Failure.
class Surfaces {
public:
    Surfaces(Gpu& gpu, const SlotShape& shape, int tiles, const std::vector<GroupKinds>& groups,
             const SurfaceOptions& options);

    /// Device memory a tile takes, and the largest single buffer of it.
    static size_t bytes(const SlotShape& shape, size_t groups, const SurfaceOptions& options);
    static size_t largest_bytes(const SlotShape& shape, const SurfaceOptions& options);

    /// A slot's values of one group: shape.pixels() x group_size floats in rows of shape.width.
    void write_values(int slot, int group, const float* values);
    /// After the mesh is finished; `cost` is what it was made with.
    void make(DeviceMesh& mesh, const Criterion& by);

    // What make() left, for comparisons: a group's vertices, and their gradients where there are
    // some; the macros of programs that use them, and binding them all as net.glsl wants it.
    const Buffer& vertices(int group) const { return *m_groups[size_t(group)].values; }
    const Buffer& gradients(int group) const { return *m_groups[size_t(group)].gradients; }
    std::string defines() const;
    void bind_net(const DeviceMesh& mesh, int group);

    /// The positions that plans refer to.
    void write_positions(const std::vector<int32_t>& positions);
    /// Room for the results of plans that are sampled before anything is read back.
    void reserve_results(size_t positions, int channels);
    /// Dispatch the reading of the surface: `channels` floats a position. Results of earlier plans
    /// stay if there was room.
    void sample(DeviceMesh& mesh, const SamplePlan& plan, int channels);
    /// Copy results from the first on; waits for the device.
    void read_result(size_t bytes, void* out);

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
    void find_gradients(DeviceMesh& mesh, const Group& group, int margin,
                        const std::string& defines = "");
    void correct(DeviceMesh& mesh, Group& group, int round, int margin,
                 const std::string& more = "");
    void fit(DeviceMesh& mesh, Group& group);
    void reserve(std::unique_ptr<Buffer>& buffer, size_t bytes);
    void sample_mesh(DeviceMesh& mesh, const SamplePlan& plan, int channels, int index);

    Gpu& m_gpu;
    const Functions& m_gl;
    SlotShape m_shape;
    SurfaceOptions m_options;
    std::vector<Group> m_groups;
    std::unique_ptr<Buffer> m_positions, m_result;
    std::unique_ptr<Buffer> m_table; ///< FittedTable, if the surface is fitted
};

} // namespace ddt::gl
