// SPDX-License-Identifier: Apache-2.0
#include "plugin/gegl/properties.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <gegl.h>

#include "ddt/names.h"
#include "plugin/host/parameters.h"

namespace ddt::gegl {

using namespace host;

namespace {

/// Numbers of properties; those of the option table follow.
enum Property : guint { none, prop_scale, prop_filter, prop_light, prop_options };

constexpr double largest_scale = 1024;

/// What the light can be, as Settings::light numbers them: names that find_meaning() knows.
constexpr const char* lights[] = {"linear", "encoded"};

/// A type of names, for the lists that hosts show. Never unregistered; its texts stay.
GType enum_of(GTypeModule* module, const std::string& key, const std::vector<std::string>& names) {
    auto* values = g_new0(GEnumValue, names.size() + 1);
    for (size_t i = 0; i < names.size(); ++i)
        values[i] = {int(i), g_strdup(names[i].c_str()), g_strdup(names[i].c_str())};
    return g_type_module_register_enum(module, ("GeglOpDdt_" + key).c_str(), values);
}

constexpr auto flags = GParamFlags(G_PARAM_READWRITE | G_PARAM_CONSTRUCT | G_PARAM_STATIC_STRINGS |
                                   GEGL_PARAM_PAD_INPUT);

/// An option's key as GObject wants properties named. Lives as long as the process.
const char* property_name(const char* key) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', '-');
    return g_intern_string(name.c_str());
}

/// A number of which a host shows enough decimals.
GParamSpec* with_digits(GParamSpec* spec) {
    gegl_param_spec_double_set_digits(GEGL_PARAM_SPEC_DOUBLE(spec), shown_digits);
    return spec;
}

/// Texts of parameters() live as long as the process.
GParamSpec* spec_of(GTypeModule* module, const Parameter& p) {
    const char *key = property_name(p.option->key), *label = p.label.c_str(),
               *help = p.help.c_str();
    switch (p.kind) {
    case ddt::OptionKind::real:
        return with_digits(gegl_param_spec_double(key, label, help, p.low, p.high, p.initial, p.low,
                                                  p.shown_high, 1.0, flags));
    case ddt::OptionKind::whole:
        return gegl_param_spec_int(key, label, help, int(p.low), int(p.high), int(p.initial),
                                   int(p.low), int(p.shown_high), 1.0, flags);
    case ddt::OptionKind::toggle:
        return g_param_spec_boolean(key, label, help, p.initial != 0, flags);
    default:
        return gegl_param_spec_enum(key, label, help, enum_of(module, p.option->key, p.names),
                                    int(p.initial), flags);
    }
}

} // namespace

std::string specification(const Settings& settings) {
    std::string text = ddt::filter_names()[size_t(settings.filter)];
    for (size_t i = 0; i < parameters().size(); ++i)
        text += item(parameters()[i], settings.values[i]);
    return text;
}

bool set_property(Settings& settings, guint id, const GValue* value) {
    if (id == prop_scale)
        settings.scale = g_value_get_double(value);
    else if (id == prop_filter)
        settings.filter = g_value_get_enum(value);
    else if (id == prop_light)
        settings.light = g_value_get_enum(value);
    else if (id - prop_options < parameters().size())
        settings.values[id - prop_options] =
            G_VALUE_HOLDS_DOUBLE(value)    ? g_value_get_double(value)
            : G_VALUE_HOLDS_INT(value)     ? double(g_value_get_int(value))
            : G_VALUE_HOLDS_BOOLEAN(value) ? double(g_value_get_boolean(value))
                                           : double(g_value_get_enum(value));
    else
        return false;
    return true;
}

bool get_property(const Settings& settings, guint id, GValue* value) {
    if (id == prop_scale) {
        g_value_set_double(value, settings.scale);
    } else if (id == prop_filter) {
        g_value_set_enum(value, settings.filter);
    } else if (id == prop_light) {
        g_value_set_enum(value, settings.light);
    } else if (id - prop_options < parameters().size()) {
        const double number = settings.values[id - prop_options];
        if (G_VALUE_HOLDS_DOUBLE(value))
            g_value_set_double(value, number);
        else if (G_VALUE_HOLDS_INT(value))
            g_value_set_int(value, int(number));
        else if (G_VALUE_HOLDS_BOOLEAN(value))
            g_value_set_boolean(value, number != 0);
        else
            g_value_set_enum(value, int(number));
    } else {
        return false;
    }
    return true;
}

void install_properties(GObjectClass* object, GTypeModule* module) {
    g_object_class_install_property(
        object, prop_scale,
        with_digits(gegl_param_spec_double("scale", "Scale", "By how much both sides grow", 1.0,
                                           largest_scale, 2.0, 1.0, 8.0, 2.0, flags)));
    g_object_class_install_property(
        object, prop_filter,
        gegl_param_spec_enum("filter", "Filter", g_intern_string(help_of_filters().c_str()),
                             enum_of(module, "filter", ddt::filter_names()), 0, flags));
    g_object_class_install_property(
        object, prop_light,
        gegl_param_spec_enum(
            "light", "Light", "Whether linear light is blended or the encoded numbers",
            enum_of(module, "light", {std::begin(lights), std::end(lights)}), 0, flags));
    for (size_t i = 0; i < parameters().size(); ++i)
        g_object_class_install_property(object, prop_options + guint(i),
                                        spec_of(module, parameters()[i]));
}

} // namespace ddt::gegl
