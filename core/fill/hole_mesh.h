// SPDX-License-Identifier: Apache-2.0
// The mesh that a group of holes is filled over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/fill/fill.h"
#include "core/fill/hole_groups.h"

namespace ddt {

struct Covered;

/// The pixels that are there about a group's holes, and triangles of them.
class HoleMesh {
public:
    /// guide: the image's, cleaned (clean_guide()); of pixels that are not missing.
    HoleMesh(const HoledImage& image, const float* guide, const uint8_t* missing,
             const HoleGroup& group);

    /// Triangulate and flip edges. Nothing is made, and fill() does nothing, where the pixels lie
    /// on one line. False with one line in `error`. May throw.
    bool make(const MeshOptions& options, Device device, const ProgressCallback& progress,
              MeshReport* report, std::string& error);

    /// Give those of the group's pixels that a triangle covers their values, in `surface` that of
    /// the guide, and a 1 in `inside`; the last two are whole images. Nothing else is written, and
    /// nothing that is missing read: meshes of other groups may be filled at the same time.
    bool fill(float* surface, uint8_t* inside, std::string& error) const;

private:
    size_t place(int x, int y) const { return size_t(y) * size_t(m_image.width) + size_t(x); }
    size_t local(size_t pixel) const;
    std::vector<uint8_t> near_holes(const uint8_t* missing) const;
    std::vector<uint8_t> widened(std::vector<uint8_t> marks, int by) const;
    bool spans_plane() const;
    float value(size_t channel, const std::array<int32_t, 3>& triangle,
                const Covered& covered) const;

    const HoledImage& m_image;
    const HoleGroup& m_group;
    Rect m_box; ///< the group's, and what its mesh reaches
    PointMesh m_mesh;
    std::vector<float> m_guides; ///< a point
    std::vector<float> m_values; ///< the points', of all channels
};

} // namespace ddt
