// SPDX-License-Identifier: Apache-2.0
// Which of an image's channels are its colour, and which alpha is its.
#pragma once

#include <functional>
#include <vector>

#include "plugin/colour/layout.h"
#include "plugin/image/layers.h"

namespace ddt {

/// What a channel's name tells of it.
enum class Quantity { vector, slope, depth, cyan, magenta, yellow, black, other };

/// Whether it is one of a printer's, black among them.
constexpr bool is_ink(Quantity quantity) {
    return quantity >= Quantity::cyan && quantity <= Quantity::black;
}

/// One a channel. Slopes: a height and its derivatives, as maketx --bumpslopes names them. Inks: C,
/// M and Y (or cyan and so on) of a layer that has the three, and its K; of an image whose colour
/// space is CMYK the first four that are no layer's, in this order. Vectors: X, Y, Z and W of a
/// layer that has X and Y; U, V and W of one that has U and V. Depth: Z and what is called so,
/// alone or as a layer that has no red, green and blue, and the spec's z_channel, unless it is a
/// vector's: OpenImageIO takes the Z of a normal for it.
std::vector<Quantity> quantities_of(const OIIO::ImageSpec& spec, const std::vector<Layer>& layers);

/// The image's colour.
struct ColourChannels {
    ColourLayout layout;          ///< without its alpha
    const Layer* layer = nullptr; ///< where red, green and blue are, by their names
};

/// Of the channels that may be colour: those named R, G, B (or red, green, blue), else the one that
/// is named as grey, else red, green and blue of a layer, else the first three, else the one that
/// is alone (beside inks none is); or none.
///
/// Of several layers it is the first that is called as programs call the picture itself (Combined,
/// beauty, rgba, rgb, C, color, colour) by the last of its name's pieces, else by another (of
/// views: "Combined.left"), else any but depth. (An alpha tells nothing: mattes have one, too.)
ColourChannels find_colour(const OIIO::ImageSpec& spec, const std::vector<Layer>& layers,
                           const std::vector<Quantity>& quantities,
                           const std::function<bool(int channel)>& may_be);

/// The alpha of colour in that layer (null: of none), or -1: the layer's own, else the spec's,
/// unless that is of another layer's colour, or an ID.
int alpha_of_colour(int alpha, const std::vector<Layer>& layers, const Layer* layer,
                    const std::function<bool(int channel)>& is_id);

} // namespace ddt
