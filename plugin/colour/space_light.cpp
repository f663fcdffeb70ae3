// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/space_light.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <list>
#include <mutex>
#include <tuple>
#include <utility>

#include <OpenImageIO/strutil.h>

#include "core/base/log.h"
#include "core/base/one_line.h"
#include "plugin/colour/colour_lock.h"
#include "plugin/colour/config.h"
#include "plugin/colour/own_light.h"
#include "plugin/colour/processor.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;

Light::Exact exact(const OCIO::ConstConfigRcPtr& config, const OCIO::ConstTransformRcPtr& transform,
                   OCIO::TransformDirection direction) {
    const auto processor = processor_of(config, transform, direction);
    return [processor](float* rgb, size_t count) { run(processor, rgb, count); };
}

WayToLight way_to_scene_linear(const Space& found) {
    auto transform = OCIO::ColorSpaceTransform::Create();
    transform->setSrc(found.space->getName());
    transform->setDst(found.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR)->getName());
    WayToLight way{transform, {}};
    found.config->getDefaultLumaCoefs(way.luma.data());
    return way;
}

/// The light that a way leads to, or that of the primaries it starts from.
Light light_by(const WayToLight& way, const OCIO::ConstConfigRcPtr& config) {
    const Matrix matrix =
        primaries(processor_of(config, way.transform, OCIO::TRANSFORM_DIR_FORWARD));
    auto to_light = OCIO::GroupTransform::Create();
    to_light->appendTransform(way.transform->createEditableCopy());
    to_light->appendTransform(matrix_transform(matrix, OCIO::TRANSFORM_DIR_INVERSE));

    const std::array<double, 3>& luma = way.luma;
    std::array<float, 3> own_luma;
    for (size_t c = 0; c < 3; ++c)
        own_luma[c] =
            float(luma[0] * matrix[c] + luma[1] * matrix[3 + c] + luma[2] * matrix[6 + c]);

    const auto forward = exact(config, to_light, OCIO::TRANSFORM_DIR_FORWARD);
    if (Light::is_none(forward))
        return Light::linear(own_luma);
    Light light;
    if (Light::curves(forward, exact(config, to_light, OCIO::TRANSFORM_DIR_INVERSE), own_luma,
                      light))
        return light;
    // Nothing gained by leaving the matrix out, and the light is then the config's own.
    return Light::whole(exact(config, way.transform, OCIO::TRANSFORM_DIR_FORWARD),
                        exact(config, way.transform, OCIO::TRANSFORM_DIR_INVERSE),
                        {float(luma[0]), float(luma[1]), float(luma[2])});
}

/// Throws OCIO::Exception.
Light light_of(const Space& found) {
    if (!found.space || found.space->isData() ||
        !found.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR))
        return {};
    if (!is_tone_mapped(found)) {
        Light light = light_by(way_to_scene_linear(found), found.config);
        if (light.comes_back())
            return light;
    }
    return light_by(own_light(found), found.config);
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
                    "blended in" +
                    allowed_lights_text + " and encoded";
            return nullptr;
        }
        auto light = std::make_shared<const Light>(light_of(space));
        if (!light->comes_back() && !by_image) {
            error = "light=" + name +
                    ": the OCIO config's way from this space to linear light and back changes "
                    "colours" +
                    allowed_lights_text + ", encoded, and spaces whose colours come back";
            return nullptr;
        }
        if (!light->comes_back())
            say("ddt: colour space \"%s\": the OCIO config's way to linear light and back changes "
                "colours; the numbers are used as they are",
                name.c_str());
        known->add(key, light);
        return light;
    } catch (const OCIO::Exception& e) {
        error = format("colour space \"{}\": {}; mend the OCIO config, or use light=encoded", name,
                       one_line(e.what()));
        return nullptr;
    }
}

} // namespace ddt
