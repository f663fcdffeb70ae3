// SPDX-License-Identifier: Apache-2.0
// Meshes of any points: scattered samples, meshes that somebody has, what is left of an image with
// holes.
//
// The costs and schemes are those of MeshOptions (ddt/options.h); lengths are measured in a unit in
// which a mesh's triangles have the mean area 1/2, as those of an image have in pixels. Functions
// return false where they fail; `error` is that of ddt/core.h. No buffer may be null where nothing
// says that it may. Functions may be called from several threads at once for different meshes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ddt/mesh.h"

namespace ddt {

/// Points in the plane and triangles of them, as indices of points.
struct PointMesh {
    std::vector<double> x, y;
    std::vector<std::array<int32_t, 3>> triangles;
};

/// No mesh has more points.
constexpr size_t most_points = size_t(1) << 27;

/// Make mesh.triangles: the Delaunay triangulation of the points, which covers their convex hull,
/// by exact arithmetic, whatever shape they have together. Positions are rounded to 2^-29 of the
/// points' extent, the larger of both axes', or finer. Of points at one position the first is used.
/// False if there are not three that are then not on one line, or a position is not finite. After a
/// failure the mesh is as it was.
bool delaunay(PointMesh& mesh, std::string* error = nullptr,
              const ProgressCallback& progress = {}) noexcept;

/// Flip edges of the mesh's triangles, which together may have any shape, by options.scheme and
/// options.cost (blur, contour, meshes and start may be anything and mean nothing here). `guide`:
/// one float per point, about 0 to 1; what is below 2^-24 or not finite counts as 0. Triangles come
/// out with the orientation from x towards y. False also where the triangles are no triangulation:
/// one without area, an edge of more than two; and where a `device` that is named cannot be had.
/// lawson and look_ahead run on the CPU whatever is named, the others on GPUs too; no choice
/// changes the result. Positions are rounded as delaunay() does; where all points span more than
/// four times what the triangles' corners do, to 2^-29 of what these span, unless they lie over one
/// another so. After a failure the mesh is as it was.
bool optimise(PointMesh& mesh, const float* guide, const MeshOptions& options,
              MeshReport* report = nullptr, std::string* error = nullptr,
              const ProgressCallback& progress = {}, Device device = Device::automatic) noexcept;

/// Pixels laid over the plane: pixel (i, j) shows the point (x + i * step_x, y + j * step_y). A
/// negative step_y is for files whose y goes upwards.
struct PixelGrid {
    double x = 0, y = 0;
    double step_x = 1, step_y = 1; ///< not 0
    int width = 0, height = 0;
};

/// Interpolate linearly over the mesh's triangles, at positions that are rounded as optimise()
/// rounds points': pixels closer together show steps. `values` are `channels` floats per point,
/// `pixels` as many per pixel, row by row. Pixels outside all triangles are left as they are;
/// `inside`, one byte per pixel, tells where those are: 0 there, else not 0. A pixel on an edge
/// belongs to one triangle, whichever order the triangles have. Of a grid without pixels both may
/// be null. After a failure `pixels` and `inside` are as they were.
bool draw(const PointMesh& mesh, const float* values, int channels, const PixelGrid& grid,
          float* pixels, uint8_t* inside, std::string* error = nullptr) noexcept;

/// Fill the pixels of an image whose byte in `missing` is not 0: meshes of those near the holes are
/// made, on all threads, their edges flipped by `options`, and holes interpolated over their
/// triangles, so that edges run on across them; more than a pixel within a hole what they give is
/// smoothed where it has no edges. Small holes share meshes, by blocks of 64 x 64 pixels; a larger
/// one has its own, or where it is thin several. What lies outside all triangles, beyond the
/// outermost pixels that are there, gets the value of the nearest. Infinities are no part of what
/// others beside them give. `values`: `channels` floats per pixel; `kinds`: one per channel, or
/// null if all are Channel::blend; `guide`: one float per pixel, not looked at where one is
/// missing; what is below 2^-24 or not finite counts as 0. Nothing is done if nothing is
/// missing; false if all is. Being cancelled leaves the missing pixels as anything.
bool fill_holes(float* values, int width, int height, int channels, const Channel* kinds,
                const float* guide, const uint8_t* missing, const MeshOptions& options,
                std::string* error = nullptr, const ProgressCallback& progress = {}) noexcept;

} // namespace ddt
