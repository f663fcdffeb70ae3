// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/config.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "plugin/colour/bundled_config.h"
#include "plugin/colour/ocio_builtin_config.h"
#include "plugin/colour/space_light.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;
using OIIO::Strutil::iequals;
using OIIO::Strutil::istarts_with;

/// The config $OCIO names; the bundled one is not among them. Throws OCIO::Exception.
OCIO::ConstConfigRcPtr user_config(const std::string& path) {
    static auto* read = new std::map<std::string, OCIO::ConstConfigRcPtr>;
    auto& config = (*read)[path];
    if (!config)
        config = OCIO::Config::CreateFromFile(path.c_str());
    return config;
}

/// The configs to ask, the first first. False with `error` when $OCIO cannot be read.
bool configs(NamedBy by, std::vector<OCIO::ConstConfigRcPtr>& list, std::string& error) {
    const char* path = std::getenv("OCIO");
    if (path && *path) {
        try {
            list.push_back(user_config(path));
        } catch (const OCIO::Exception& e) {
            error = format(
                "OCIO config \"{}\" (environment variable OCIO) cannot be read: {}; set OCIO to a "
                "config file, unset it, or use light=encoded",
                path, one_line(e.what()));
            return false;
        }
        if (by == NamedBy::user)
            return true;
    }
    list.push_back(bundled_config());
    // Last, so that OpenColorIO's version changes no bit of what is known without it.
    if (!path || !*path)
        if (const auto builtin = ocio_builtin_config())
            list.push_back(builtin);
    return true;
}

bool parse_all(const std::string& text, double& number) {
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc() && parsed.ptr == end;
}

/// The exponent of a name like "Gamma2.2", OpenImageIO 2's, or "g22_rec709_scene", that of 3.1; 0
/// for other names.
double exponent_of(const std::string& name) {
    constexpr OIIO::string_view tail = "_rec709_scene";
    double exponent = 0;
    bool good = false;
    if (istarts_with(name, "gamma")) {
        good = parse_all(name.substr(5), exponent);
    } else if (istarts_with(name, "g") && OIIO::Strutil::iends_with(name, tail)) {
        const std::string tenths = name.substr(1, name.size() - 1 - tail.size());
        good = tenths.find_first_not_of("0123456789") == std::string::npos &&
               parse_all(tenths, exponent);
        exponent /= 10;
    }
    return good && exponent >= 0.1 && exponent <= 10 ? exponent : 0;
}

/// The bundled config's, or that config with one more space, of the given exponent.
Space gamma_space(const std::string& name, double exponent) {
    if (const auto known = bundled_config()->getColorSpace(name.c_str()))
        return {bundled_config(), known};
    auto space = OCIO::ColorSpace::Create();
    space->setName(name.c_str());
    space->setTransform(mirrored_power(exponent), OCIO::COLORSPACE_DIR_TO_REFERENCE);
    auto config = bundled_config()->createEditableCopy();
    config->addColorSpace(space);
    return {config, config->getColorSpace(name.c_str())};
}

OCIO::ConstColorSpaceRcPtr space_in(const OCIO::ConstConfigRcPtr& config, const std::string& name) {
    // OpenImageIO calls the role by these names, whatever spaces a config has.
    if (iequals(name, "linear") || iequals(name, OCIO::ROLE_SCENE_LINEAR))
        if (auto space = config->getColorSpace(OCIO::ROLE_SCENE_LINEAR))
            return space;
    return config->getColorSpace(name.c_str());
}

/// What light= may be besides auto and encoded: the spaces, of a config without the role
/// scene_linear those of data alone, and the role by OpenImageIO's name, unless a space has it too.
/// Options end at commas, so a name that has one can only be an image's.
std::string names_in(const std::vector<OCIO::ConstConfigRcPtr>& list) {
    std::vector<std::string> names;
    bool has_role = false;
    const char* images_alone = "";
    for (const auto& config : list) {
        const bool linear = config->getColorSpace(OCIO::ROLE_SCENE_LINEAR) != nullptr;
        has_role |= linear;
        for (int i = 0; i < config->getNumColorSpaces(); ++i) {
            const std::string name = config->getColorSpaceNameByIndex(i);
            if (!linear && !config->getColorSpace(name.c_str())->isData())
                continue;
            if (name.find(',') == std::string::npos)
                names.push_back(name);
            else
                images_alone = " (names with commas: by oiio:ColorSpace only)";
        }
    }
    const bool has_linear = std::any_of(names.begin(), names.end(), [](const std::string& name) {
        return iequals(name, "linear");
    });
    if (has_role && !has_linear)
        names.insert(names.begin(), "linear");
    names.insert(names.begin(), ""); // so that the first follows a comma, too
    return OIIO::Strutil::join(names, ", ") + images_alone;
}

} // namespace

bool find_space(const std::string& name, NamedBy by, Space& found, std::string& error) {
    std::vector<OCIO::ConstConfigRcPtr> list;
    if (!configs(by, list, error))
        return false;
    found = {};
    for (const auto& config : list)
        if (auto space = space_in(config, name)) {
            // Without the role the config has no light to blend in; the bundled one has.
            if (by == NamedBy::image && !space->isData() &&
                !config->getColorSpace(OCIO::ROLE_SCENE_LINEAR))
                continue;
            found = {config, space};
            return true;
        }
    if (const double exponent = exponent_of(name); exponent != 0) {
        found = gamma_space(name, exponent);
        return true;
    }
    if (by == NamedBy::image)
        return true;
    error = format("light \"{}\" is not a colour space of the OCIO config, $OCIO or the one built "
                   "in{}, encoded{}",
                   name, allowed_lights_text, names_in(list));
    return false;
}

} // namespace ddt
