// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <vector>

#include <OpenImageIO/strutil.h>

#include "ddt/names.h"
#include "ddt/resize.h"
#include "plugin/parse_number.h"

namespace ddt {
namespace {

using OIIO::Strutil::fmt::format;

/// One key of a specification.
struct Option {
    std::string key, allowed;
    std::function<bool(Options&, const std::string&)> set; ///< false: the value is not allowed
};

/// An option whose values have names that `find(name, options)` knows.
template <class Find>
Option choice(const char* key, const std::vector<std::string>& names, Find find) {
    return {key, OIIO::Strutil::join(names, ", "),
            [=](Options& options, const std::string& text) { return find(text, options); }};
}

/// An option that is a number from `low` to `high`.
template <class Number, class Field>
Option number(const char* key, Number low, Number high, Field field) {
    const char* kind = std::is_integral_v<Number> ? "whole numbers" : "numbers";
    return {key, format("{} from {} to {}", kind, low, high),
            [=](Options& options, const std::string& text) {
                return parse_number(text, low, high, field(options));
            }};
}

const std::vector<Option>& table() {
    static const auto* options = new std::vector<Option>{
        number("blur", 0.0f, 0.25f, [](Options& o) -> float& { return o.mesh.blur; }),
        {"clipped", "0 and 1",
         [](Options& o, const std::string& text) {
             o.surface.clipped = text == "1";
             return text == "0" || text == "1";
         }},
        choice("cost", cost_names(),
               [](const std::string& name, Options& o) { return find_cost(name, o.mesh.cost); }),
        number("consistency", 0, 16, [](Options& o) -> int& { return o.surface.consistency; }),
        choice("device", device_names(),
               [](const std::string& name, Options& o) { return find_device(name, o.device); }),
        number("contour", 0.0f, most_contour, [](Options& o) -> float& { return o.mesh.contour; }),
        {"fitted", "0 and 1",
         [](Options& o, const std::string& text) {
             o.surface.fitted = text == "1";
             return text == "0" || text == "1";
         }},
        number("iterations", 0, 250, [](Options& o) -> int& { return o.mesh.max_iterations; }),
        // Whether a colour space has the name is known only once the config is read.
        {"light", "auto, encoded and names of colour spaces",
         [](Options& o, const std::string& text) {
             o.light = text;
             return !text.empty();
         }},
        number("limit", 0.0f, 1e6f, [](Options& o) -> float& { return o.surface.limit; }),
        number("meshes", 1, most_meshes, [](Options& o) -> int& { return o.mesh.meshes; }),
        number("min_gain", 0.0f, 1e6f, [](Options& o) -> float& { return o.mesh.min_gain; }),
        choice("scheme", scheme_names(),
               [](const std::string& name, Options& o) { return find_scheme(name, o.mesh); }),
        number("seed", 0u, ~0u, [](Options& o) -> uint32_t& { return o.mesh.seed; }),
        number("soft", 0.0f, 1e6f, [](Options& o) -> float& { return o.surface.soft; }),
        choice("start", start_names(),
               [](const std::string& name, Options& o) { return find_start(name, o.mesh.start); }),
    };
    return *options;
}

bool set_option(const std::string& item, Options& options, std::string& error) {
    const size_t equals = item.find('=');
    const std::string key = item.substr(0, equals);
    std::string keys;
    for (const Option& option : table()) {
        if (option.key != key) {
            keys += (keys.empty() ? "" : ", ") + option.key;
            continue;
        }
        if (equals != std::string::npos && option.set(options, item.substr(equals + 1)))
            return true;
        error = format("ddt: option \"{}\" is not allowed; allowed for {} are {}", item, key,
                       option.allowed);
        return false;
    }
    error = format("ddt: unknown option \"{}\"; allowed are {}", key, keys);
    return false;
}

} // namespace

Options::Options() {
    std::string error;
    parse_filter("ddt", *this, error);
}

bool is_filter_name(OIIO::string_view spec) {
    return find_filter(std::string(spec.substr(0, spec.find(',')))) != nullptr;
}

bool parse_filter(OIIO::string_view spec, Options& options, std::string& error) {
    const std::vector<std::string> items = OIIO::Strutil::splits(spec, ",");
    const std::string name = items.empty() ? "" : items[0];
    const FilterPreset* filter = find_filter(name);
    if (!filter) {
        error = format("ddt: unknown filter \"{}\"; allowed are {}", name,
                       OIIO::Strutil::join(filter_names(), ", "));
        return false;
    }
    // With another cost edges are not soft nor bends fitted, and min_gain is the cost's own; only
    // with this cost and scheme contours count. Other rounds of consistency than the filter's are
    // made.
    Options parsed = options;
    parsed.surface.kind = filter->kind;
    parsed.surface.consistency = filter->consistency;
    parsed.surface.soft = parsed.mesh.min_gain = -1.0f; // not given
    parsed.mesh.blur = filter->blur;
    parsed.mesh.contour = -1.0f;
    for (size_t i = 1; i < items.size(); ++i)
        if (!set_option(items[i], parsed, error))
            return false;
    const bool abn = parsed.mesh.cost == Cost::abn;
    const bool own = abn && parsed.mesh.scheme == Scheme::one_round;
    const auto is_fitted = [](const std::string& item) {
        return OIIO::Strutil::starts_with(item, "fitted=");
    };
    if (std::none_of(items.begin(), items.end(), is_fitted))
        parsed.surface.fitted =
            filter->fitted && abn && parsed.surface.consistency == filter->consistency;
    if (parsed.mesh.contour < 0)
        parsed.mesh.contour = own ? filter->contour : 0.0f;
    if (parsed.surface.soft < 0)
        parsed.surface.soft = abn ? filter->soft : 0.0f;
    if (parsed.mesh.min_gain < 0 && own)
        parsed.mesh.min_gain = filter->min_gain;
    options = parsed;
    return true;
}

} // namespace ddt
