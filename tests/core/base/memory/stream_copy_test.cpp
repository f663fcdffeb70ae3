// SPDX-License-Identifier: Apache-2.0
#include "core/base/memory/stream_copy.h"

#include <cstring>

#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

TEST(StreamCopy, CopiesEveryNumberFromAnywhereToAnywhere) {
    on_each_target([] {
        constexpr float canary = -77.0f;
        std::vector<float> from(200);
        for (size_t i = 0; i < from.size(); ++i)
            from[i] = float(i);
        for (size_t begin = 0; begin < 17; ++begin)
            for (size_t n = 0; n < 150; n = n < 40 ? n + 1 : n + 13) {
                std::vector<float> to(200, canary), expected = to;
                stream_copy(from.data() + n % 5, n, to.data() + begin);
                finish_streams();
                std::copy_n(from.data() + n % 5, n, expected.data() + begin);
                ASSERT_EQ(differing(to, expected), 0u) << begin << ' ' << n;
            }
    });
}

// Memory of a caller, who may have it where no float lies by itself.
TEST(StreamCopy, CopiesToPlacesThatAreNotAligned) {
    on_each_target([] {
        std::vector<float> from(100, 0.25f);
        for (size_t shift = 1; shift < sizeof(float); ++shift) {
            std::vector<char> to(from.size() * sizeof(float) + sizeof(float));
            stream_copy(from.data(), from.size(), reinterpret_cast<float*>(to.data() + shift));
            finish_streams();
            EXPECT_EQ(std::memcmp(to.data() + shift, from.data(), from.size() * sizeof(float)), 0);
        }
    });
}

/// Keeps what it is handed in rows.
class Rows final : public Sink {
public:
    Rows(int width, int height, bool has_place)
        : values(size_t(width) * size_t(height)), m_width(size_t(width)), m_has_place(has_place) {}
    bool write(const Rect& r, float* from) override {
        for (int y = r.y0; y < r.y1; ++y, from += r.width())
            std::copy_n(from, r.width(), at(r.x0, y));
        return true;
    }
    float* place(const Rect& r, size_t& row) override {
        if (!m_has_place)
            return nullptr;
        row = m_width;
        return at(r.x0, r.y0);
    }
    std::vector<float> values;

private:
    float* at(int x, int y) { return values.data() + size_t(y) * m_width + size_t(x); }
    size_t m_width;
    bool m_has_place;
};

TEST(StreamCopy, LargeResultsHaveTheBitsThatAreHandedOver) {
    // 2^23 floats and more go past the caches.
    constexpr int width = 700, height = 401, scale = 8;
    static_assert(scale * width * scale * height > 1 << 23, "large");
    TestSource source({0, 0, width, height}, 1, 7);
    const Rect to{0, 0, scale * width, scale * height};
    Job job;
    job.window = source.window();
    job.device = Device::cpu;
    Rows placed(to.x1, to.y1, true), handed(to.x1, to.y1, false);
    ASSERT_EQ(enlarge(source, placed, mapping_of(job.window, to, to), job), Outcome::done);
    ASSERT_EQ(enlarge(source, handed, mapping_of(job.window, to, to), job), Outcome::done);
    EXPECT_EQ(differing(placed.values, handed.values), 0u);
}

} // namespace
} // namespace ddt::test
