// SPDX-License-Identifier: Apache-2.0
// Where colour spaces are looked up by name: OpenColorIO configs.
//
// The user's config, $OCIO, comes first; then the small one that the project carries
// (bundled_config.h); then, without $OCIO, OpenColorIO's own (from 2.2 on).
#pragma once

#include <string>

#include <OpenColorIO/OpenColorIO.h>

namespace ddt {

/// A colour space within a config.
struct Space {
    OCIO_NAMESPACE::ConstConfigRcPtr config;
    OCIO_NAMESPACE::ConstColorSpaceRcPtr space; ///< null: no config knows the name
};

/// Who chose the name of a colour space.
enum class NamedBy {
    image, ///< metadata: a name nobody knows is no error, and the bundled config is asked too, also
           ///< where $OCIO's knows the name but has no role scene_linear
    user,  ///< the name must be known; where $OCIO is set, by that config
};

/// Find a space by name or alias, in any case. "Linear" is the config's scene_linear role, and
/// "GammaX.Y" and "gXY_rec709_scene" are known for any X.Y from 0.1 to 10, as OpenImageIO's readers
/// name them. Returns false with one line in `error` when $OCIO cannot be read, or when the user's
/// name is unknown; the line then lists the known ones. To be called under colour_lock()
/// (colour_lock.h) where there are threads; each $OCIO is read once.
bool find_space(const std::string& name, NamedBy by, Space& found, std::string& error);

} // namespace ddt
