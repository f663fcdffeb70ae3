// SPDX-License-Identifier: Apache-2.0
// Flipping the edges of a Tin on the device.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "core/gl/annealing_uniforms.h"
#include "core/gl/buffer.h"
#include "core/gl/context/failure.h"
#include "core/gl/gpu.h"
#include "core/tin/face.h"
#include "core/tin/tin.h"
#include "core/triangulate/schemes.h"

namespace ddt::gl {

/// Flipping does not come to an end, as it does if the device computes right.
struct DoesNotEnd : Failure {
    using Failure::Failure;
};

/// A Tin's arrays on the device, and what the schemes know of its edges. To be used on the
/// context's thread, but triangulate() on any; throws Failure.
class DeviceTin {
public:
    /// Keeps a reference to `tin`, whose vertices are those of all meshes to come.
    DeviceTin(Gpu& gpu, const Tin& tin);

    /// Flip edges by a scheme that DeviceMesh::knows(). Adds to `statistics` as its C++ twin does.
    /// Its passes alone are on the context's thread: whoever is told of the progress may have the
    /// device do other things.
    void triangulate(const MeshOptions& options, const Workspace& workspace,
                     Statistics& statistics);
    /// Bring triangles and edges back.
    void read(Tin& tin) const;
    /// Bring the faces of all triangles and the gains of all edges, which were found last, back;
    /// the vectors have their sizes.
    void read_work(std::vector<TinFace>& faces, std::vector<float>& gains) const;

private:
    /// What one pass over the edges found; the layout of Counts in shaders/tin.glsl.
    struct Counts {
        uint32_t evaluated = 0, candidates = 0, waiting = 0, flipped = 0;
    };

    /// Run f on the context's thread.
    template <class F>
    auto there(F f) {
        return m_gpu.thread.post(std::move(f)).get();
    }
    Counts pass(const char* shader, size_t invocations, bool wide = false,
                const AnnealingUniforms* chance = nullptr);
    Counts pass_there(const char* shader, size_t invocations, bool wide,
                      const AnnealingUniforms* chance);
    /// What every program of shaders/tin.glsl needs, but for annealing.
    void bind() const;
    /// Without rules as one_round does.
    void flip_by(const std::optional<Rules>& rules, int iterations, const Workspace& workspace,
                 Statistics& statistics);
    void anneal(const MeshOptions& options, const Workspace& workspace, Statistics& statistics);
    void mark_all_dirty();

    Gpu& m_gpu;
    const Functions& m_gl;
    const Tin& m_tin;
    size_t m_triangles, m_edges;
    float m_pixel, m_min_gain = 0;
    bool m_by_gain = true;
    std::string m_cost; ///< the macro that chooses it
    Buffer m_vertex_buffer, m_triangle_buffer, m_edge_buffer, m_face_buffer, m_gain_buffer,
        m_mark_buffer, m_count_buffer;
    std::unique_ptr<Buffer> m_place_buffer, m_drawn_buffer; ///< annealing's
};

} // namespace ddt::gl
