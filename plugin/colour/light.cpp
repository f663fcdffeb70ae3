// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ddt {
namespace {

using Triple = std::array<float, 3>;

Triple run(const Light::Exact& exact, Triple rgb) {
    exact(rgb.data(), 1);
    return rgb;
}

/// A finite number's light, or back: logarithms grow beyond floats, and what is infinite spreads
/// over whole triangles.
float bounded(float v) {
    constexpr float most = std::numeric_limits<float>::max();
    return std::clamp(v, -most, most);
}

bool close(float a, float b, float tolerance) {
    return std::fabs(a - b) <= tolerance * std::max(1.0f, std::fabs(b));
}

/// Triples of which no two numbers are alike, from -0.2 to 2, in a fixed order.
std::vector<Triple> probes() {
    std::vector<Triple> list;
    uint32_t state = 1;
    for (int i = 0; i < 48; ++i) {
        Triple t;
        for (float& v : t) {
            state = state * 1664525u + 1013904223u;
            v = float(state >> 8) * (2.2f / 16777216.0f) - 0.2f;
        }
        list.push_back(t);
    }
    return list;
}

/// Whether colours of 0 to 1 come back to within a hundredth: where OpenColorIO's inverses are
/// steep, as those of HLG and PQ near black, they do to within half of that; from a rendering they
/// do not by far.
bool come_back(const Light::Exact& to_light, const Light::Exact& from_light) {
    constexpr int steps = 8;
    std::vector<float> colours;
    for (int r = 0; r <= steps; ++r)
        for (int g = 0; g <= steps; ++g)
            for (int b = 0; b <= steps; ++b)
                for (const int v : {r, g, b})
                    colours.push_back(float(v) / float(steps));
    std::vector<float> back = colours;
    to_light(back.data(), back.size() / 3);
    from_light(back.data(), back.size() / 3);
    return std::equal(back.begin(), back.end(), colours.begin(),
                      [](float a, float b) { return std::fabs(a - b) <= 0.01f; });
}

} // namespace

Light Light::linear(const std::array<float, 3>& luma) {
    Light light;
    light.m_known = true;
    light.m_luma = luma;
    return light;
}

bool Light::is_none(const Exact& exact) {
    const auto list = probes();
    return std::all_of(list.begin(), list.end(), [&](const Triple& t) {
        const Triple out = run(exact, t);
        return close(out[0], t[0], 1e-5f) && close(out[1], t[1], 1e-5f) &&
               close(out[2], t[2], 1e-5f);
    });
}

Light Light::converting(Exact to_light, Exact from_light, const std::array<float, 3>& luma) {
    Light light = linear(luma);
    light.m_to_light = std::move(to_light);
    light.m_from_light = std::move(from_light);
    light.m_keeps_unit = false;
    return light;
}

Light Light::whole(Exact to_light, Exact from_light, const std::array<float, 3>& luma) {
    Light light = converting(std::move(to_light), std::move(from_light), luma);
    light.m_comes_back = come_back(light.m_to_light, light.m_from_light);
    return light;
}

bool Light::curves(Exact to_light, Exact from_light, const std::array<float, 3>& luma,
                   Light& light) {
    auto to_curves = std::make_shared<Curves>(), from_curves = std::make_shared<Curves>();
    if (!make_curves(to_light, *to_curves) || !make_curves(from_light, *from_curves))
        return false;
    light = converting(std::move(to_light), std::move(from_light), luma);
    light.m_to_curves = to_curves;
    light.m_from_curves = from_curves;
    auto codes = std::make_shared<CodeTable>();
    if (light.alike() && fill_codes(from_curves->channel[0], *codes))
        light.m_codes = codes;
    const Triple black = run(light.m_to_light, {0, 0, 0}), white = run(light.m_to_light, {1, 1, 1});
    light.m_keeps_unit = true;
    for (size_t c = 0; c < 3; ++c)
        light.m_keeps_unit &= std::fabs(black[c]) < 1e-4f && close(white[c], 1.0f, 1e-4f);
    return true;
}

/// Table the conversion a channel. False when it is not a curve a channel, or not one that the
/// table follows closely.
bool Light::make_curves(const Exact& exact, Curves& curves) {
    const std::vector<float> x = Curve::arguments();
    std::vector<float> grey(3 * x.size()), values(x.size());
    for (size_t i = 0; i < x.size(); ++i)
        std::fill_n(&grey[3 * i], 3, x[i]);
    exact(grey.data(), x.size());
    for (int c = 0; c < 3; ++c) {
        for (size_t i = 0; i < x.size(); ++i)
            values[i] = grey[3 * i + c];
        curves.channel[c].fill(values.data());
    }
    curves.same = curves.channel[0] == curves.channel[1] && curves.channel[0] == curves.channel[2];

    // Curves taken on greys: colours tell whether channels mix, points between the table's (and
    // beside it, on the greys again) whether it is fine enough.
    auto followed = [&](Triple t, float tolerance) {
        const Triple wanted = run(exact, t);
        apply(exact, &curves, t.data(), 1);
        return close(t[0], wanted[0], tolerance) && close(t[1], wanted[1], tolerance) &&
               close(t[2], wanted[2], tolerance);
    };
    for (const Triple& t : probes())
        if (!followed(t, 1e-5f))
            return false;
    for (size_t i = 0; i + 1 < x.size(); i += 37)
        if (const float mid = 0.5f * (x[i] + x[i + 1]); Curve::covers(mid))
            if (!followed({mid, mid, mid}, 2e-6f))
                return false;
    return true;
}

void Light::apply(const Exact& exact, const Curves* curves, float* rgb, size_t count) {
    if (curves && curves->same) {
        apply_alike(exact, *curves, rgb, 3 * count);
        return;
    }
    const auto finite = [](float v) { return std::isfinite(v); };
    if (!curves && std::all_of(rgb, rgb + 3 * count, finite)) {
        exact(rgb, count);
        std::transform(rgb, rgb + 3 * count, rgb, bounded);
        return;
    }
    for (float* v = rgb; v < rgb + 3 * count; v += 3) {
        if (curves) {
            for (int c = 0; c < 3; ++c)
                v[c] = apply_one(exact, curves->channel[size_t(c)], c, v[c]);
            continue;
        }
        // One bad number must not spoil its neighbours, nor be made a good one.
        Triple t{v[0], v[1], v[2]};
        for (float& c : t)
            c = finite(c) ? c : 0.0f;
        t = run(exact, t);
        for (int c = 0; c < 3; ++c)
            v[c] = finite(v[c]) ? bounded(t[size_t(c)]) : v[c];
    }
}

void Light::apply_alike(const Exact& exact, const Curves& curves, float* values, size_t count) {
    constexpr size_t block = 1024; // one number that is not covered slows this many down
    const Curve& curve = curves.channel[0];
    for (size_t begin = 0; begin < count; begin += block) {
        const size_t n = std::min(block, count - begin);
        float* v = values + begin;
        for (size_t i = curve.apply(v, n); i < n; ++i)
            v[i] = apply_one(exact, curve, 0, v[i]);
    }
}

/// The curve of one channel, beyond its table by the exact conversion.
float Light::apply_one(const Exact& exact, const Curve& curve, int channel, float v) {
    if (Curve::covers(v))
        return curve(v);
    return std::isfinite(v) ? bounded(run(exact, {v, v, v})[size_t(channel)]) : v;
}

void Light::to_light(float* rgb, size_t count) const {
    if (m_to_light)
        apply(m_to_light, m_to_curves.get(), rgb, count);
}

void Light::from_light(float* rgb, size_t count) const {
    if (m_from_light)
        apply(m_from_light, m_from_curves.get(), rgb, count);
}

void Light::to_light_alike(float* values, size_t count) const {
    apply_alike(m_to_light, *m_to_curves, values, count);
}

void Light::from_light_alike(float* values, size_t count) const {
    apply_alike(m_from_light, *m_from_curves, values, count);
}

} // namespace ddt
