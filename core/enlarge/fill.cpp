// SPDX-License-Identifier: Apache-2.0
// Filling holes of images.
#include <algorithm>
#include <deque>

#include "core/base/arith.h"
#include "core/base/guarded.h"
#include "core/enlarge/fill.h"
#include "core/enlarge/membrane.h"
#include "core/enlarge/points.h"
#include "core/tin/draw.h"

namespace ddt {

namespace {

/// Pixels that are there and no farther than this from a hole, along both axes, are in the mesh:
/// those that a hole's edges depend on, and a few that tell them where to go.
constexpr int margin = 6;

/// Microseconds of one thread, about, that the mesh takes a point and smoothing a missing pixel:
/// what shares of progress are taken from.
constexpr float mesh_time = 10, flips_time = 1, smoothing_time = 7;

class Filler {
public:
    Filler(const HoledImage& image, const uint8_t* missing)
        : m_image(image), m_width(image.width), m_height(image.height),
          m_channels(size_t(image.channels)), m_missing(missing) {}

    bool fill(const MeshOptions& options, Device device, const Tell& progress, MeshReport* report,
              std::string& error) {
        const size_t size = size_t(m_width) * size_t(m_height);
        const auto count = size_t(std::count_if(m_missing, m_missing + size, is_set));
        if (count == 0)
            return true;
        if (count == size) {
            error = "ddt: no pixel is there to fill the others from";
            return false;
        }
        collect();
        const auto points = float(m_mesh.x.size());
        const float all = points * (mesh_time + flips_time) + float(count) * smoothing_time;
        const float flips_begin = points * mesh_time / all,
                    smoothing_begins = points * (mesh_time + flips_time) / all;
        const Tell meshing = part_of(progress, 0, flips_begin);
        const Tell flipping = part_of(progress, flips_begin, smoothing_begins);
        const Tell smoothing = part_of(progress, smoothing_begins, 1);
        if (m_mesh.x.size() > most_points) {
            error = "ddt: more than " + std::to_string(most_points) + " pixels lie about the holes";
            return false;
        }
        m_surface.assign(m_image.guide, m_image.guide + size);
        std::vector<uint8_t> inside(size, 0);
        if (spans_plane() &&
            !(tell(meshing, 0, error) && triangulate_points(m_mesh, error) &&
              tell(meshing, 1, error) &&
              optimise_points(m_mesh, m_guides.data(), options, report, error, flipping, device) &&
              interpolate(inside.data(), error)))
            return false;
        if (!smooth(inside, smoothing)) {
            error = "ddt: cancelled";
            return false;
        }
        spread(inside);
        return true;
    }

private:
    static bool is_set(uint8_t byte) { return byte != 0; }

    static bool tell(const Tell& progress, float share, std::string& error) {
        if (!progress || progress(share))
            return true;
        error = "ddt: cancelled";
        return false;
    }

    float* pixel(size_t i) { return m_image.values + i * m_channels; }

    /// How many missing pixels there are near each pixel, by sums along rows, then columns.
    std::vector<uint8_t> near_holes() const {
        const size_t size = size_t(m_width) * size_t(m_height);
        std::vector<uint8_t> rows(size, 0), near(size, 0);
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) {
                const size_t i = size_t(y) * size_t(m_width) + size_t(x);
                if (m_missing[i])
                    std::fill(&rows[i] - std::min(x, margin),
                              &rows[i] + std::min(m_width - 1 - x, margin) + 1, uint8_t(1));
            }
        for (int y = 0; y < m_height; ++y) {
            const int last = std::min(y + margin, m_height - 1);
            for (int k = std::max(y - margin, 0); k <= last; ++k)
                for (int x = 0; x < m_width; ++x)
                    near[size_t(y) * size_t(m_width) + size_t(x)] |=
                        rows[size_t(k) * size_t(m_width) + size_t(x)];
        }
        return near;
    }

    void collect() {
        const std::vector<uint8_t> near = near_holes();
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) {
                const size_t i = size_t(y) * size_t(m_width) + size_t(x);
                if (m_missing[i] || !near[i])
                    continue;
                m_mesh.x.push_back(x);
                m_mesh.y.push_back(y);
                m_guides.push_back(m_image.guide[i]);
                m_points.insert(m_points.end(), pixel(i), pixel(i) + m_channels);
            }
    }

    /// Whether three of the points are not on one line.
    bool spans_plane() const {
        const size_t n = m_mesh.x.size();
        for (size_t i = 2; i < n; ++i)
            if ((m_mesh.x[1] - m_mesh.x[0]) * (m_mesh.y[i] - m_mesh.y[0]) !=
                (m_mesh.y[1] - m_mesh.y[0]) * (m_mesh.x[i] - m_mesh.x[0]))
                return true;
        return false;
    }

    float value(size_t channel, const std::array<int32_t, 3>& triangle,
                const Covered& covered) const {
        if (m_image.kinds && m_image.kinds[channel] == Channel::nearest) {
            const double* w = covered.weight;
            const auto k = size_t(std::max_element(w, w + 3) - w);
            return m_points[size_t(triangle[k]) * m_channels + channel];
        }
        return value_at(m_points.data(), int(m_channels), int(channel), triangle, covered);
    }

    bool interpolate(uint8_t* inside, std::string& error) {
        return each_pixel(m_mesh, {0, 0, 1, 1, m_width, m_height}, inside, error,
                          [&](const std::array<int32_t, 3>& triangle, const Covered& covered) {
                              if (!m_missing[covered.pixel])
                                  return;
                              for (size_t c = 0; c < m_channels; ++c)
                                  pixel(covered.pixel)[c] = value(c, triangle, covered);
                              m_surface[covered.pixel] =
                                  value_at(m_guides.data(), 1, 0, triangle, covered);
                          });
    }

    bool smooth(const std::vector<uint8_t>& inside, const Tell& progress) {
        std::vector<uint8_t> filled(inside.size()), known(inside.size());
        for (size_t i = 0; i < inside.size(); ++i) {
            filled[i] = m_missing[i] && inside[i];
            known[i] = !m_missing[i] || inside[i];
            if (filled[i] && m_image.guide_too)
                m_image.guide[i] = m_surface[i];
        }
        return smooth_holes(m_image, filled, known, m_surface, progress);
    }

    /// Give missing pixels outside all triangles the value of the nearest that has one, counted in
    /// steps along rows and columns.
    void spread(const std::vector<uint8_t>& inside) {
        const size_t size = inside.size(), width = size_t(m_width);
        std::vector<uint8_t> known(size);
        std::deque<size_t> queue;
        for (size_t i = 0; i < size; ++i)
            known[i] = !m_missing[i] || inside[i];
        const auto each_neighbour = [&](size_t i, auto&& f) {
            const size_t x = i % width;
            if (i >= width)
                f(i - width);
            if (x > 0)
                f(i - 1);
            if (x + 1 < width)
                f(i + 1);
            if (i + width < size)
                f(i + width);
        };
        for (size_t i = 0; i < size; ++i)
            if (known[i])
                each_neighbour(i, [&](size_t n) {
                    if (!known[n] && (queue.empty() || queue.back() != i))
                        queue.push_back(i);
                });
        for (; !queue.empty(); queue.pop_front()) {
            const size_t i = queue.front();
            each_neighbour(i, [&](size_t n) {
                if (known[n])
                    return;
                known[n] = 1;
                std::copy_n(pixel(i), m_channels, pixel(n));
                if (m_image.guide_too)
                    m_image.guide[n] = m_image.guide[i];
                queue.push_back(n);
            });
        }
    }

    const HoledImage& m_image;
    int m_width, m_height;
    size_t m_channels;
    const uint8_t* m_missing;
    PointMesh m_mesh;
    std::vector<float> m_guides;  ///< a point
    std::vector<float> m_points;  ///< the points' values
    std::vector<float> m_surface; ///< the guide, filled
};

} // namespace

bool fill_holes(const HoledImage& image, const uint8_t* missing, const MeshOptions& options,
                Device device, const Tell& progress, MeshReport* report, std::string& error) {
    const DenormalsAreZero as_on_gpus;
    return Filler(image, missing).fill(options, device, progress, report, error);
}

bool fill_holes(float* values, int width, int height, int channels, const Channel* kinds,
                const float* guide, const uint8_t* missing, const MeshOptions& options,
                std::string* error, const std::function<bool(float)>& progress) {
    return succeeds(error, [&](std::string& why) {
        if (width < 0 || height < 0 || channels < 1) {
            why = "ddt: an image has no negative size, and at least 1 channel";
            return false;
        }
        const HoledImage image{values, const_cast<float*>(guide), width, height, channels, kinds,
                               false};
        return fill_holes(image, missing, options, Device::automatic, progress, nullptr, why);
    });
}

} // namespace ddt
