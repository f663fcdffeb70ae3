// SPDX-License-Identifier: Apache-2.0
#include "tests/differential/random_job.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/base/float_bits.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "tests/core/random.h"

namespace ddt::test {

namespace {

/// A resize, or a turn about the middle; asked for a part, it gives that part and no more.
class TurnOrResize final : public Mapping {
public:
    struct Shape {
        int width, height; ///< of the source
        int out_width, out_height;
        double angle; ///< 0: a resize
    };

    TurnOrResize(const Shape& shape, const Rect& part)
        : m_shape(shape), m_part(part),
          m_resize(axis(shape.width, shape.out_width, part.x0, part.x1),
                   axis(shape.height, shape.out_height, part.y0, part.y1)),
          m_cos(std::cos(shape.angle) * shape.width / shape.out_width),
          m_sin(std::sin(shape.angle) * shape.height / shape.out_height) {}

    Rect reach(double x0, double y0, double x1, double y1) const override {
        return separable() ? m_resize.reach(x0, y0, x1, y1) : m_part;
    }
    bool separable() const override { return m_shape.angle == 0; }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        if (separable())
            return m_resize.row(y, x0, x1, positions, inside);
        for (int x = x0; x < x1; ++x, ++positions, ++inside) {
            const double u = x - m_shape.out_width * 0.5, v = y - m_shape.out_height * 0.5;
            const double px = m_shape.width * 0.5 + u * m_cos - v * m_sin,
                         py = m_shape.height * 0.5 + u * m_sin + v * m_cos;
            *inside = px >= 0 && py >= 0 && px <= m_shape.width - 1 && py <= m_shape.height - 1;
            *positions =
                *inside ? Position{std::llround(px * 65536), std::llround(py * 65536)} : Position{};
        }
    }

    Scale scale() const override { return m_resize.scale(); }

    const Shape& shape() const { return m_shape; }

private:
    static ResizeMapping::Axis axis(int from, int to, int out0, int out1) {
        ResizeMapping::Axis a;
        a.from_size = a.window1 = from;
        a.to_size = to;
        a.out0 = out0;
        a.out1 = out1;
        return a;
    }

    Shape m_shape;
    Rect m_part;
    ResizeMapping m_resize;
    double m_cos, m_sin;
};

/// `v` is the picture's plain value there.
float value_of(PictureValues kind, float v, Random& random) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float special[] = {std::numeric_limits<float>::quiet_NaN(),
                                 infinity,
                                 -infinity,
                                 -0.0f,
                                 3.4e38f,
                                 -3.4e38f,
                                 1e38f};
    switch (kind) {
    case PictureValues::noise:
        return random.unit();
    case PictureValues::levels:
        return float(int(v * 3)) / 3;
    case PictureValues::lights:
        return random.below(50) ? v : v * float(1 + random.below(9000));
    case PictureValues::nonfinite:
        return random.below(40) ? v : special[random.below(7)];
    case PictureValues::denormal:
        return float_of(uint32_t(random.bits()) & 0x80ffffffu);
    case PictureValues::full_range: {
        const auto bits = uint32_t(random.bits());
        return float_of((bits & 0x7f800000u) == 0x7f800000u ? bits & 0xbfffffffu : bits);
    }
    default:
        return v;
    }
}

void draw_picture(RandomJob& j, Random& random) {
    const float slope_x = random.unit() * 0.1f, slope_y = random.unit() * 0.1f;
    const int cx = random.below(j.width), cy = random.below(j.height), ring = random.between(6, 50),
              stripe = random.between(3, 40), lean = random.between(-3, 3);
    const bool any_guide = j.kind == PictureValues::noise || j.kind == PictureValues::denormal ||
                           j.kind == PictureValues::full_range ||
                           (j.kind == PictureValues::nonfinite && random.below(2));
    for (int y = 0; y < j.height; ++y)
        for (int x = 0; x < j.width; ++x) {
            const int r2 = (x - cx) * (x - cx) + (y - cy) * (y - cy);
            float v = std::fmod(float(x) * slope_x + float(y) * slope_y, 0.4f);
            v += r2 / (ring * ring) % 2 ? 0.25f : 0.0f;
            v += (3 * x + lean * y + 30000) / stripe % 2 ? 0.25f : 0.0f;
            v += 0.02f * random.unit();
            for (int c = 0; c < j.job.channels; ++c)
                j.values.push_back(value_of(j.kind, v * (1.0f - 0.1f * float(c % 5)), random));
            j.guide.push_back(any_guide ? value_of(j.kind, v, random)
                                        : std::round(v * 4096.0f) / 4096.0f);
        }
}

/// A value that the row allows.
std::string random_value(const Option& option, Random& random) {
    switch (option.kind) {
    case OptionKind::toggle:
        return std::to_string(random.below(2));
    case OptionKind::choice:
        return option.values[size_t(random.below(int(option.values.size())))].name;
    case OptionKind::whole: {
        const double most = std::min(option.high, option.low + 70);
        return std::to_string(int64_t(option.low) + random.below(int(most - option.low) + 1));
    }
    case OptionKind::real: {
        const double most = std::min(option.high, option.low + 1);
        return number_text(float(option.low + double(random.unit()) * (most - option.low)));
    }
    case OptionKind::text:
        break;
    }
    return {};
}

/// A filter with some of its options, so that any of the table's rows comes up.
std::string random_specification(Random& random) {
    const std::vector<std::string> filters = filter_names();
    std::string text = filters[size_t(random.below(int(filters.size())))];
    for (const Option& option : option_table()) {
        if (option.kind == OptionKind::text || option.group == OptionGroup::device ||
            random.below(4))
            continue;
        text += "," + std::string(option.key) + "=" + random_value(option, random);
    }
    return text;
}

} // namespace

RandomJob random_job(uint64_t seed, uint64_t number) {
    Random random(seed * 0x9e3779b97f4a7c15u + number);
    RandomJob j;
    const bool tiles = random.below(6) == 0; // of more than one tile
    j.width = tiles ? random.between(258, 600) : random.between(1, 90);
    j.height = tiles ? random.between(1, 40) : random.between(1, 70);
    if (tiles && random.below(2))
        std::swap(j.width, j.height);
    j.kind = PictureValues(random.below(int(PictureValues::count)));
    const int channels = random.between(1, 6);
    const bool turned = j.width > 1 && j.height > 1 && random.below(4) == 0;
    // One after the other: compilers draw arguments of one call in orders of their own.
    const double angle = turned ? 0.1 * random.between(1, 60) : 0.0;
    const int out_height = j.height + random.below(200);
    const int out_width = j.width + random.below(200);
    set_shape(j, channels, out_width, out_height, angle);
    for (int c = 0; c < j.job.channels; ++c)
        j.job.kinds.push_back(Channel(random.below(3)));
    draw_picture(j, random);

    std::string error;
    FilterOptions options;
    j.specification = random_specification(random);
    if (!parse_filter(j.specification, options, error)) {
        // Not the defaults instead: the job would not be what is said of it.
        std::fprintf(stderr, "%s\n", error.c_str());
        std::abort();
    }
    j.job.mesh = options.mesh;
    // Annealing does as many as it may, and software renderers need long for each.
    if (j.job.mesh.scheme == Scheme::annealing)
        j.job.mesh.max_iterations = std::min(j.job.mesh.max_iterations, 4);
    j.job.surface = options.surface;

    const auto some = [&](int n, int& first, int& end) {
        first = random.below(n);
        end = random.between(first + 1, n);
    };
    some(j.out.x1, j.part.x0, j.part.x1);
    some(j.out.y1, j.part.y0, j.part.y1);
    return j;
}

void set_shape(RandomJob& j, int channels, int out_width, int out_height, double angle) {
    j.job.channels = channels;
    j.job.window = {0, 0, j.width, j.height};
    j.job.device = Device::cpu;
    j.job.threads = 1;
    j.out = {0, 0, out_width, out_height};
    j.part = {out_width / 4, out_height / 4, out_width - out_width / 4,
              out_height - out_height / 4};
    j.mapping = std::make_unique<TurnOrResize>(
        TurnOrResize::Shape{j.width, j.height, out_width, out_height, angle}, j.out);
}

std::unique_ptr<Mapping> mapping_of_part(const RandomJob& job, const Rect& part) {
    return std::make_unique<TurnOrResize>(static_cast<TurnOrResize&>(*job.mapping).shape(), part);
}

std::string describe(const RandomJob& j) {
    static const char* const names[] = {"shapes",    "noise",    "levels",    "lights",
                                        "nonfinite", "denormal", "full-range"};
    return std::to_string(j.width) + "x" + std::to_string(j.height) + " -> " +
           std::to_string(j.out.x1) + "x" + std::to_string(j.out.y1) +
           (j.mapping->separable() ? "" : " turned") + ", " + std::to_string(j.job.channels) +
           " channels of " + names[int(j.kind)] + ", " + j.specification;
}

} // namespace ddt::test
