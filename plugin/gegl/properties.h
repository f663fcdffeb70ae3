// SPDX-License-Identifier: Apache-2.0
// The operation's properties: the filter and its options, and how much both sides grow.
#pragma once

#include <string>

#include <gegl-plugin.h>

namespace ddt::gegl {

/// What they are set to. Part of what GObject gives and takes the memory of.
struct Settings {
    double scale;
    int filter, light; ///< as their lists number them
    double* values;    ///< one a parameter

    bool blends_encoded() const { return light == 1; }
};

/// The filter's specification that the properties amount to.
std::string specification(const Settings& settings);

/// False if there is no property of that number.
bool set_property(Settings& settings, guint id, const GValue* value);
bool get_property(const Settings& settings, guint id, GValue* value);

/// Give the operation's class the properties; `module` owns the types that they need.
void install_properties(GObjectClass* object, GTypeModule* module);

} // namespace ddt::gegl
