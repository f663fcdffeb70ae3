// SPDX-License-Identifier: Apache-2.0
// What a host has set for floating point neither changes a bit nor is changed.
#include <cmath>

#include "core/base/codes.h"
#include "core/base/float_bits.h"
#include "core/base/half.h"
#include "ddt/mesh.h"
#include "ddt/points.h"
#include "tests/core/helpers.h"
#include "tests/core/host_floats.h"
#include "tests/core/job_helpers.h"
#include "tests/core/random_points.h"
#include "tests/fnv.h"

namespace ddt::test {
namespace {

/// Noise from the smallest floats to large ones, enlarged; row by row or position by position.
std::vector<float> result(const SurfaceOptions& surface, bool one_by_one) {
    const Rect window{0, 0, 40, 30}, out{0, 0, 120, 90};
    TestSource source(window, 1, 3);
    Random random(11);
    for (float& v : source.values())
        v = std::ldexp(random.unit() - 0.5f, int(200 * random.unit()) - 149);
    Job job = job_of(source, 1);
    job.surface = surface;
    const ResizeMapping rows = mapping_of(window, out, out);
    const Opaque positions(rows);
    TestSink sink(out, 1);
    std::string error;
    EXPECT_EQ(enlarge(source, sink, one_by_one ? static_cast<const Mapping&>(positions) : rows, job,
                      &error),
              Outcome::done)
        << error;
    return sink.values();
}

/// Plain buffers, with a guide that is made of their channels, and several meshes.
std::vector<float> result_of_buffers() {
    constexpr int width = 20, height = 15, channels = 3;
    std::vector<float> src(size_t(width * height * channels)), dst(9 * src.size());
    Random random(12);
    for (float& v : src)
        v = random.unit();
    MeshOptions mesh;
    mesh.meshes = 4;
    EXPECT_EQ(enlarge(src.data(), width, height, channels, nullptr, dst.data(), 3 * width,
                      3 * height, SurfaceOptions(), mesh),
              Outcome::done);
    return dst;
}

/// Numbers in files, there and back.
template <class Number, class There, class Back>
std::vector<float> result_of_numbers(There there, Back back) {
    std::vector<float> floats(1000), again(floats.size());
    Random random(13);
    for (float& v : floats)
        v = random.unit();
    std::vector<Number> numbers(floats.size());
    there(floats.data(), floats.size(), numbers.data());
    back(numbers.data(), numbers.size(), again.data());
    again.insert(again.end(), numbers.begin(), numbers.end());
    return again;
}
std::vector<float> result_of_bytes() {
    using There = void (*)(const float*, size_t, uint8_t*);
    using Back = void (*)(const uint8_t*, size_t, float*);
    return result_of_numbers<uint8_t, There, Back>(codes_of_floats, floats_of_codes);
}
std::vector<float> result_of_halfs() {
    return result_of_numbers<uint16_t>(halfs_of_floats, floats_of_halfs);
}

/// Pixels without alpha are filled, those with the smallest there is too.
std::vector<float> result_of_holes() {
    const Rect window{0, 0, 30, 20}, out{0, 0, 60, 40};
    TestSource source(window, 2, 5);
    Random random(14);
    for (size_t i = 1; i < source.values().size(); i += 2)
        source.values()[i] = random.below(5) != 0 ? 1.0f : random.below(2) != 0 ? 1e-40f : 0.0f;
    Job job = job_of(source, 2);
    job.kinds = {Channel::blend, Channel::alpha};
    job.holes = Holes::fill_alpha;
    TestSink sink(out, 2);
    std::string error;
    EXPECT_EQ(enlarge(source, sink, mapping_of(window, out, out), job, &error), Outcome::done)
        << error;
    return sink.values();
}

/// Points are triangulated, their mesh is flipped, and drawn with values of which some are
/// denormals.
std::vector<float> result_of_points() {
    PointMesh mesh = random_points(60, 15);
    std::vector<float> values;
    Random random(16);
    for (size_t i = 0; i < mesh.x.size(); ++i)
        values.push_back(i % 3 == 0 ? 1e-40f : random.unit());
    EXPECT_TRUE(delaunay(mesh));
    EXPECT_TRUE(optimise(mesh, values.data(), {}, nullptr, nullptr, {}, Device::cpu));
    std::vector<float> drawn(50 * 50, -1.0f);
    std::vector<uint8_t> inside(drawn.size());
    EXPECT_TRUE(draw(mesh, values.data(), 1, {0, 0, 20, 20, 50, 50}, drawn.data(), inside.data()));
    return drawn;
}
std::vector<float> result_of_mesh() {
    std::vector<float> guide;
    Random random(17);
    for (int i = 0; i < 30 * 20; ++i)
        guide.push_back(random.unit());
    Mesh mesh;
    EXPECT_TRUE(build_mesh(guide.data(), 30, 20, {}, mesh));
    std::vector<float> vertices;
    for (const auto& t : mesh.triangles)
        vertices.insert(vertices.end(), t.begin(), t.end());
    return vertices;
}

/// Whether a result is the same however the host has floats computed, and the host's mode is what
/// it was.
template <class Result>
void expect_no_difference(Result&& result) {
    const uint64_t usual = fnv(result());
    for (const HostMode& mode : host_modes()) {
        std::vector<float> other;
        bool unchanged = false;
        {
            const HostFloats host(mode);
            other = result();
            unchanged = host.unchanged();
        }
        EXPECT_TRUE(unchanged) << mode.rounding << ' ' << mode.control;
        EXPECT_EQ(fnv(other), usual) << mode.rounding << ' ' << mode.control;
    }
}

TEST(HostsMode, NeitherMattersNorChanges) {
    for (const bool one_by_one : {false, true})
        for (const SurfaceOptions& surface : surfaces_with({0, 1}))
            expect_no_difference([&] { return result(surface, one_by_one); });
}

TEST(HostsMode, NorDoesItOfWhatComesBeforeAndAfter) {
    for (auto* const result : {result_of_buffers, result_of_bytes, result_of_halfs, result_of_holes,
                               result_of_points, result_of_mesh})
        expect_no_difference(result);
}

} // namespace
} // namespace ddt::test
