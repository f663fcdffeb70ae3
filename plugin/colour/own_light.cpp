// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/own_light.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plugin/colour/processor.h"

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;

bool is_display(const Space& found) {
    return found.space->getReferenceSpaceType() == OCIO::REFERENCE_SPACE_DISPLAY;
}

/// Whether a conversion is one by a matrix, up to the light of the brightest displays: 1 is white,
/// PQ's most is 100.
bool is_matrix(const OCIO::ConstCPUProcessorRcPtr& processor) {
    constexpr std::array<float, 3> lights[] = {{0, 0, 0},           {0.002f, 0.001f, 0.003f},
                                               {0.18f, 0.2f, 0.1f}, {0.95f, 1, 1.09f},
                                               {3, 2, 0.5f},        {90, 100, 20},
                                               {100, 0, 0},         {0, 0, 100}};
    const Matrix m = primaries(processor);
    return std::all_of(std::begin(lights), std::end(lights), [&](const auto& light) {
        const std::array<float, 3> out = run(processor, light);
        double most = 1e-2, off = 0;
        for (size_t r = 0; r < 3; ++r) {
            const double wanted =
                m[3 * r] * light[0] + m[3 * r + 1] * light[1] + m[3 * r + 2] * light[2];
            most = std::max(most, std::fabs(wanted));
            off = std::max(off, std::fabs(double(out[r]) - wanted));
        }
        return off <= 1e-4 * most;
    });
}

/// A config that has the space's reference as a space too.
struct WithReference {
    OCIO::ConfigRcPtr config;
    OCIO::ColorSpaceTransformRcPtr to_linear; ///< from the reference to scene_linear
};

WithReference with_reference(const Space& found) {
    WithReference with{found.config->createEditableCopy(), OCIO::ColorSpaceTransform::Create()};
    // OpenColorIO 2.1 leaves it out of the copy.
    with.config->setDefaultViewTransformName(found.config->getDefaultViewTransformName());
    const auto reference = OCIO::ColorSpace::Create(found.space->getReferenceSpaceType());
    reference->setName("oiio-ddt reference");
    with.config->addColorSpace(reference);
    with.to_linear->setSrc(reference->getName());
    with.to_linear->setDst(found.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR)->getName());
    return with;
}

/// The conversions to the reference, one after the other.
OCIO::GroupTransformRcPtr steps_to_reference(const Space& found) {
    if (const auto to = found.space->getTransform(OCIO::COLORSPACE_DIR_TO_REFERENCE))
        return found.config->getProcessor(to, OCIO::TRANSFORM_DIR_FORWARD)->createGroupTransform();
    if (const auto from = found.space->getTransform(OCIO::COLORSPACE_DIR_FROM_REFERENCE))
        return found.config->getProcessor(from, OCIO::TRANSFORM_DIR_INVERSE)
            ->createGroupTransform();
    return OCIO::GroupTransform::Create(); // it is the reference
}

/// The shares in luminance of what `to_reference` makes the space's reference of.
std::array<double, 3> luma_of(const Space& found, const OCIO::GroupTransformRcPtr& to_reference) {
    std::array<double, 3> shares{0, 1, 0}, luma{};
    const auto with = with_reference(found);
    if (!is_display(found)) {
        to_reference->appendTransform(with.to_linear);
        found.config->getDefaultLumaCoefs(shares.data());
    }
    const Matrix m =
        primaries(processor_of(with.config, to_reference, OCIO::TRANSFORM_DIR_FORWARD));
    for (size_t c = 0; c < 3; ++c)
        luma[c] = shares[0] * m[c] + shares[1] * m[3 + c] + shares[2] * m[6 + c];
    return luma;
}

} // namespace

bool is_tone_mapped(const Space& found) {
    if (!is_display(found))
        return false;
    try {
        const auto with = with_reference(found);
        return !is_matrix(processor_of(with.config, with.to_linear, OCIO::TRANSFORM_DIR_FORWARD));
    } catch (const OCIO::Exception&) {
        return true; // no view transform, or one that cannot be read or inverted
    }
}

WayToLight own_light(const Space& found) {
    const auto steps = steps_to_reference(found);
    const auto type = [&](int i) { return steps->getTransform(i)->getTransformType(); };
    int end = steps->getNumTransforms();
    while (end > 0 && (type(end - 1) == OCIO::TRANSFORM_TYPE_MATRIX ||
                       type(end - 1) == OCIO::TRANSFORM_TYPE_RANGE))
        --end;
    const auto to_light = OCIO::GroupTransform::Create(), matrices = OCIO::GroupTransform::Create();
    for (int i = 0; i < steps->getNumTransforms(); ++i)
        if (i < end)
            to_light->appendTransform(steps->getTransform(i));
        else if (type(i) == OCIO::TRANSFORM_TYPE_MATRIX)
            matrices->appendTransform(steps->getTransform(i));
    return {to_light, luma_of(found, matrices)};
}

} // namespace ddt
