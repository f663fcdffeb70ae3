// SPDX-License-Identifier: Apache-2.0
// Names that programs give to channels of IDs.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "plugin/image/layers.h"

namespace ddt {

/// True for the name of a channel of IDs: its last word is "id" in any case, as in "id",
/// "objectId", "prim_id", "layer.ID", or one written as one with what it is of, as "materialid". A
/// word starts after a character that is no letter and where a capital follows a small letter.
/// (Any word that ends so would take mattes for IDs: arachnid, grid, fluid.)
bool is_id_name(OIIO::string_view name);

/// Names of the image's cryptomattes, from the metadata "cryptomatte/<key>/name".
std::vector<std::string> cryptomattes(const OIIO::ImageSpec& spec);

/// True for a channel's name that is a rank of a cryptomatte: of one that is known, as in
/// "matte00.R" of "matte", or of any whose name tells it, as in "VRayCryptomatte00.R".
bool is_cryptomatte(const std::string& name, const std::vector<std::string>& known);

/// True for a layer of one channel and an ID's name: programs that name every channel by a
/// component write an ID as "objectID.red", Blender as "View.IndexOB.X", later "View.Object
/// Index.X". (Of three, such a layer is a picture of coloured objects; of one called alpha or mask
/// the matte of a thing or person, "david.A".)
bool is_layer_of_ids(const Layer& layer);

} // namespace ddt
