// SPDX-License-Identifier: Apache-2.0
#include "ddt/mesh.h"

#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "ddt/names.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// Something that no image is triangulated to.
Mesh left_over() {
    return {7, 5, {{9, 8, 7}}};
}
bool is_left_over(const Mesh& mesh) {
    const Mesh was = left_over();
    return mesh.width == was.width && mesh.height == was.height && mesh.triangles == was.triangles;
}

TEST(Mesh, HasTwoTrianglesACellAllOfAreaOneHalf) {
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 7}, Pixel{9, 2}, Pixel{31, 23}}) {
        const auto guide = make_guide(Kind::shapes, size.x, size.y, 3);
        Mesh mesh;
        ASSERT_TRUE(build_mesh(guide.data(), size.x, size.y, {}, mesh));
        EXPECT_EQ(mesh.width, size.x);
        EXPECT_EQ(mesh.height, size.y);
        ASSERT_EQ(mesh.triangles.size(), 2 * size_t(size.x - 1) * size_t(size.y - 1));
        for (const auto& t : mesh.triangles) {
            const auto at = [&](int32_t v) { return Pixel{v % size.x, v / size.x}; };
            EXPECT_EQ(det(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])), 1);
        }
    }
}

TEST(Mesh, HasTheTrianglesOfTheLattice) {
    const int w = 23, h = 17;
    const auto guide = make_guide(Kind::noise, w, h, 3);
    MeshOptions o = plain_mesh();
    o.cost = Cost::scf;
    Mesh mesh;
    MeshReport report;
    ASSERT_TRUE(build_mesh(guide.data(), w, h, o, mesh, &report));
    Lattice lattice;
    Workspace workspace;
    Statistics statistics;
    lattice.start(w, h, guide.data(), true);
    EXPECT_EQ(report.cost_start, total_cost(lattice, o.cost));
    triangulate(lattice, o, workspace, statistics);
    EXPECT_EQ(report.cost, total_cost(lattice, o.cost));
    EXPECT_EQ(report.statistics.flips, statistics.flips);
    std::vector<Face> faces;
    for (const auto& t : mesh.triangles) {
        const auto at = [&](int32_t v) { return Pixel{v % w, v / w}; };
        faces.push_back(make_face(at(t[0]), at(t[1]), at(t[2])));
    }
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(faces, faces_of(lattice));
}

TEST(Mesh, ListsItsTrianglesRowByRow) {
    const int w = 31, h = 23;
    for (const Kind kind : all_kinds) {
        const auto guide = make_guide(kind, w, h, 5);
        Mesh mesh;
        ASSERT_TRUE(build_mesh(guide.data(), w, h, {}, mesh));
        std::vector<Pixel> firsts; // midpoints, doubled
        for (const auto& t : mesh.triangles) {
            const auto at = [&](size_t k) { return Pixel{t[k % 3] % w, t[k % 3] / w}; };
            firsts.push_back(std::min({at(0) + at(1), at(1) + at(2), at(2) + at(3)}));
        }
        EXPECT_TRUE(std::is_sorted(firsts.begin(), firsts.end()));
    }
}

// As in every picture that is enlarged (ddt/job.h).
TEST(Mesh, TakesWhatIsNoUsualGuideForZero) {
    const int w = 23, h = 17;
    auto guide = make_guide(Kind::noise, w, h, 3), clean = guide;
    const float unusual[] = {std::nanf(""), HUGE_VALF, -HUGE_VALF, 0x1p-25f};
    for (size_t i = 0; i < 4; ++i) {
        guide[60 + 70 * i] = unusual[i];
        clean[60 + 70 * i] = 0;
    }
    for (const float blur : {0.0f, 0.07f}) {
        MeshOptions options = plain_mesh();
        options.blur = blur;
        Mesh mesh, wanted;
        ASSERT_TRUE(build_mesh(guide.data(), w, h, options, mesh));
        ASSERT_TRUE(build_mesh(clean.data(), w, h, options, wanted));
        EXPECT_EQ(mesh.triangles, wanted.triangles);
    }
}

TEST(Mesh, IsOneHoweverManyAreAskedFor) {
    const int w = 31, h = 23;
    const auto guide = make_guide(Kind::noise, w, h, 6);
    MeshOptions o;
    Mesh one;
    MeshReport of_one;
    ASSERT_TRUE(build_mesh(guide.data(), w, h, o, one, &of_one));
    for (o.meshes = 2; o.meshes <= most_meshes; ++o.meshes) {
        Mesh mesh;
        MeshReport report;
        ASSERT_TRUE(build_mesh(guide.data(), w, h, o, mesh, &report));
        EXPECT_EQ(mesh.triangles, one.triangles) << o.meshes;
        EXPECT_EQ(report.cost_start, of_one.cost_start) << o.meshes;
        EXPECT_EQ(report.cost, of_one.cost) << o.meshes;
        EXPECT_EQ(report.statistics.flips, of_one.statistics.flips) << o.meshes;
        EXPECT_EQ(report.statistics.pixels, of_one.statistics.pixels) << o.meshes;
    }
}

TEST(Mesh, EverySchemeTellsHowFarItIsAndCanBeCancelled) {
    const int w = 40, h = 50; // two blocks of rows
    const auto guide = make_guide(Kind::noise, w, h, 3);
    for (const std::string& name : scheme_names()) {
        SCOPED_TRACE(name);
        MeshOptions o = plain_mesh();
        ASSERT_TRUE(find_scheme(name, o));
        std::vector<float> shares;
        size_t last = SIZE_MAX;
        const auto tell = [&](float share) {
            shares.push_back(share);
            return shares.size() != last;
        };
        Mesh mesh;
        std::string error;
        ASSERT_TRUE(build_mesh(guide.data(), w, h, o, mesh, nullptr, &error, tell));
        EXPECT_GT(shares.front(), 0.0f);
        EXPECT_LE(*std::max_element(shares.begin(), shares.end()), 1.0f);
        // Before, at, and after the flips (there are none in `pixel`), and twice while triangles
        // are listed.
        const size_t calls = shares.size();
        ASSERT_GE(calls, o.scheme == Scheme::pixel ? 4u : 5u);
        EXPECT_LT(shares[0], shares[1]);
        EXPECT_LE(shares[1], shares[2]);
        EXPECT_LT(shares[calls - 3], shares[calls - 2]);
        EXPECT_LT(shares[calls - 2], 1.0f);
        EXPECT_EQ(shares[calls - 1], 1.0f);
        for (const size_t at : {size_t(1), size_t(2), size_t(3), calls - 2, calls - 1, calls}) {
            last = at;
            shares.clear();
            mesh = left_over();
            MeshReport report;
            report.cost = -5;
            EXPECT_FALSE(build_mesh(guide.data(), w, h, o, mesh, &report, &error, tell));
            EXPECT_EQ(error, "ddt: cancelled");
            EXPECT_EQ(shares.size(), at);
            EXPECT_TRUE(is_left_over(mesh));
            EXPECT_EQ(report.cost, -5);
        }
    }
}

// The fewer flips there are, the likelier is one that leaves more to do than there was.
TEST(Mesh, ProgressNeverFalls) {
    const std::vector<std::string> schemes = scheme_names();
    for (uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int w = random.between(2, 13), h = random.between(2, 13);
        MeshOptions o = plain_mesh();
        ASSERT_TRUE(find_scheme(schemes[size_t(random.below(int(schemes.size())))], o));
        o.max_iterations = std::min(o.max_iterations, 20);
        std::vector<float> shares;
        const auto tell = [&](float share) {
            shares.push_back(share);
            return true;
        };
        Mesh mesh;
        ASSERT_TRUE(build_mesh(make_guide(Kind::noise, w, h, seed).data(), w, h, o, mesh, nullptr,
                               nullptr, tell));
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_EQ(shares.back(), 1.0f);
    }
}

TEST(Mesh, SaysWhyThereIsNone) {
    const std::vector<float> guide(8, 0.0f);
    Mesh mesh = left_over();
    std::string error;
    EXPECT_FALSE(build_mesh(guide.data(), 8, 1, {}, mesh, nullptr, &error));
    EXPECT_EQ(error, "ddt: a mesh needs at least 2 x 2 pixels");
    EXPECT_FALSE(build_mesh(guide.data(), 1 << 15, 1 << 15, {}, mesh, nullptr, &error));
    EXPECT_EQ(error, "ddt: the image is too large for one mesh; allowed are 2^28 pixels");
    EXPECT_FALSE(build_mesh(nullptr, 9, 9, {}, mesh, nullptr, &error));
    EXPECT_EQ(error, "ddt: the guide is null; a mesh needs a number per pixel");
    MeshOptions o = plain_mesh();
    o.max_iterations = most_iterations + 1;
    EXPECT_FALSE(build_mesh(guide.data(), 4, 2, o, mesh, nullptr, &error));
    EXPECT_EQ(error,
              "ddt: option \"iterations=401\" is not allowed; allowed for iterations are whole "
              "numbers from 0 to 400");
    EXPECT_TRUE(is_left_over(mesh));
    EXPECT_TRUE(build_mesh(guide.data(), 4, 2, {}, mesh, nullptr, &error));
    EXPECT_EQ(error, "");
}

} // namespace
} // namespace ddt::test
