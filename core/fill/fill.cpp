// SPDX-License-Identifier: Apache-2.0
// Filling holes of images.
#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <numeric>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/guarded.h"
#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/fill/fill.h"
#include "core/fill/hole_groups.h"
#include "core/fill/hole_mesh.h"
#include "core/fill/membrane.h"
#include "core/guide/guide.h"
#include "core/tiles/work_line.h"
#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// Microseconds of one thread, about, that meshes take for each side of a hole's rim and smoothing
/// for a missing pixel: what shares of progress are taken from.
constexpr float mesh_time = 150, smoothing_time = 7;

/// Progress of tasks that run side by side, in one rising share.
class SharedProgress {
public:
    SharedProgress(ProgressCallback whole, float all) : m_whole(std::move(whole)), m_all(all) {}

    /// Tell that so much more is done. False once it was cancelled. May throw.
    bool add(float done) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_done += done;
        return !m_whole || m_whole(std::min(m_done / m_all, 1.0f));
    }

private:
    const ProgressCallback m_whole;
    const float m_all;
    std::mutex m_mutex;
    float m_done = 0;
};

class Filler {
public:
    Filler(const HoledImage& image, const uint8_t* missing)
        : m_image(image), m_missing(missing), m_size(size_t(image.width) * size_t(image.height)) {}

    bool fill(const MeshOptions& options, Device device, const ProgressCallback& told,
              MeshReport* report, std::string& error) {
        const Stopwatch watch;
        const bool logged = verbose();
        MeshReport own;
        MeshReport* const made = logged && !report ? &own : report;
        const ProgressCallback progress = until_it_ends(told);
        const auto count = size_t(std::count_if(m_missing, m_missing + m_size, is_set));
        if (count == 0)
            return true;
        if (count == m_size) {
            error = "ddt: no pixel is there to fill the others from";
            return false;
        }
        if (!tell(progress, 0, error))
            return false;
        const std::vector<HoleGroup> groups = group_holes(m_missing, m_image.width, m_image.height);
        float rims = 0;
        for (const HoleGroup& group : groups)
            rims += float(group.rim);
        const float meshes = rims * mesh_time;
        const float smoothing_begins = meshes / (meshes + float(count) * smoothing_time);
        m_surface.assign(m_image.guide, m_image.guide + m_size);
        clean_guide(m_surface.data(), m_size);
        m_inside.assign(m_size, 0);
        SharedProgress meshing(part_of(progress, 0, smoothing_begins), rims);
        if (!make_meshes(groups, options, device, meshing, made, error))
            return false;
        if (!smooth(part_of(progress, smoothing_begins, 1))) {
            error = "ddt: cancelled";
            return false;
        }
        spread();
        if (logged)
            say_worked(device_name(made->statistics.device),
                       std::to_string(count) + " missing pixels, meshes of " +
                           std::to_string(made->statistics.pixels) + " points",
                       made->statistics, watch.milliseconds());
        return tell(progress, 1, error);
    }

private:
    static bool tell(const ProgressCallback& progress, float share, std::string& error) {
        const bool going = !progress || progress(share);
        if (!going)
            error = "ddt: cancelled";
        return going;
    }
    static bool is_set(uint8_t byte) { return byte != 0; }

    float* pixel(size_t i) { return m_image.values + i * size_t(m_image.channels); }
    bool is_known(size_t i) const { return !m_missing[i] || m_inside[i]; }

    /// A mesh for each group, those that take longest first; and what they cover.
    bool make_meshes(const std::vector<HoleGroup>& groups, const MeshOptions& options,
                     Device device, SharedProgress& shared, MeshReport* report,
                     std::string& error) {
        std::vector<size_t> order(groups.size());
        std::iota(order.begin(), order.end(), size_t(0));
        std::stable_sort(order.begin(), order.end(),
                         [&](size_t a, size_t b) { return groups[a].rim > groups[b].rim; });
        std::vector<MeshReport> reports(groups.size());
        std::mutex mutex; // of `error`
        std::atomic<bool> going{true};
        for_each_index(threads_for(m_image.threads), int(groups.size()), [&](int, int k) {
            if (!going)
                return;
            const DenormalsAreZero mode; // whichever thread this is
            const size_t own = order[size_t(k)];
            float told = 0;
            const ProgressCallback tell = [&](float share) {
                const float more = (share - told) * float(groups[own].rim);
                told = share;
                return going && shared.add(more);
            };
            std::string why;
            HoleMesh mesh(m_image, m_surface.data(), m_missing, groups[own]);
            const bool made =
                mesh.make(options, device, tell, report ? &reports[own] : nullptr, why) &&
                mesh.fill(m_surface.data(), m_inside.data(), why);
            if (made && tell(1))
                return;
            const std::lock_guard<std::mutex> lock(mutex);
            if (error.empty())
                error = made ? "ddt: cancelled" : why;
            going = false;
        });
        if (report)
            *report = sum_of(reports);
        return going;
    }

    static MeshReport sum_of(const std::vector<MeshReport>& reports) {
        MeshReport sum = reports[0];
        for (size_t i = 1; i < reports.size(); ++i) {
            sum.cost_start += reports[i].cost_start;
            sum.cost += reports[i].cost;
            sum.statistics += reports[i].statistics;
            if (reports[i].statistics.device != sum.statistics.device)
                sum.statistics.device = Device::cpu;
        }
        return sum;
    }

    bool smooth(const ProgressCallback& progress) {
        std::vector<uint8_t> filled(m_size), known(m_size);
        for (size_t i = 0; i < m_size; ++i) {
            filled[i] = m_missing[i] && m_inside[i];
            known[i] = is_known(i);
            if (filled[i] && m_image.filled_guide)
                m_image.filled_guide[i] = m_surface[i];
        }
        return smooth_holes(m_image, filled, known, m_surface, progress);
    }

    /// Give missing pixels outside all triangles the value of the nearest that has one, counted in
    /// steps along rows and columns.
    void spread() {
        const auto width = size_t(m_image.width);
        std::vector<uint8_t> known(m_size);
        std::deque<size_t> queue;
        for (size_t i = 0; i < m_size; ++i)
            known[i] = is_known(i);
        const auto each_neighbour = [&](size_t i, auto&& f) {
            const size_t x = i % width;
            if (i >= width)
                f(i - width);
            if (x > 0)
                f(i - 1);
            if (x + 1 < width)
                f(i + 1);
            if (i + width < m_size)
                f(i + width);
        };
        for (size_t i = 0; i < m_size; ++i)
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
                std::copy_n(pixel(i), m_image.channels, pixel(n));
                if (m_image.filled_guide)
                    m_image.filled_guide[n] = m_image.filled_guide[i];
                queue.push_back(n);
            });
        }
    }

    const HoledImage& m_image;
    const uint8_t* m_missing;
    const size_t m_size;
    std::vector<float> m_surface;  ///< the guide, cleaned and filled
    std::vector<uint8_t> m_inside; ///< 1 where a mesh covers a missing pixel
};

} // namespace

bool fill_holes(const HoledImage& image, const uint8_t* missing, const MeshOptions& options,
                Device device, const ProgressCallback& progress, MeshReport* report,
                std::string& error) {
    const DenormalsAreZero as_on_gpus;
    return Filler(image, missing).fill(options, device, progress, report, error);
}

bool fill_holes(float* values, int width, int height, int channels, const Channel* kinds,
                const float* guide, const uint8_t* missing, const MeshOptions& options,
                std::string* error, const ProgressCallback& progress) noexcept {
    return succeeds(error, [&](std::string& why) {
        if (width < 0 || height < 0 || channels < 1) {
            why = "ddt: width and height must be 0 or more, channels 1 or more";
            return false;
        }
        if (kinds && std::any_of(kinds, kinds + channels,
                                 [](Channel kind) { return kind > Channel::nearest; })) {
            why = "ddt: channels must be blend, alpha or nearest";
            return false;
        }
        if (!check_options(options, why))
            return false;
        const HoledImage image{values, guide, nullptr, width, height, channels, kinds};
        return fill_holes(image, missing, options, Device::automatic, progress, nullptr, why);
    });
}

} // namespace ddt
