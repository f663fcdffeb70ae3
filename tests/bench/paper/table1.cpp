// SPDX-License-Identifier: Apache-2.0
#include "paper/table1.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <map>
#include <thread>

#include "core/base/float_mode.h"
#include "core/gl/offload.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "paper/subject.h"
#include "paper/table.h"
#include "tests/core/plain.h"

namespace paper {

namespace {

/// Nanoseconds of work of this process, whatever else the machine does; for work on one core.
double work_time() {
    return double(std::clock()) * (1e9 / CLOCKS_PER_SEC);
}

/// Nanoseconds by the clock on the wall.
double wall_time() {
    return std::chrono::duration<double, std::nano>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Sums over images.
struct Figures {
    double pixels = 0, images = 0, cost_start = 0, cost = 0, flips = 0, iterations = 0, rounds = 0,
           evaluations = 0, init = 0, comp = 0, final = 0;
    std::map<std::string, double> on_device; ///< sum by the device's name
};

/// A plain picture of one channel, enlarged on a device.
class Plain final : public ddt::Source, public ddt::Sink {
public:
    Plain(const std::vector<float>& guide, int width) : m_guide(guide), m_width(width) {}
    bool read(const ddt::Rect& r, float* values, float* guide) override {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x)
                *values++ = *guide++ = m_guide[size_t(y) * size_t(m_width) + size_t(x)];
        return true;
    }
    bool write(const ddt::Rect&, float*) override { return true; }

private:
    const std::vector<float>& m_guide;
    int m_width;
};

ddt::Job job_of(const Subject& s, const ddt::MeshOptions& o) {
    ddt::Job job;
    job.window = {0, 0, s.width(), s.height()};
    job.mesh = o;
    job.surface = ddt::test::plain_surface(ddt::Surface::linear);
    return job;
}

/// Nanoseconds by the clock on the wall, or less than 0 if the work did not run on that device.
double enlarge_on(ddt::Device device, int threads, const Subject& s,
                  const std::vector<float>& guide, const ddt::MeshOptions& o,
                  ddt::Statistics& statistics) {
    Plain picture(guide, s.width());
    const auto axis = [&](int size) {
        return ddt::ResizeMapping::Axis::whole(size, size * s.factor);
    };
    const ddt::ResizeMapping mapping(axis(s.width()), axis(s.height()));
    ddt::Job job = job_of(s, o);
    job.device = device;
    job.threads = threads;
    job.statistics = &statistics;
    const double begin = wall_time();
    const bool done = ddt::enlarge(picture, picture, mapping, job) == ddt::Outcome::done;
    const double time = wall_time() - begin;
    return done && statistics.device == device ? time : -1;
}

struct NamedDevice {
    std::string name;
    ddt::Device device;
};

/// The CPU, and a GPU if there is one: no software renderer.
std::vector<NamedDevice> devices() {
    std::vector<NamedDevice> all{
        {"cpu x" + std::to_string(std::thread::hardware_concurrency()), ddt::Device::cpu}};
    ddt::Job job;
    job.device = ddt::Device::egl;
    ddt::Placement placement;
    std::string why;
    if (!choose_device(job, 0, placement, why))
        std::printf("no GPU: %s\n", why.c_str());
    else if (const std::string gpu = describe(placement); gpu.find("llvmpipe") == gpu.npos)
        all.push_back({gpu, ddt::Device::egl});
    else
        std::printf("no GPU but a software renderer, which is not timed: %s\n", gpu.c_str());
    return all;
}

/// Add one image's figures and return its cost a pixel.
double measure(const Subject& s, const std::vector<float>& guide, const ddt::MeshOptions& o,
               const std::vector<NamedDevice>& devices, Figures& sum) {
    ddt::Lattice lattice;
    ddt::Workspace workspace;
    ddt::Statistics statistics;
    ddt::start(lattice, s.width(), s.height(), guide.data(), o); // memory is had
    double begin = work_time();
    ddt::start(lattice, s.width(), s.height(), guide.data(), o);
    sum.init += work_time() - begin;
    sum.cost_start += total_cost(lattice, o.cost);
    begin = work_time();
    {
        const ddt::DenormalsAreZero as_on_gpus;
        triangulate(lattice, o, workspace, statistics);
    }
    sum.comp += work_time() - begin;
    const double cost = total_cost(lattice, o.cost);

    ddt::Statistics whole;
    enlarge_on(ddt::Device::cpu, 1, s, guide, o, whole);
    sum.final += double(whole.times.surface + whole.times.sample + whole.times.write);
    for (const NamedDevice& d : devices) {
        const double time = enlarge_on(d.device, 0, s, guide, o, whole);
        double& of_device = sum.on_device[d.name];
        of_device = time < 0 || of_device < 0 ? -1 : of_device + time;
    }

    const double pixels = double(guide.size());
    sum.pixels += pixels;
    sum.images += 1;
    sum.cost += cost;
    sum.flips += double(statistics.flips);
    sum.iterations += statistics.iterations;
    sum.rounds += double(statistics.rounds);
    sum.evaluations += double(statistics.evaluations);
    return cost / pixels * grey_levels;
}

void add_row(Table& table, const ddt::MeshOptions& o, const Figures& f,
             const std::vector<NamedDevice>& devices) {
    std::vector<std::string> cells{
        label(o),
        number(f.cost_start / f.pixels * grey_levels, 1),
        number(f.cost / f.pixels * grey_levels, 1),
        number(100 * (1 - f.cost / f.cost_start), 2),
        number(f.flips / f.pixels, 3),
        number(f.iterations / f.images, 1),
        number(f.rounds / f.images, 1),
        number(f.evaluations / f.pixels, 2),
        number(f.init / f.pixels, 0),
        number(f.comp / f.pixels, 0),
        number(f.final / f.pixels, 0),
        number((f.init + f.comp + f.final) / f.pixels, 0),
    };
    for (const NamedDevice& d : devices) {
        const double time = f.on_device.at(d.name);
        cells.push_back(time < 0 ? "-" : number(time / f.pixels, 0));
    }
    table.add(cells);
}

using Costs = std::map<std::string, double>; ///< a pixel, by label

struct Claim {
    const char* text;
    bool (*holds)(const Costs&);
};

double best_parallel(const Costs& c) {
    return std::min({c.at("maxgain"), c.at("exproi-maxgain"), c.at("exproi2-maxgain"),
                     c.at("exproi5-maxgain")});
}

/// Section 6 of the paper, and what this project claims beyond it. Within a thousandth is a tie, of
/// which each claim holds.
constexpr double tie = 1.001;
constexpr Claim claims[] = {
    {"basic costs more than exproi",
     [](const Costs& c) { return c.at("exproi") <= c.at("basic") * tie; }},
    {"exproi costs more than maxgain",
     [](const Costs& c) { return c.at("maxgain") <= c.at("exproi") * tie; }},
    {"maxgain costs more than exproi-maxgain",
     [](const Costs& c) { return c.at("exproi-maxgain") <= c.at("maxgain") * tie; }},
    {"a variant of maxgain is the paper's cheapest parallel one",
     [](const Costs& c) {
         return best_parallel(c) <= std::min(c.at("basic"), c.at("exproi")) * tie;
     }},
    {"the paper's cheapest is within 10 % of lawson, or below",
     [](const Costs& c) { return best_parallel(c) <= c.at("lawson") * 1.1; }},
    {"one-round is at or below lawson, from the same start",
     [](const Costs& c) { return c.at("one-round") <= c.at("lawson") * tie; }},
    {"one-round (flat start) is at or below lawson (flat start)",
     [](const Costs& c) {
         return c.at("one-round (flat start)") <= c.at("lawson (flat start)") * tie;
     }},
    {"one-round (flat start) is at or below lawson as in the paper",
     [](const Costs& c) { return c.at("one-round (flat start)") <= c.at("lawson") * tie; }},
};

} // namespace

bool table1(const std::string& folder, int factor, Reduce how, const std::string& csv_folder) {
    const auto schemes = all_schemes();
    const auto all_devices = devices();
    std::vector<Figures> figures(schemes.size());
    std::vector<int> held(std::size(claims), 0);
    std::vector<std::string> exceptions(std::size(claims));
    int images = 0;
    Table by_image("table1-by-image-x" + std::to_string(factor), {"image", "scheme", "cost"});
    const bool found = each_subject(folder, factor, how, [&](const Subject& s) {
        const auto guide = guide_of(s.reduced);
        Costs costs;
        for (size_t i = 0; i < schemes.size(); ++i) {
            const double cost = measure(s, guide, schemes[i], all_devices, figures[i]);
            costs[label(schemes[i])] = cost;
            by_image.add({s.name, label(schemes[i]), number(cost, 3)});
        }
        for (size_t i = 0; i < std::size(claims); ++i) {
            const bool holds = claims[i].holds(costs);
            held[i] += holds;
            if (!holds)
                exceptions[i] += " " + s.name;
        }
        ++images;
    });
    if (!found) {
        std::fprintf(stderr, "paper_tables: no image in \"%s\"\n", folder.c_str());
        return false;
    }
    std::vector<std::string> columns{"scheme",  "cost-init",  "cost-final", "improvement %",
                                     "flips",   "iterations", "rounds",     "evaluations",
                                     "init ns", "comp ns",    "final ns",   "sum ns"};
    for (const NamedDevice& d : all_devices)
        columns.push_back(d.name + " ns");
    Table table("table1-x" + std::to_string(factor), columns);
    Costs means;
    for (size_t i = 0; i < schemes.size(); ++i) {
        add_row(table, schemes[i], figures[i], all_devices);
        means[label(schemes[i])] = figures[i].cost / figures[i].pixels;
    }
    const bool written = table.show(csv_folder) && by_image.write(csv_folder);
    for (size_t i = 0; i < std::size(claims); ++i) {
        std::printf("%s: %s; in %d of %d images%s%s\n", claims[i].text,
                    claims[i].holds(means) ? "yes" : "NO", held[i], images,
                    exceptions[i].empty() ? "" : ", not in", exceptions[i].c_str());
    }
    std::printf("\n");
    return written;
}

} // namespace paper
