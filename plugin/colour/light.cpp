// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/light.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>
#include <tuple>
#include <vector>

#include <OpenImageIO/strutil.h>

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;
using Matrix = std::array<double, 9>; // row by row
using Triple = std::array<float, 3>;

void run(const OCIO::ConstCPUProcessorRcPtr& processor, float* rgb, size_t count) {
    OCIO::PackedImageDesc pixels(rgb, long(count), 1, 3);
    processor->apply(pixels);
}

Triple run(const OCIO::ConstCPUProcessorRcPtr& processor, Triple rgb) {
    run(processor, rgb.data(), 1);
    return rgb;
}

// Lossless: no approximations of pow, so that machines agree as far as their libm does.
OCIO::ConstCPUProcessorRcPtr processor_of(const OCIO::ConstConfigRcPtr& config,
                                          const OCIO::ConstTransformRcPtr& transform,
                                          OCIO::TransformDirection direction) {
    return config->getProcessor(transform, direction)
        ->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32,
                                   OCIO::OPTIMIZATION_LOSSLESS);
}

double determinant(const Matrix& m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

bool close(float a, float b, float tolerance) {
    return std::fabs(a - b) <= tolerance * std::max(1.0f, std::fabs(b));
}

/// The matrix that an otherwise separable conversion ends with: what it makes of pure red, green
/// and blue, above black. The unit matrix when it has no such meaning or is all but that.
Matrix primaries(const OCIO::ConstCPUProcessorRcPtr& processor) {
    const Matrix unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const Triple black = run(processor, {0, 0, 0});
    Matrix m{};
    for (int c = 0; c < 3; ++c) {
        Triple pure{0, 0, 0};
        pure[c] = 1;
        const Triple out = run(processor, pure);
        for (int r = 0; r < 3; ++r)
            m[3 * r + c] = double(out[r]) - double(black[r]);
    }
    const bool is_unit = std::equal(m.begin(), m.end(), unit.begin(),
                                    [](double a, double b) { return std::fabs(a - b) <= 1e-6; });
    const double det = determinant(m);
    return is_unit || !std::isfinite(det) || std::fabs(det) < 1e-9 ? unit : m;
}

OCIO::MatrixTransformRcPtr matrix_transform(const Matrix& m, OCIO::TransformDirection direction) {
    auto transform = OCIO::MatrixTransform::Create();
    const double m44[16] = {m[0], m[1], m[2], 0, m[3], m[4], m[5], 0,
                            m[6], m[7], m[8], 0, 0,    0,    0,    1};
    transform->setMatrix(m44);
    transform->setDirection(direction);
    return transform;
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

} // namespace

Light::Light(const Space& found) {
    if (!found.space || found.space->isData())
        return;
    const auto linear = found.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR);
    if (!linear)
        return;
    m_known = true;

    auto to_linear = OCIO::ColorSpaceTransform::Create();
    to_linear->setSrc(found.space->getName());
    to_linear->setDst(linear->getName());
    const Matrix matrix =
        primaries(processor_of(found.config, to_linear, OCIO::TRANSFORM_DIR_FORWARD));
    auto to_light = OCIO::GroupTransform::Create();
    to_light->appendTransform(to_linear);
    to_light->appendTransform(matrix_transform(matrix, OCIO::TRANSFORM_DIR_INVERSE));

    double luma[3];
    found.config->getDefaultLumaCoefs(luma);
    for (int c = 0; c < 3; ++c)
        m_luma[c] = float(luma[0] * matrix[c] + luma[1] * matrix[3 + c] + luma[2] * matrix[6 + c]);

    const auto forward = processor_of(found.config, to_light, OCIO::TRANSFORM_DIR_FORWARD);
    const auto list = probes();
    if (std::all_of(list.begin(), list.end(), [&](const Triple& t) {
            const Triple out = run(forward, t);
            return close(out[0], t[0], 1e-5f) && close(out[1], t[1], 1e-5f) &&
                   close(out[2], t[2], 1e-5f);
        }))
        return; // linear light already

    m_to_light = forward;
    m_from_light = processor_of(found.config, to_light, OCIO::TRANSFORM_DIR_INVERSE);
    auto to_curves = std::make_shared<Curves>(), from_curves = std::make_shared<Curves>();
    if (make_curves(m_to_light, *to_curves) && make_curves(m_from_light, *from_curves)) {
        m_to_curves = to_curves;
        m_from_curves = from_curves;
        auto codes = std::make_shared<CodeTable>();
        if (alike() && codes->fill(from_curves->channel[0]))
            m_codes = codes;
    } else {
        // Nothing gained by leaving the matrix out, and the light is then the config's own.
        m_to_light = processor_of(found.config, to_linear, OCIO::TRANSFORM_DIR_FORWARD);
        m_from_light = processor_of(found.config, to_linear, OCIO::TRANSFORM_DIR_INVERSE);
        std::copy(luma, luma + 3, m_luma.begin());
    }
    const Triple black = run(m_to_light, {0, 0, 0}), white = run(m_to_light, {1, 1, 1});
    m_keeps_unit = m_to_curves != nullptr;
    for (int c = 0; c < 3; ++c)
        m_keeps_unit &= std::fabs(black[c]) < 1e-4f && close(white[c], 1.0f, 1e-4f);
}

/// Table the conversion a channel. False when it is not a curve a channel, or not one that the
/// table follows closely.
bool Light::make_curves(const Processor& processor, Curves& curves) {
    const std::vector<float> x = Curve::arguments();
    std::vector<float> grey(3 * x.size()), values(x.size());
    for (size_t i = 0; i < x.size(); ++i)
        std::fill_n(&grey[3 * i], 3, x[i]);
    run(processor, grey.data(), x.size());
    for (int c = 0; c < 3; ++c) {
        for (size_t i = 0; i < x.size(); ++i)
            values[i] = grey[3 * i + c];
        curves.channel[c].fill(values.data());
    }
    curves.same = curves.channel[0] == curves.channel[1] && curves.channel[0] == curves.channel[2];

    // Curves taken on greys: colours tell whether channels mix, points between the table's (and
    // beside it, on the greys again) whether it is fine enough.
    auto followed = [&](Triple t, float tolerance) {
        const Triple exact = run(processor, t);
        apply(processor, &curves, t.data(), 1);
        return close(t[0], exact[0], tolerance) && close(t[1], exact[1], tolerance) &&
               close(t[2], exact[2], tolerance);
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

void Light::apply(const Processor& processor, const Curves* curves, float* rgb, size_t count) {
    if (curves && curves->same) {
        apply_alike(processor, *curves, rgb, 3 * count);
        return;
    }
    const auto finite = [](float v) { return std::isfinite(v); };
    if (!curves && std::all_of(rgb, rgb + 3 * count, finite)) {
        run(processor, rgb, count);
        return;
    }
    for (float* v = rgb; v < rgb + 3 * count; v += 3) {
        if (curves) {
            for (int c = 0; c < 3; ++c)
                v[c] = apply_one(processor, curves->channel[size_t(c)], c, v[c]);
            continue;
        }
        // One bad number must not spoil its neighbours, nor be made a good one.
        Triple t{v[0], v[1], v[2]};
        for (float& c : t)
            c = finite(c) ? c : 0.0f;
        t = run(processor, t);
        for (int c = 0; c < 3; ++c)
            v[c] = finite(v[c]) ? t[size_t(c)] : v[c];
    }
}

void Light::apply_alike(const Processor& processor, const Curves& curves, float* values,
                        size_t count) {
    constexpr size_t block = 1024; // one number that is not covered slows this many down
    const Curve& curve = curves.channel[0];
    for (size_t begin = 0; begin < count; begin += block) {
        const size_t n = std::min(block, count - begin);
        float* v = values + begin;
        for (size_t i = curve.apply(v, n); i < n; ++i)
            v[i] = apply_one(processor, curve, 0, v[i]);
    }
}

/// The curve of one channel, beyond its table through OpenColorIO.
float Light::apply_one(const Processor& processor, const Curve& curve, int channel, float v) {
    if (Curve::covers(v))
        return curve(v);
    return std::isfinite(v) ? run(processor, {v, v, v})[size_t(channel)] : v;
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

std::shared_ptr<const Light> find_light(const std::string& option, const std::string& image_space,
                                        std::string& error) {
    const bool by_image = option == "auto" || option == "encoded";
    const std::string& name = by_image ? image_space : option;
    if (name.empty())
        return std::make_shared<Light>();

    using Key = std::tuple<std::string, std::string, bool>;
    static std::mutex mutex;
    static auto* known = new std::map<Key, std::shared_ptr<const Light>>; // never destroyed
    const char* ocio = std::getenv("OCIO");
    const Key key{ocio ? ocio : "", name, by_image};
    const std::lock_guard<std::mutex> lock(mutex);
    if (const auto it = known->find(key); it != known->end())
        return it->second;
    try {
        Space space;
        if (!find_space(name, by_image ? NamedBy::image : NamedBy::user, space, error))
            return nullptr;
        return (*known)[key] = std::make_shared<Light>(space);
    } catch (const OCIO::Exception& e) {
        error = OIIO::Strutil::fmt::format("colour space \"{}\": {}", name, one_line(e.what()));
        return nullptr;
    }
}

} // namespace ddt
