// SPDX-License-Identifier: Apache-2.0
#include "core/fill/hole_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/points/points.h"
#include "core/tin/draw.h"

namespace ddt {

namespace {

/// Pixels that are there and no farther than this from a hole, along both axes, are in the mesh:
/// those that a hole's edges depend on, and a few that tell them where to go.
constexpr int margin = 6;

/// Meshes of a deep hole, of which the one that costs least is taken: across it there is nothing
/// that tells flips where to go. With 4 of them a quarter fewer pixels are wrong where a straight
/// edge is to run on across a hole of 4 x 4 to 15 x 15 than with 1.
constexpr int deep_starts = 4;

/// Of the time of a mesh, about.
constexpr float sweeps_share = 0.2f;

/// A box and what lies so near it, as far as there is an image.
Rect around(const Rect& box, int by, int width, int height) {
    return {std::max(box.x0 - by, 0), std::max(box.y0 - by, 0),
            box.x1 + std::min(by, width - box.x1), box.y1 + std::min(by, height - box.y1)};
}

} // namespace

HoleMesh::HoleMesh(const HoledImage& image, const float* guide, const uint8_t* missing,
                   const HoleGroup& group)
    : m_image(image), m_group(group),
      m_box(around(group.box, group.reach + margin, image.width, image.height)) {
    const std::vector<uint8_t> near = near_holes(missing);
    const auto channels = size_t(image.channels);
    // Or fewer: pixels of other holes may be near.
    const auto count = size_t(std::count(near.begin(), near.end(), uint8_t(1)));
    m_values.reserve((count - std::min(count, group.pixels.size())) * channels);
    for (int y = m_box.y0; y < m_box.y1; ++y)
        for (int x = m_box.x0; x < m_box.x1; ++x) {
            const size_t i = place(x, y);
            if (missing[i] || !near[local(i)])
                continue;
            m_mesh.x.push_back(x);
            m_mesh.y.push_back(y);
            m_guides.push_back(guide[i]);
            const float* values = image.values + i * channels;
            m_values.insert(m_values.end(), values, values + channels);
        }
}

/// A pixel's place in the box.
size_t HoleMesh::local(size_t pixel) const {
    const size_t x = pixel % size_t(m_image.width), y = pixel / size_t(m_image.width);
    return (y - size_t(m_box.y0)) * size_t(m_box.width()) + x - size_t(m_box.x0);
}

/// Of the box 1 at the pixels that the mesh is made for and within the margin of one along both
/// axes, else 0: the group's own pixels, and what is missing within their reach.
std::vector<uint8_t> HoleMesh::near_holes(const uint8_t* missing) const {
    std::vector<uint8_t> holes(m_box.area(), 0);
    for (const size_t pixel : m_group.pixels)
        holes[local(pixel)] = 1;
    if (m_group.reach > 0) {
        holes = widened(std::move(holes), m_group.reach);
        auto hole = holes.begin();
        for (int y = m_box.y0; y < m_box.y1; ++y)
            for (int x = m_box.x0; x < m_box.x1; ++x, ++hole)
                *hole &= missing[place(x, y)] != 0;
    }
    return widened(std::move(holes), margin);
}

/// Of the box 1 wherever there is one no farther than `by` along both axes: along rows, then
/// columns.
std::vector<uint8_t> HoleMesh::widened(std::vector<uint8_t> marks, int by) const {
    const auto width = size_t(m_box.width()), height = size_t(m_box.height()), far = size_t(by);
    std::vector<uint8_t> rows(m_box.area(), 0);
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0, done = 0; x < width; ++x) {
            if (!marks[y * width + x])
                continue;
            const size_t last = std::min(x + far, width - 1);
            for (done = std::max(done, x - std::min(x, far)); done <= last; ++done)
                rows[y * width + done] = 1;
        }
    marks.assign(m_box.area(), 0);
    for (size_t y = 0; y < height; ++y) {
        const size_t last = std::min(y + far, height - 1);
        for (size_t k = y - std::min(y, far); k <= last; ++k)
            for (size_t x = 0; x < width; ++x)
                marks[y * width + x] |= rows[k * width + x];
    }
    return marks;
}

/// Whether three of the points are not on one line.
bool HoleMesh::spans_plane() const {
    for (size_t i = 2; i < m_mesh.x.size(); ++i)
        if ((m_mesh.x[1] - m_mesh.x[0]) * (m_mesh.y[i] - m_mesh.y[0]) !=
            (m_mesh.y[1] - m_mesh.y[0]) * (m_mesh.x[i] - m_mesh.x[0]))
            return true;
    return false;
}

bool HoleMesh::make(const MeshOptions& options, Device device, const ProgressCallback& progress,
                    MeshReport* report, std::string& error) {
    if (m_mesh.x.size() > most_points) {
        error = "ddt: more than " + std::to_string(most_points) + " pixels lie about a hole";
        return false;
    }
    if (!spans_plane())
        return true;
    // Flips end in some local minimum, which depends on the start.
    const int starts = m_group.deep ? deep_starts : 1;
    MeshReport least;
    std::vector<std::array<int32_t, 3>> best;
    for (int start = 0; start < starts; ++start) {
        const float begin = float(start) / float(starts), end = float(start + 1) / float(starts),
                    flips = begin + (end - begin) * sweeps_share;
        MeshReport made; // which takes going through the mesh twice
        MeshReport* wanted = report || starts > 1 ? &made : nullptr;
        if (!delaunay_points(m_mesh, {m_guides.data(), uint32_t(start)}, error,
                             part_of(progress, begin, flips)) ||
            !optimise_points(m_mesh, m_guides.data(), options, wanted, error,
                             part_of(progress, flips, end), device))
            return false;
        if (start == 0 || made.cost < least.cost) {
            least = made;
            best.swap(m_mesh.triangles);
        }
    }
    m_mesh.triangles = std::move(best);
    if (report)
        *report = least;
    return true;
}

float HoleMesh::value(size_t channel, const std::array<int32_t, 3>& triangle,
                      const Covered& covered) const {
    const auto channels = size_t(m_image.channels);
    const auto at_corner = [&](size_t k) {
        return m_values[size_t(triangle[k]) * channels + channel];
    };
    const auto heaviest =
        size_t(std::max_element(covered.weight, covered.weight + 3) - covered.weight);
    if (m_image.kinds && m_image.kinds[channel] == Channel::nearest)
        return at_corner(heaviest);
    const float all = value_at(m_values.data(), int(channels), int(channel), triangle, covered);
    if (std::isfinite(all))
        return all;
    // A share of an infinity is one: the others count alone.
    double sum = 0, weights = 0;
    for (size_t k = 0; k < 3; ++k) {
        const float v = at_corner(k);
        if (covered.weight[k] == 0 || !std::isfinite(v))
            continue;
        sum += covered.weight[k] * double(v);
        weights += covered.weight[k];
    }
    return weights > 0 ? float(sum / weights) : at_corner(heaviest);
}

bool HoleMesh::fill(float* surface, uint8_t* inside, std::string& error) const {
    if (m_mesh.triangles.empty())
        return true;
    std::vector<uint8_t> own(m_box.area(), 0), covered_by(m_box.area());
    for (const size_t pixel : m_group.pixels)
        own[local(pixel)] = 1;
    const PixelGrid grid{double(m_box.x0), double(m_box.y0), 1, 1, m_box.width(), m_box.height()};
    const auto channels = size_t(m_image.channels);
    return each_pixel(m_mesh, grid, covered_by.data(), error,
                      [&](const std::array<int32_t, 3>& triangle, const Covered& covered) {
                          if (!own[covered.pixel])
                              return;
                          const auto width = size_t(m_box.width());
                          const size_t i = place(m_box.x0 + int(covered.pixel % width),
                                                 m_box.y0 + int(covered.pixel / width));
                          for (size_t c = 0; c < channels; ++c)
                              m_image.values[i * channels + c] = value(c, triangle, covered);
                          surface[i] = value_at(m_guides.data(), 1, 0, triangle, covered);
                          inside[i] = 1;
                      });
}

} // namespace ddt
