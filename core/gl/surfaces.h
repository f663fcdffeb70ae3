// The surfaces over the meshes of several tiles, and reading them.
#pragma once

#include <memory>
#include <vector>

#include "core/gl/mesh.h"

namespace ddt::gl {

/// Channels worked on together.
constexpr int channels_a_group = 4;


/// Positions to read one tile's surface at.
struct SamplePlan {
    int slot = 0;
    /// Separable: columns x rows positions, the x at x[column], the y at y[row]; else `count`
    /// positions, x and y by turns in `points`.
    bool separable = true;
    int columns = 0, rows = 0;
    int first_x = 0, first_y = 0; ///< separable: where in the positions the x and the y begin
    int count = 0;                ///< positions in all
};

/// Values and gradients of all tiles of a Mesh. To be used on the context's thread; throws Failure.
class Surfaces {
public:
    Surfaces(Gpu& gpu, const SlotShape& shape, int tiles, int groups, Surface surface);

    static size_t bytes(const SlotShape& shape, int groups, Surface surface);
    static size_t largest_bytes(const SlotShape& shape, Surface surface);

    /// A slot's values of one group: shape.pixels() x 4 floats in rows of shape.width.
    void write_values(int slot, int group, const float* values);
    /// After the mesh is finished.
    void make(Mesh& mesh);

    /// The positions that plans refer to.
    void write_positions(const std::vector<int32_t>& positions);
    /// Dispatch the reading of the surface: `channels` floats a position into result().
    void sample(Mesh& mesh, const SamplePlan& plan, int channels,
                const std::vector<unsigned>& nearest);
    /// Copy what the last sample() made; waits for the device.
    void read_result(size_t floats, float* out);

private:
    struct Group {
        Buffer values, gradients;
    };
    void reserve(std::unique_ptr<Buffer>& buffer, size_t bytes);

    Gpu& m_gpu;
    const Functions& m_gl;
    SlotShape m_shape;
    Surface m_surface;
    std::vector<std::unique_ptr<Group>> m_groups;
    std::unique_ptr<Buffer> m_positions, m_result;
};

} // namespace ddt::gl
