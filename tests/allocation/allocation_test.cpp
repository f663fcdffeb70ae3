// SPDX-License-Identifier: Apache-2.0
// Memory runs out at every place where it is asked for, one after the other, once and for good: a
// job either fails with a line, or says nothing for want of memory to say it in, or gives the bits
// that it gives otherwise. Nothing is thrown, nothing ends the process.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/core.h"
#include "ddt/log.h"
#include "ddt/mesh.h"
#include "ddt/option_table.h"
#include "ddt/points.h"
#include "ddt/resize.h"
#include "tests/environment.h"

// The program's code: this project's, and what the compiler made for it of the standard library.
extern "C" const char __executable_start, etext;

namespace {

/// Whose requests for memory may fail.
enum class Whose { nobodys, everybodys, ours };

std::atomic<Whose> failing{Whose::nobodys};
std::atomic<int64_t> before_failure{0}; ///< requests that are still met
std::atomic<bool> for_good{false};      ///< all that follow fail too
std::atomic<int64_t> failed{0};

bool fails(const void* caller) {
    const Whose whose = failing;
    if (whose == Whose::nobodys)
        return false;
    const char* at = static_cast<const char*>(caller);
    if (whose == Whose::ours && (at < &__executable_start || at >= &etext))
        return false;
    const int64_t left = before_failure--;
    if (left > 0 || (left < 0 && !for_good))
        return false;
    ++failed;
    return true;
}

void* allocate(size_t size, const void* caller) {
    void* p = fails(caller) ? nullptr : std::malloc(size ? size : 1);
    if (!p)
        throw std::bad_alloc();
    return p;
}

} // namespace

// Not inlined: whoever called is found by the return address.
__attribute__((noinline)) void* operator new(size_t size) {
    return allocate(size, __builtin_return_address(0));
}
__attribute__((noinline)) void* operator new[](size_t size) {
    return allocate(size, __builtin_return_address(0));
}
__attribute__((noinline)) void* operator new(size_t size, const std::nothrow_t&) noexcept {
    return fails(__builtin_return_address(0)) ? nullptr : std::malloc(size ? size : 1);
}
__attribute__((noinline)) void operator delete(void* p) noexcept {
    std::free(p);
}
__attribute__((noinline)) void operator delete[](void* p) noexcept {
    std::free(p);
}
__attribute__((noinline)) void operator delete(void* p, size_t) noexcept {
    std::free(p);
}
__attribute__((noinline)) void operator delete[](void* p, size_t) noexcept {
    std::free(p);
}

namespace ddt {
namespace {

using Bits = std::vector<float>;

constexpr int width = 24, height = 20, scale = 2;

/// Stripes and a bright spot.
Bits picture(int channels) {
    Bits values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                values.push_back((2 * x + 3 * y + c) % 17 < 8 ? 0.2f : 0.7f + 0.01f * float(y));
    values[size_t(5 * width + 5) * size_t(channels)] = 40;
    return values;
}

/// A job: whether it was done, with its result in memory that is there; or its one line.
using Task = std::function<bool(Bits& result, std::string& error)>;

/// Have the task's nth request for memory fail, for every n that it comes to.
void fail_at_every_request(const Task& task, Whose whose, Bits result) {
    Bits expected = result;
    std::string error;
    ASSERT_TRUE(task(expected, error)) << error; // also: what is found out once a process
    int64_t refused = 0, survived = 0;
    for (const bool forever : {false, true})
        for (int64_t n = 0;; ++n) {
            ASSERT_LT(n, 100000) << "no end of requests";
            error.clear();
            before_failure = n;
            for_good = forever;
            failed = 0;
            ddt::release_memory(); // or less would be asked for
            failing = whose;
            const bool done = task(result, error);
            failing = Whose::nobodys;
            if (done) {
                ASSERT_EQ(std::memcmp(result.data(), expected.data(), result.size() * 4), 0) << n;
            }
            if (failed == 0) {
                ASSERT_TRUE(done) << error;
                break;
            }
            ASSERT_EQ(error.find('\n'), std::string::npos) << error;
            ASSERT_TRUE(done || error.empty() || error.compare(0, 5, "ddt: ") == 0) << error;
            ++(done ? survived : refused);
        }
    EXPECT_GT(refused, 0);
    std::printf("%lld requests refused: %lld failures, %lld done all the same\n",
                static_cast<long long>(refused + survived), static_cast<long long>(refused),
                static_cast<long long>(survived));
}

/// The core's call for plain floats.
Task enlargement(const char* filter, int channels, int threads) {
    FilterOptions options;
    std::string error;
    EXPECT_TRUE(parse_filter(filter, options, error)) << error;
    return [=, source = picture(channels)](Bits& result, std::string& why) {
        return enlarge(source.data(), width, height, channels, nullptr, result.data(),
                       scale * width, scale * height, options.surface, options.mesh, threads,
                       &why) == Outcome::done;
    };
}

Bits enlarged_size(int channels) {
    return Bits(size_t(scale * width * scale * height * channels));
}

TEST(Allocation, TheCpu) {
    const Environment cpu("DDT_DEVICE", "cpu");
    for (const char* filter : {"ddt", "ddt-sharp", "ddt-sharp,clipped=1", "ddt-linear",
                               "ddt,scheme=maxgain,meshes=2", "ddt,scheme=annealing"})
        for (const int threads : {1, 2}) {
            SCOPED_TRACE(filter);
            fail_at_every_request(enlargement(filter, 5, threads), Whose::everybodys,
                                  enlarged_size(5));
        }
}

class AllocationOn : public testing::TestWithParam<const char*> {};

// Mesa's own requests, and those of its compiler, are met: they end the process.
TEST_P(AllocationOn, ADevice) {
    const Environment device("DDT_DEVICE", GetParam());
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    for (const char* filter : {"ddt", "ddt-sharp,clipped=1", "ddt,scheme=maxgain"}) {
        SCOPED_TRACE(filter);
        const Task task = enlargement(filter, 3, 2);
        Bits result = enlarged_size(3);
        std::string error;
        if (!task(result, error) && (error.find("cannot be had") != error.npos ||
                                     error.find("cannot open shared object") != error.npos))
            GTEST_SKIP() << error;
        fail_at_every_request(task, Whose::ours, result);
        // Nothing of that has cost the process its device.
        std::string told;
        set_log([&](const char* line) { told += line; });
        EXPECT_TRUE(task(result, error)) << error;
        set_log(nullptr);
        EXPECT_NE(told.find(std::string("device ") + GetParam()), told.npos) << told;
    }
}
INSTANTIATE_TEST_SUITE_P(Devices, AllocationOn, testing::Values("egl", "osmesa"),
                         [](const auto& param) { return std::string(param.param); });

TEST(Allocation, AMesh) {
    fail_at_every_request(
        [source = picture(1)](Bits& result, std::string& error) {
            Mesh mesh;
            if (!build_mesh(source.data(), width, height, {}, mesh, nullptr, &error))
                return false;
            for (size_t i = 0; i < result.size(); ++i)
                result[i] = float(mesh.triangles[i / 3][i % 3]);
            return true;
        },
        Whose::everybodys, Bits(size_t(6 * (width - 1) * (height - 1))));
}

TEST(Allocation, Holes) {
    const Environment cpu("DDT_DEVICE", "cpu");
    std::vector<uint8_t> missing(size_t(width * height));
    for (size_t i = 0; i < missing.size(); i += 7)
        missing[i] = 1;
    fail_at_every_request(
        [=, source = picture(1)](Bits& result, std::string& error) {
            std::copy(source.begin(), source.end(), result.begin());
            return fill_holes(result.data(), width, height, 1, nullptr, source.data(),
                              missing.data(), {}, &error);
        },
        Whose::ours, Bits(size_t(width * height)));
}

/// One channel in memory, of which every seventh pixel is missing.
class HoledSource final : public Source {
public:
    bool read(const Rect& r, float* values, float* guide) override {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                const size_t i = size_t(y * width + x);
                *guide++ = *values++ = i % 7 == 0 ? std::nanf("") : m_picture[i];
            }
        return true;
    }

private:
    const Bits m_picture = picture(1);
};

/// Writes one channel to memory that is there.
class PlaneSink final : public Sink {
public:
    explicit PlaneSink(Bits& bits) : m_bits(bits) {}
    bool write(const Rect& r, float* values) override {
        for (int y = r.y0; y < r.y1; ++y, values += r.width())
            std::copy_n(values, r.width(), &m_bits[size_t(y * scale * width + r.x0)]);
        return true;
    }

private:
    Bits& m_bits;
};

TEST(Allocation, AJobWithHolesKnowsThatItIsMemory) {
    const Environment cpu("DDT_DEVICE", "cpu");
    HoledSource source;
    fail_at_every_request(
        [&](Bits& result, std::string& error) {
            PlaneSink sink(result);
            Job job;
            job.window = {0, 0, width, height};
            job.holes = Holes::fill;
            const ResizeMapping mapping(ResizeMapping::Axis::whole(width, scale * width),
                                        ResizeMapping::Axis::whole(height, scale * height));
            const Outcome outcome = enlarge(source, sink, mapping, job, &error);
            failing = Whose::nobodys;
            EXPECT_TRUE(outcome == Outcome::done || outcome == Outcome::out_of_memory) << error;
            return outcome == Outcome::done;
        },
        Whose::everybodys, enlarged_size(1));
}

// OpenImageIO's own requests are met.
TEST(Allocation, AnImageBuf) {
    const Environment cpu("DDT_DEVICE", "cpu");
    for (const OIIO::TypeDesc& type : {OIIO::TypeFloat, OIIO::TypeUInt8}) {
        OIIO::ImageSpec spec(width, height, 3, type);
        spec.attribute("oiio:ColorSpace", "sRGB");
        OIIO::ImageBuf source(spec);
        const Bits values = picture(3);
        ASSERT_TRUE(source.set_pixels(source.roi(), OIIO::TypeFloat, values.data()));
        fail_at_every_request(
            [&](Bits& result, std::string& error) {
                OIIO::ImageBuf enlarged;
                const OIIO::ROI size(0, scale * width, 0, scale * height);
                const bool done = resize(enlarged, source, {}, size, 2);
                const Whose whose = failing.exchange(Whose::nobodys);
                if (!done)
                    error = enlarged.geterror();
                else if (!enlarged.get_pixels(size, OIIO::TypeFloat, result.data()))
                    ADD_FAILURE() << enlarged.geterror();
                failing = whose;
                return done;
            },
            Whose::ours, enlarged_size(3));
    }
}

} // namespace
} // namespace ddt
