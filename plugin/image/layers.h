// SPDX-License-Identifier: Apache-2.0
// The layers of an image, as its channels' names tell them: "layer.component".
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace ddt {

/// True if `name` is one of `names`, in any case.
bool is_any_of(OIIO::string_view name, std::initializer_list<const char*> names);

/// The first channel whose whole name is the first of these that there is, or -1.
int find_channel(const OIIO::ImageSpec& spec, std::initializer_list<const char*> names);

/// The text between the dots.
std::vector<std::string> pieces_of(const std::string& name);

/// Channels whose names are alike up to their last dot.
struct Layer {
    std::string name;                    ///< "" of channels without a dot
    std::vector<int> channels;           ///< positions in the image, ascending
    std::vector<std::string> components; ///< what stands after the last dot, one a channel

    /// The first channel of such a component, in any case, or -1; of names that come first, first.
    int find(std::initializer_list<const char*> names) const;
};

/// In the order of their first channels.
std::vector<Layer> layers_of(const OIIO::ImageSpec& spec);

} // namespace ddt
