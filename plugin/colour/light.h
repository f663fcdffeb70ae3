// SPDX-License-Identifier: Apache-2.0
// Conversion of colour between an image's numbers and linear light, by OpenColorIO.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include <OpenColorIO/OpenColorIO.h>

#include "plugin/colour/codetable.h"
#include "plugin/colour/config.h"
#include "plugin/colour/curve.h"

namespace ddt {

/// What an image's numbers mean as light.
///
/// Linear light is the scene-linear version of the image's own primaries: the config's way from the
/// space to its scene_linear role, less the matrix between the primaries. What is left is a curve a
/// channel for nearly all spaces, and nothing at all for linear ones. A space that is more than
/// that (a 3D table, a rendering) goes to scene_linear itself, pixel by pixel through OpenColorIO.
///
/// Immutable and thread-safe.
class Light {
public:
    /// A space no config knows, or one of data: numbers are as they are.
    Light() = default;
    /// Throws OCIO::Exception.
    explicit Light(const Space& space);

    bool known() const { return m_known; } ///< a colour space, not data
    /// False: the numbers are linear light already, or unknown.
    bool converts() const { return m_to_light != nullptr; }
    /// Shares of R, G and B of linear light in luminance.
    const std::array<float, 3>& luma() const { return m_luma; }
    /// True if 0 and 1 of each channel are 0 and 1 in linear light too.
    bool keeps_unit() const { return m_keeps_unit; }

    /// Convert `count` packed RGB triples in place. There and back gives the numbers again to
    /// within 2^-20 of them or better. Numbers that are not finite stay what they are.
    void to_light(float* rgb, size_t count) const;
    void from_light(float* rgb, size_t count) const;

    /// True if all channels convert alike, each by itself. Then numbers of any channels, in any
    /// order, may be converted together; the bits are those of to_light() and from_light().
    bool alike() const { return m_to_curves && m_to_curves->same && m_from_curves->same; }
    void to_light_alike(float* values, size_t count) const;
    void from_light_alike(float* values, size_t count) const;
    /// When not null: the way back to 8-bit codes, for all channels alike.
    const CodeTable* codes() const { return m_codes.get(); }

private:
    using Processor = OCIO_NAMESPACE::ConstCPUProcessorRcPtr;
    struct Curves {
        std::array<Curve, 3> channel;
        bool same = false; ///< all three are the first
    };
    static bool make_curves(const Processor& processor, Curves& curves);
    static void apply(const Processor& processor, const Curves* curves, float* rgb, size_t count);
    static void apply_alike(const Processor& processor, const Curves& curves, float* values,
                            size_t count);
    static float apply_one(const Processor& processor, const Curve& curve, int channel, float v);

    bool m_known = false;
    bool m_keeps_unit = true;
    std::array<float, 3> m_luma{0.2126f, 0.7152f, 0.0722f};
    Processor m_to_light, m_from_light;
    std::shared_ptr<const Curves> m_to_curves, m_from_curves; ///< null: not a curve a channel
    std::shared_ptr<const CodeTable> m_codes;
};

/// The light of an image whose metadata names the space `image_space` (may be empty), under the
/// option light=`option`; under light=encoded as for auto, the caller then does not convert. Null
/// with one line in `error` when there is none. Spaces are analysed once and kept. Thread-safe.
std::shared_ptr<const Light> find_light(const std::string& option, const std::string& image_space,
                                        std::string& error);

} // namespace ddt
