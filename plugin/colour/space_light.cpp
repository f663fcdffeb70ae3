// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/space_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <list>
#include <mutex>
#include <tuple>
#include <utility>

#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "plugin/colour/colour_lock.h"
#include "plugin/colour/config.h"
#include "plugin/message/format.h"

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

Light::Exact exact(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform,
                   OCIO::TransformDirection direction) {
    const auto processor = processor_of(config, transform, direction);
    return [processor](float* rgb, size_t count) { run(processor, rgb, count); };
}

/// Throws OCIO::Exception.
Light light_of(const Space& found) {
    if (!found.space || found.space->isData())
        return {};
    const auto linear = found.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR);
    if (!linear)
        return {};
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
    std::array<float, 3> own_luma;
    for (size_t c = 0; c < 3; ++c)
        own_luma[c] =
            float(luma[0] * matrix[c] + luma[1] * matrix[3 + c] + luma[2] * matrix[6 + c]);

    const auto forward = exact(found.config, to_light, OCIO::TRANSFORM_DIR_FORWARD);
    if (Light::is_none(forward))
        return Light::linear(own_luma);
    Light light;
    if (Light::curves(forward, exact(found.config, to_light, OCIO::TRANSFORM_DIR_INVERSE), own_luma,
                      light))
        return light;
    // Nothing gained by leaving the matrix out, and the light is then the config's own.
    return Light::whole(exact(found.config, to_linear, OCIO::TRANSFORM_DIR_FORWARD),
                        exact(found.config, to_linear, OCIO::TRANSFORM_DIR_INVERSE),
                        {float(luma[0]), float(luma[1]), float(luma[2])});
}

/// $OCIO, the space, and whether an image names it.
using Key = std::tuple<std::string, std::string, bool>;

/// The lights that were asked for last. No more than so many: any file may name a space, and one
/// with curves of its own takes megabytes.
class KnownLights {
public:
    /// Null if it is none of them.
    std::shared_ptr<const Light> find(const Key& key) {
        const auto it = std::find_if(m_all.begin(), m_all.end(),
                                     [&](const auto& known) { return known.first == key; });
        if (it == m_all.end())
            return nullptr;
        m_all.splice(m_all.begin(), m_all, it);
        return it->second;
    }
    void add(const Key& key, std::shared_ptr<const Light> light) {
        m_all.emplace_front(key, std::move(light));
        if (m_all.size() > most)
            m_all.pop_back();
    }

private:
    static constexpr size_t most = 32;
    std::list<std::pair<Key, std::shared_ptr<const Light>>> m_all; ///< the last asked for first
};

} // namespace

std::shared_ptr<const Light> find_light(const std::string& option, const std::string& image_space,
                                        std::string& error) {
    const bool by_image = option == "auto" || option == "encoded";
    const std::string& name = by_image ? image_space : option;
    if (name.empty())
        return std::make_shared<Light>();

    const std::lock_guard<std::mutex> lock(colour_lock());
    static auto* known = new KnownLights; // never destroyed
    const char* ocio = std::getenv("OCIO");
    const Key key{ocio ? ocio : "", name, by_image};
    if (auto light = known->find(key))
        return light;
    try {
        Space space;
        if (!find_space(name, by_image ? NamedBy::image : NamedBy::user, space, error))
            return nullptr;
        // An image's own space may be unknown; what the user names is to be used.
        if (!by_image && space.space && !space.space->isData() &&
            !space.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR)) {
            error = "light=" + name +
                    ": the OCIO config has no role scene_linear, the light that its spaces are "
                    "blended in; allowed are auto and encoded";
            return nullptr;
        }
        auto light = std::make_shared<const Light>(light_of(space));
        known->add(key, light);
        return light;
    } catch (const OCIO::Exception& e) {
        error = format("colour space \"{}\": {}; mend the OCIO config, or use light=encoded", name,
                       one_line(e.what()));
        return nullptr;
    }
}

} // namespace ddt
