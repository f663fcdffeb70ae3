// SPDX-License-Identifier: Apache-2.0
// Conversion of colour between an image's numbers and linear light.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "ddt/guide.h"
#include "plugin/colour/code_table.h"
#include "plugin/colour/curve.h"

namespace ddt {

/// What an image's numbers mean as light: known colour or not, and the conversions there and back.
/// Where these are a curve a channel they are tabled. Immutable and thread-safe.
class Light {
public:
    /// Converts `count` packed RGB triples in place.
    using Exact = std::function<void(float* rgb, size_t count)>;

    /// Unknown numbers, or data: they are as they are.
    Light() = default;
    /// Numbers that are linear light already.
    static Light linear(const std::array<float, 3>& luma);
    /// False if the conversions are not a curve a channel, or none that the tables follow closely.
    static bool curves(Exact to_light, Exact from_light, const std::array<float, 3>& luma,
                       Light& light);
    /// Pixel by pixel through the conversions given, whether or not comes_back().
    static Light whole(Exact to_light, Exact from_light, const std::array<float, 3>& luma);
    /// True if a conversion changes nothing.
    static bool is_none(const Exact& exact);

    bool known() const { return m_known; } ///< a colour space, not data
    /// False: the numbers are linear light already, or unknown.
    bool converts() const { return m_to_light != nullptr; }
    /// Shares of R, G and B of linear light in luminance.
    const std::array<float, 3>& luma() const { return m_luma; }
    /// True if 0 and 1 of each channel are 0 and 1 in linear light too.
    bool keeps_unit() const { return m_keeps_unit; }

    /// False if colours of 0 to 1 become others by more than a hundredth on the way there and back:
    /// they are not to be converted. (A rendering cuts colours off.)
    bool comes_back() const { return m_comes_back; }

    /// Convert `count` packed RGB triples in place. There and back gives the numbers again: by
    /// curves to within 2^-20 of them or better, where they have an inverse (a table of a config's
    /// cuts off what is beyond its ends); else as exactly as OpenColorIO's conversions undo one
    /// another. Numbers that are not finite stay what they are.
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
    struct Curves {
        std::array<Curve, 3> channel;
        bool same = false; ///< all three are the first
    };
    /// Of conversions that are not tabled yet.
    static Light converting(Exact to_light, Exact from_light, const std::array<float, 3>& luma);
    static bool make_curves(const Exact& exact, Curves& curves);
    static void apply(const Exact& exact, const Curves* curves, float* rgb, size_t count);
    static void apply_alike(const Exact& exact, const Curves& curves, float* values, size_t count);
    static float apply_one(const Exact& exact, const Curve& curve, int channel, float v);

    bool m_known = false;
    bool m_keeps_unit = true;
    bool m_comes_back = true;
    std::array<float, 3> m_luma{luminance_weights[0], luminance_weights[1], luminance_weights[2]};
    Exact m_to_light, m_from_light;
    std::shared_ptr<const Curves> m_to_curves, m_from_curves; ///< null: not a curve a channel
    std::shared_ptr<const CodeTable> m_codes;
};

} // namespace ddt
