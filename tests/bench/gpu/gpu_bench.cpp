// SPDX-License-Identifier: Apache-2.0
// Speed of the GPU core, and that its bits are the CPU's. Needs no image library: it can be carried
// to a bare machine with a driver (see CMakeLists.txt beside it).
//
//   gpu_bench [--device egl|osmesa] [--cases N] [--runs N] [--size WxH]
//             [--filter FILTER] [--lists] [--jobs] [--cpu N] [--picture FILE.ppm]
//
// --cases: only the first N of 1080p to 4K, 4K to 8K, 8K to 16K; --size: one case of that source
// size instead; --filter: a filter and its options as in ddt-sharp,clipped=1 (one mesh, made on the
// device), ddt unless given; --lists: bytes, dispatches and time by kernel, and the work lists'
// sizes by iteration; --jobs: whole jobs from memory to memory, on the device and on all, half, a
// quarter ... of the threads, and whether their results are the same; --cpu: of those only the
// first N; --picture: a photograph, mirrored to the size, in place of the drawn picture.
#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/base/arith.h"
#include "core/base/parse_number.h"
#include "core/tiles/tile_worker.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "tests/bench/gpu/jobs.h"
#include "tests/bench/gpu/measure.h"

namespace ddt::bench {
namespace {

struct Options {
    Device device = Device::egl;
    int cases = 3, runs = 10, width = 0, height = 0, cpu = INT_MAX;
    bool lists = false, jobs = false;
    std::string filter = "ddt", picture;
    FilterOptions parsed; ///< filter
};

bool parse(int argc, char** argv, Options& o) {
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        const char* value = i + 1 < argc ? argv[i + 1] : "";
        if (name == "--lists" || name == "--jobs") {
            (name == "--lists" ? o.lists : o.jobs) = true;
            continue;
        }
        ++i;
        if (name == "--device" && (!std::strcmp(value, "egl") || !std::strcmp(value, "osmesa")))
            o.device = value[0] == 'e' ? Device::egl : Device::osmesa;
        else if (name == "--cases" && parse_number(value, 1, 3, o.cases))
            continue;
        else if (name == "--runs" && parse_number(value, 1, 1000000, o.runs))
            continue;
        else if (name == "--cpu" && parse_number(value, 1, INT_MAX, o.cpu))
            continue;
        else if (name == "--size" && parse_sides(value, 2, 1 << 20, o.width, o.height))
            o.cases = 1;
        else if (name == "--filter" && *value)
            o.filter = value;
        else if (name == "--picture" && *value)
            o.picture = value;
        else
            return false;
    }
    return true;
}

void parse_filter_of(Options& o) {
    std::string error;
    if (!parse_filter(o.filter, o.parsed, error))
        throw std::runtime_error(error);
    if (o.parsed.mesh.meshes != 1 || !gl::DeviceMesh::knows(o.parsed.mesh))
        throw std::runtime_error(o.filter + ": measured is one mesh that the device makes");
}

Job job_of(const Options& o, int width, int height) {
    Job job;
    job.window = {0, 0, width, height};
    job.channels = 4;
    job.surface = o.parsed.surface;
    job.mesh = o.parsed.mesh;
    return job;
}

Picture make_picture(const Options& o, int width, int height) {
    Picture picture(width, height);
    if (!o.picture.empty() && !picture.paint(o.picture))
        throw std::runtime_error(o.picture + " is no binary PPM file of 8 bits");
    return picture;
}

/// Of y and of x, which is as long.
size_t differing_bytes(const std::vector<float>& x, const void* y) {
    size_t differing = 0;
    const auto* a = reinterpret_cast<const char*>(x.data());
    const auto* b = static_cast<const char*>(y);
    for (size_t i = 0; i < x.size() * sizeof(float); ++i)
        differing += a[i] != b[i];
    return differing;
}

/// Bytes that differ between the device and the CPU on a picture of several tiles.
size_t differing_from_cpu(gl::Gpu& gpu, const Options& o) {
    Picture picture = make_picture(o, 700, 530);
    const ResizeMapping mapping = picture.twofold();
    TwiceTheSize sink(picture);
    const Job job = job_of(o, 700, 530);
    TileWorker worker(picture, sink, mapping, job);
    const Grid grid(job.window);
    for (int i = 0; i < grid.count(); ++i)
        worker.work(grid.tile(i), INT_MIN);
    const Measured m = measure(gpu, picture, job, 1, true, false);
    return differing_bytes(sink.values(), m.result.data());
}

size_t flipping_iterations(const Workload& work) {
    size_t n = work.iterations.size();
    while (n > 0 && work.iterations[n - 1].selected == 0)
        --n;
    return n;
}

void print_lists(const Measured& m, const std::map<std::string, double>& traffic_by_kernel) {
    std::printf("  kernel                MB  dispatches        ms    GB/s\n");
    for (const auto& [kernel, times] : m.dispatches) {
        if (times == 0)
            continue;
        const auto took = m.kernels.find(kernel);
        const double ms = took == m.kernels.end() ? 0 : took->second;
        const auto bytes = traffic_by_kernel.find(kernel);
        if (bytes != traffic_by_kernel.end())
            std::printf("  %-16s  %6.1f  %10d  %8.3f  %6.0f\n", kernel.c_str(),
                        bytes->second * 1e-6, times, ms, bytes->second * 1e-6 / ms);
        else
            std::printf("  %-16s       ?  %10d  %8.3f       ?\n", kernel.c_str(), times, ms);
    }
    std::printf("  %.1f MB to the device, %.1f MB from it\n", double(m.uploaded) * 1e-6,
                double(m.downloaded) * 1e-6);
    std::printf("  passes of finish.comp over lists, most for a tile: %d\n", m.work.passes);
    std::printf("  iteration  evaluated  candidates  flipped  waiting  touched\n");
    for (size_t i = 0; i < m.work.iterations.size(); ++i) {
        const gl::IterationCounts& c = m.work.iterations[i];
        std::printf("  %9zu  %9u  %10u  %7u  %7u  %7u\n", i + 1, c.evaluated, c.candidates,
                    c.selected, c.blocked, c.dirty);
    }
}

/// The first job, which may begin with what is not there yet, and the quickest and the median of
/// the others.
TwiceTheSize print_job(const char* name, int threads, Picture& picture, const Job& job, int runs) {
    TwiceTheSize sink(picture);
    std::vector<double> times = time_jobs(picture, job, runs + 1, sink);
    const double first = times[0];
    times.erase(times.begin());
    std::sort(times.begin(), times.end());
    std::printf("  %-8s %7d %9.1f %9.1f %9.1f\n", name, threads, first, times[0],
                times[times.size() / 2]);
    std::fflush(stdout);
    return sink;
}

/// Returns in how many bytes results differ.
size_t print_jobs(const Options& o, Picture& picture, Job job) {
    std::printf("  a job's  threads  first ms  least ms    median\n");
    const int cores = int(std::thread::hardware_concurrency());
    job.device = o.device;
    job.threads = cores;
    const auto result = print_job(device_name(o.device), cores, picture, job, o.runs);
    job.device = Device::cpu;
    size_t differing = 0;
    for (int i = 0; i < o.cpu && job.threads >= 1; ++i, job.threads /= 2) {
        const auto cpu = print_job("cpu", job.threads, picture, job, o.runs);
        differing += differing_bytes(result.values(), cpu.values().data());
    }
    std::printf("  %zu bytes of their results differ\n", differing);
    return differing;
}

/// Returns in how many bytes results of whole jobs, if there are any, differ.
size_t measure_case(gl::Gpu& gpu, const Options& o, const char* name, int width, int height,
                    double bandwidth) {
    Picture picture = make_picture(o, width, height);
    const Job job = job_of(o, width, height);
    const Measured m = measure(gpu, picture, job, o.runs, false, o.lists);
    const double* ms = m.milliseconds;
    const double mesh = ms[int(gl::Stage::triangulate)], surface = ms[int(gl::Stage::surface)],
                 sample = ms[int(gl::Stage::sample)];
    const auto traffic_by_kernel = traffic(m.work, job.mesh, job.surface);
    double bytes = 0;
    for (const auto& [kernel, b] : traffic_by_kernel)
        bytes += b;
    int dispatches = 0;
    for (const auto& [kernel, times] : m.dispatches)
        dispatches += times;
    std::printf("%-12s %9.3f %11.3f %9.3f %9.3f %9.3f %9.3f %8.0f %5.1f%% %6d %5zu %5d\n", name,
                ms[int(gl::Stage::upload)], mesh, surface, sample, ms[int(gl::Stage::download)],
                mesh + surface + sample, bytes * 1e-6,
                100.0 * bytes / ((mesh + surface + sample) * 1e-3) / bandwidth, dispatches,
                flipping_iterations(m.work), m.batches);
    std::fflush(stdout);
    if (o.lists)
        print_lists(m, traffic_by_kernel);
    if (o.jobs)
        return print_jobs(o, picture, job);
    return 0;
}

int run(const Options& o) {
    std::string why;
    bool forked = false;
    gl::Gpu* gpu = gl::open(o.device, why, forked);
    if (!gpu) {
        std::fprintf(stderr, "gpu_bench: no device: %s\n", why.c_str());
        return 1;
    }
    std::printf("%s, OpenGL %s, by %s; opened in %.0f ms\n", gpu->context->renderer.c_str(),
                gpu->context->version.c_str(), gpu->context->platform.c_str(),
                gpu->open_milliseconds);
    size_t differing = differing_from_cpu(*gpu, o);
    std::printf("700x530 to 1400x1060: %zu bytes differ from the CPU's; %d shaders compiled in "
                "%.0f ms\n",
                differing, gpu->programs->begun(), gpu->programs->milliseconds());
    const double bandwidth = copy_bandwidth(*gpu);
    std::printf("copy bandwidth %.1f GB/s (read + written)\n\n", bandwidth * 1e-9);
    std::printf("milliseconds upload triangulate   surface    sample  download   kernels"
                "       MB share  disp. iter. batch\n");
    constexpr struct {
        const char* name;
        int width, height;
    } cases[] = {{"1080p to 4K", 1920, 1080}, {"4K to 8K", 3840, 2160}, {"8K to 16K", 7680, 4320}};
    if (o.width > 0)
        differing += measure_case(*gpu, o, "own size", o.width, o.height, bandwidth);
    for (int i = 0; o.width == 0 && i < o.cases && i < 3; ++i)
        differing +=
            measure_case(*gpu, o, cases[i].name, cases[i].width, cases[i].height, bandwidth);
    return differing == 0 ? 0 : 2;
}

} // namespace
} // namespace ddt::bench

int main(int argc, char** argv) {
    ddt::bench::Options options;
    if (!ddt::bench::parse(argc, argv, options)) {
        std::fprintf(stderr, "usage: gpu_bench [--device egl|osmesa] [--cases N] [--runs N] "
                             "[--size WxH] [--filter FILTER[,OPTION=VALUE...]] [--lists] "
                             "[--jobs] [--cpu N] [--picture FILE.ppm]\n");
        return 1;
    }
    // Failures on the device arrive as exceptions.
    try {
        ddt::bench::parse_filter_of(options);
        return ddt::bench::run(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "gpu_bench: %s\n", e.what());
        return 1;
    }
}
