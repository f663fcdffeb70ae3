// SPDX-License-Identifier: Apache-2.0
// ddt-sharp and its options on whole pictures.
#include "ddt/core.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

/// What ddt-sharp asks for.
SurfaceOptions sharp() {
    SurfaceOptions s;
    s.consistency = 2;
    s.soft = 0.3f;
    return s;
}

struct Picture {
    int width, height;
    std::vector<float> values;
    float& at(int x, int y) { return values[size_t(y) * size_t(width) + size_t(x)]; }
    float at(int x, int y) const { return values[size_t(y) * size_t(width) + size_t(x)]; }
};

template <class F>
Picture picture(int width, int height, F&& f) {
    Picture p{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            p.values.push_back(f(x, y));
    return p;
}

Picture enlarged(const Picture& p, int factor, const SurfaceOptions& options,
                 const MeshOptions& mesh = plain_mesh()) {
    Picture out{p.width * factor, p.height * factor, {}};
    out.values.resize(size_t(out.width) * size_t(out.height));
    std::string error;
    EXPECT_EQ(enlarge(p.values.data(), p.width, p.height, 1, nullptr, out.values.data(), out.width,
                      out.height, options, mesh, 1, &error),
              Outcome::done)
        << error;
    return out;
}

/// Shapes with slanted and round edges, thin lines, dots and a slope; from `low` to `low` + 1.
Picture shapes(float low) {
    return picture(40, 32, [&](int x, int y) {
        if ((x - 12) * (x - 12) + (y - 14) * (y - 14) < 60)
            return low;
        if (2 * x - y > 40 || x + 3 * y == 70)
            return low + 1.0f;
        return low + 0.5f + 0.01f * float(x - y);
    });
}

/// Largest and mean distance of the large picture's means over source pixels from the source, rim
/// pixels aside.
struct Distance {
    double largest = 0, mean = 0;
};
Distance distance_of_means(const Picture& source, const Picture& large, int factor) {
    Distance d;
    int count = 0;
    for (int y = 1; y + 1 < source.height; ++y)
        for (int x = 1; x + 1 < source.width; ++x, ++count) {
            double sum = 0;
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i)
                    sum += double(large.at(x * factor + i, y * factor + j));
            const double off = std::fabs(sum / (factor * factor) - double(source.at(x, y)));
            d.largest = std::max(d.largest, off);
            d.mean += off;
        }
    d.mean /= count;
    return d;
}

TEST(Sharp, AConstantComesBackExactly) {
    for (const float value : {0.0f, 0.1f, 1.0f, -3.7f, 4096.3f}) {
        const Picture p = picture(17, 11, [&](int, int) { return value; });
        for (const SurfaceOptions& options : surfaces_with({1, 2, 5}))
            for (const float v : enlarged(p, 3, options).values)
                ASSERT_EQ(v, value);
    }
}

TEST(Sharp, APlaneComesBackExactly) {
    // Differences and positions are dyadic, so the plane's value at each position is a float. The
    // corners' clamping bends the outermost half pixel.
    for (const Pixel slope : {Pixel{1, 0}, Pixel{0, -2}, Pixel{3, -5}}) {
        const auto plane = [&](float x, float y) {
            return 2.0f + (float(slope.x) * x + float(slope.y) * y) / 64.0f;
        };
        const Picture p = picture(16, 12, [&](int x, int y) { return plane(float(x), float(y)); });
        for (const SurfaceOptions& options : surfaces_with({1, 2, 5})) {
            const Picture large = enlarged(p, 4, options);
            for (int y = 2; y < large.height - 2; ++y)
                for (int x = 2; x < large.width - 2; ++x)
                    ASSERT_EQ(large.at(x, y),
                              plane((float(x) + 0.5f) / 4 - 0.5f, (float(y) + 0.5f) / 4 - 0.5f));
        }
    }
}

TEST(Sharp, MeansOverPixelsApproachTheSource) {
    const Picture p = shapes(1.0f);
    for (const float soft : {0.0f, 0.3f}) {
        SurfaceOptions options = sharp();
        options.soft = soft;
        options.limit = 1e6f;
        double before = 1;
        for (const int rounds : {0, 1, 2, 4, 16}) {
            options.consistency = rounds;
            const double mean = distance_of_means(p, enlarged(p, 4, options), 4).mean;
            EXPECT_LT(mean, 0.8 * before) << rounds;
            before = mean;
        }
        // At 4x the output's positions are those that the rounds take the means over; at 32x they
        // lie so dense that their mean is the surface's. A pixel whose triangles' range does not
        // reach far enough stays off.
        for (const int factor : {4, 32}) {
            const Distance d = distance_of_means(p, enlarged(p, factor, options), factor);
            EXPECT_LT(d.mean, 2e-3);
            EXPECT_LT(d.largest, 5e-2);
        }
    }
}

TEST(Sharp, NoNegativesFromNone) {
    Random random(5);
    const Picture pictures[] = {
        shapes(0.0f),
        picture(32, 24, [](int x, int y) { return (x * 7 + y * 3) % 31 == 0 ? 1000.0f : 0.0f; }),
        picture(32, 24, [](int x, int y) { return x + y > 27 ? 1000.0f : 0.0f; }),
        picture(32, 24, [&](int, int) { return random.below(3) ? 0.0f : random_hdr(random); }),
    };
    for (const Picture& p : pictures)
        for (SurfaceOptions options : surfaces_with({1, 2, 5}))
            for (const float limit : {0.0f, 0.25f, 10.0f}) {
                options.limit = limit;
                for (const float v : enlarged(p, 5, options).values)
                    ASSERT_GE(v, 0.0f);
            }
}

TEST(Sharp, AlphaStaysWithinItsRange) {
    // Alpha with full and empty areas and everything between; colour beside it is corrected.
    TestSource source({0, 0, 60, 40}, 2, 7);
    Random random(7);
    for (size_t i = 1; i < source.values().size(); i += 2)
        source.values()[i] = std::min(1.0f, std::max(0.0f, 3.0f * random.unit() - 1.0f));
    const Rect out{0, 0, 180, 120};
    Job job = job_of(source, 2);
    job.kinds = {Channel::blend, Channel::alpha};
    bool colour_left = false;
    for (SurfaceOptions options : surfaces_with({1, 2, 5})) {
        options.limit = 4.0f;
        job.surface = options;
        TestSink sink(out, 2);
        ASSERT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job), Outcome::done);
        const float most = *std::max_element(source.guide().begin(), source.guide().end());
        for (size_t i = 0; i < sink.values().size(); i += 2) {
            colour_left |= sink.values()[i] > most;
            ASSERT_GE(sink.values()[i + 1], 0.0f);
            ASSERT_LE(sink.values()[i + 1], 1.0f);
        }
    }
    EXPECT_TRUE(colour_left);
}

/// The channels of `kinds` over a picture that has the same in each.
std::vector<float> enlarged_alike(const Picture& p, const std::vector<Channel>& kinds,
                                  const SurfaceOptions& options) {
    const auto channels = int(kinds.size());
    std::vector<float> values;
    for (const float v : p.values)
        values.insert(values.end(), kinds.size(), v);
    TestSource source({0, 0, p.width, p.height}, channels, 1);
    source.values() = values;
    const Rect to{0, 0, 3 * p.width, 3 * p.height};
    Job job = job_of(source, channels);
    job.kinds = kinds;
    job.surface = options;
    TestSink sink(to, channels);
    EXPECT_EQ(enlarge(source, sink, mapping_of(source.window(), to, to), job), Outcome::done);
    return sink.values();
}

// Divided by alpha, colour that is the same everywhere comes back.
TEST(Sharp, AlphaIsThatOfTheColoursThatAreMultipliedByIt) {
    Random random(3);
    const Picture p = picture(60, 40, [&](int, int) {
        return std::min(1.0f, std::max(0.0f, 3.0f * random.unit() - 1.0f));
    });
    for (SurfaceOptions options : surfaces_with({1, 2, 5}))
        for (const bool clipped : {false, true})
            for (const bool fitted : {false, true}) {
                options.clipped = clipped;
                options.fitted = fitted;
                const auto both = enlarged_alike(p, {Channel::blend, Channel::alpha}, options);
                int beyond = 0;
                for (size_t i = 0; i < both.size(); i += 2) {
                    const float expected = std::min(1.0f, std::max(0.0f, both[i]));
                    ASSERT_EQ(bits_of(both[i + 1]), bits_of(expected));
                    beyond += both[i] != expected;
                }
                EXPECT_GT(beyond, 0);
            }
}

// What some keep in a channel of that name.
TEST(Sharp, AlphaBeyondItsRangeKeepsToThePixelsAroundIt) {
    Random random(4);
    const Picture p = picture(
        30, 20, [&](int x, int y) { return x < 8 && y < 8 ? 3.0f : 6.0f * random.unit() - 2.0f; });
    SurfaceOptions options = sharp();
    options.limit = 2.0f;
    const auto both = enlarged_alike(p, {Channel::alpha, Channel::blend}, options);
    int beyond = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 90; ++x) {
            const float* const pixel = both.data() + 2 * (size_t(y) * 90 + size_t(x));
            // Of thirds of a pixel, the middle one is the pixel's own.
            const auto first = [](int at, int size) {
                return std::min(std::max(at - 1, 0) / 3, size - 2);
            };
            const int cx = first(x, p.width), cy = first(y, p.height);
            float low = 0, high = 1;
            for (const int j : {cy, cy + 1})
                for (const int i : {cx, cx + 1}) {
                    low = std::min(low, p.at(i, j));
                    high = std::max(high, p.at(i, j));
                }
            ASSERT_EQ(pixel[0], std::min(high, std::max(low, pixel[1]))) << x << ", " << y;
            beyond += pixel[0] != pixel[1];
            ASSERT_TRUE(x >= 18 || y >= 18 || pixel[0] == 3.0f);
        }
    EXPECT_GT(beyond, 0);
}

TEST(Sharp, EveryInstructionSetAndThreadCountGivesTheSameBits) {
    const ManyThreads allowed;
    TestSource source({-20, 5, 320, 290}, 6, 1);
    const Rect out{0, 0, 500, 400};
    const auto mapping = mapping_of(source.window(), out, out);
    for (const Surface kind : {Surface::linear, Surface::patch}) {
        Job job = job_of(source, 6);
        job.surface = sharp();
        job.surface.kind = kind;
        std::vector<float> first;
        const auto check = [&] {
            TestSink sink(out, 6);
            ASSERT_EQ(enlarge(source, sink, mapping, job), Outcome::done);
            if (first.empty())
                first = sink.values();
            ASSERT_EQ(differing(sink.values(), first), 0u);
        };
        on_each_target(check);
        for (const int threads : {2, 5}) {
            job.threads = threads;
            check();
        }
    }
}

TEST(Sharp, TilesMeetWithoutASeam) {
    // Noise is the mesh that agrees least; a seam would show in the pixels beside the tiles' border
    // at 256, which both tiles can be made to serve by shifting the window's start.
    const int width = 330, height = 20, cut = 40;
    const auto guide = make_guide(Kind::shapes, width, height, 3);
    const Picture whole{width, height, guide};
    const Picture part =
        picture(width - cut, height, [&](int x, int y) { return whole.at(x + cut, y); });
    const Picture a = enlarged(whole, 2, sharp()), b = enlarged(part, 2, sharp());
    for (int y = 0; y < a.height; ++y)
        for (int x = 2 * 100; x < a.width; ++x)
            ASSERT_EQ(bits_of(a.at(x, y)), bits_of(b.at(x - 2 * cut, y))) << x << " " << y;
}

TEST(Sharp, NotANumberStaysWhereItIs) {
    const float odd[] = {float_of(0x7fc00000), std::numeric_limits<float>::infinity(), -3.4e38f};
    for (const float value : odd) {
        Picture p = shapes(1.0f), spoilt = p;
        spoilt.at(20, 16) = value;
        SurfaceOptions options = sharp();
        MeshOptions mesh = plain_mesh(); // the same one in both
        mesh.scheme = Scheme::pixel;
        mesh.start = Start::diagonal;
        const Picture a = enlarged(p, 4, options, mesh), b = enlarged(spoilt, 4, options, mesh);
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                // A round reaches as far as the gradients of its neighbours, two pixels, and there
                // are two of them; then the surface.
                if (std::max(std::abs(x - 82), std::abs(y - 66)) > 4 * 8) {
                    ASSERT_EQ(bits_of(a.at(x, y)), bits_of(b.at(x, y)));
                }
                if (std::max(std::abs(x - 82), std::abs(y - 66)) > 4 * 2) {
                    ASSERT_TRUE(std::isfinite(b.at(x, y)));
                }
            }
    }
}

TEST(Sharp, FiniteNumbersGiveFiniteOnesToTheEndOfFloats) {
    Random random(7);
    const Picture p = picture(24, 20, [&](int, int) {
        const float v = random.unit();
        return v < 0.3f ? -3.4e38f : v < 0.6f ? 3.4e38f : v;
    });
    for (const int rounds : {1, 2, 5})
        for (const bool clipped : {false, true})
            for (const bool fitted : {false, true}) {
                SurfaceOptions options = sharp();
                options.consistency = rounds;
                options.clipped = clipped;
                options.fitted = fitted;
                const Picture large = enlarged(p, 3, options);
                for (const float v : large.values)
                    ASSERT_TRUE(std::isfinite(v)) << rounds << ' ' << clipped << ' ' << fitted;
            }
}

} // namespace
} // namespace ddt::test
