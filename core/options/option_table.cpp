// SPDX-License-Identifier: Apache-2.0
#include "ddt/option_table.h"

#include <utility>

#include "core/base/parse_number.h"
#include "core/options/values.h"
#include "ddt/names.h"

namespace ddt {

namespace {

/// A row while it is being written down.
struct Row : Option {
    /// The default in a filter where it is not the field's own.
    Row& in(const char* filter, const char* value) {
        presets.push_back({filter, value});
        return *this;
    }
    /// Defaults hold for some options only.
    Row& where(bool (*holds_)(const FilterOptions&), const char* otherwise_) {
        holds = holds_;
        otherwise = otherwise_;
        return *this;
    }
    /// A negative number is called `name`.
    Row& or_negative(const char* name, const char* value_help) {
        values.push_back({name, value_help});
        get = [name, number = get](const FilterOptions& o) {
            std::string text = number(o);
            const bool below_zero = text[0] == '-' && text != "-0" && text.substr(1, 3) != "nan";
            return below_zero ? name : text;
        };
        set = [name, number = set, negative = negative](FilterOptions& o, std::string_view text) {
            if (text != name)
                return number(o, text);
            negative(o);
            return true;
        };
        return *this;
    }

    std::function<void(FilterOptions&)> negative; ///< sets -1
};

template <class T>
T& field(FilterOptions& o, T SurfaceOptions::*member) {
    return o.surface.*member;
}
template <class T>
T& field(FilterOptions& o, T MeshOptions::*member) {
    return o.mesh.*member;
}
template <class T>
T& field(FilterOptions& o, T FilterOptions::*member) {
    return o.*member;
}
template <class Part, class T>
const T& field(const FilterOptions& o, T Part::*member) {
    return field(const_cast<FilterOptions&>(o), member);
}

Row row(const char* key, OptionGroup group, OptionKind kind, const char* help, double low,
        double high, std::vector<NamedValue> values = {}, std::string others = {}) {
    Row r;
    r.key = key;
    r.group = group;
    r.kind = kind;
    r.help = help;
    r.low = low;
    r.high = high;
    r.values = std::move(values);
    r.others = std::move(others);
    return r;
}

template <class Part, class Number>
Row number(const char* key, OptionGroup group, Number Part::*member, Number low, Number high,
           const char* help) {
    constexpr bool whole = std::is_integral_v<Number>;
    Row r = row(key, group, whole ? OptionKind::whole : OptionKind::real, help, double(low),
                double(high));
    r.get = [=](const FilterOptions& o) {
        if constexpr (whole)
            return std::to_string(field(o, member));
        else
            return number_text(field(o, member));
    };
    r.set = [=](FilterOptions& o, std::string_view text) {
        return parse_number(text, low, high, field(o, member));
    };
    r.negative = [=](FilterOptions& o) { field(o, member) = Number(-1); };
    return r;
}

template <class Part>
Row toggle(const char* key, OptionGroup group, bool Part::*member, const char* help) {
    Row r = row(key, group, OptionKind::toggle, help, 0, 1);
    r.get = [=](const FilterOptions& o) { return std::string(field(o, member) ? "1" : "0"); };
    r.set = [=](FilterOptions& o, std::string_view text) {
        if (text != "0" && text != "1")
            return false;
        field(o, member) = text == "1";
        return true;
    };
    return r;
}

/// An option whose values `name_of(value)` names and `find(name, value)` knows.
template <class Part, class Value, class NameOf, class Find>
Row choice(const char* key, OptionGroup group, Value Part::*member, NameOf name_of, Find find,
           std::vector<NamedValue> values, const char* help) {
    Row r = row(key, group, OptionKind::choice, help, 0, 0, std::move(values));
    r.get = [=](const FilterOptions& o) { return std::string(name_of(field(o, member))); };
    r.set = [=](FilterOptions& o, std::string_view text) { return find(text, field(o, member)); };
    return r;
}

/// A scheme's name says two fields.
Row scheme(const char* help) {
    Row r = row("scheme", OptionGroup::mesh, OptionKind::choice, help, 0, 0, scheme_values(),
                other_schemes());
    r.get = [](const FilterOptions& o) { return scheme_name(o.mesh); };
    r.set = [](FilterOptions& o, std::string_view text) { return find_scheme(text, o.mesh); };
    return r;
}

/// Any text that is not empty and has no comma; only the host can tell whether it means something.
template <class Part>
Row text(const char* key, OptionGroup group, std::string Part::*member,
         std::vector<NamedValue> values, const char* others, const char* help) {
    Row r = row(key, group, OptionKind::text, help, 0, 0, std::move(values), others);
    r.get = [=](const FilterOptions& o) { return field(o, member); };
    r.set = [=](FilterOptions& o, std::string_view value) {
        if (value.empty() || value.find(',') != value.npos)
            return false;
        field(o, member) = std::string(value);
        return true;
    };
    return r;
}

bool is_abn(const FilterOptions& o) {
    return o.mesh.cost == Cost::abn;
}
bool is_abn_one_round(const FilterOptions& o) {
    return is_abn(o) && o.mesh.scheme == Scheme::one_round;
}
bool is_not_annealing(const FilterOptions& o) {
    return o.mesh.scheme != Scheme::annealing;
}
bool is_clipped_abn_two_rounds(const FilterOptions& o) {
    return is_abn(o) && o.surface.consistency == 2 && o.surface.clipped;
}

std::vector<Option> make_table() {
    constexpr auto colour = OptionGroup::colour, mesh = OptionGroup::mesh,
                   surface = OptionGroup::surface, device = OptionGroup::device;
    return {
        text("light", colour, &FilterOptions::light,
             {{"auto",
               "Linear light. The image's `oiio:ColorSpace` names its space; OpenColorIO converts "
               "by `$OCIO`'s config, or else a built-in one. The numbers are used as they are if "
               "it names no space that is known, or one of data, or one that only a config without "
               "the role `scene_linear` has. Many programs' BMP, DPX, FITS, ICO, IFF, RLA, SGI, "
               "TGA and TIFF name none, and OpenImageIO takes PNM for Rec709: where they are sRGB, "
               "say `light=sRGB`."},
              {"encoded", "The numbers as they are."}},
             "names of colour spaces",
             "The light in which values are interpolated. The name of a colour space of the "
             "config: linear light, and the image is in this space."),
        choice("cost", mesh, &MeshOptions::cost, cost_name, find_cost, cost_values(),
               "What an edge of the mesh costs."),
        number(
            "blur", mesh, &MeshOptions::blur, 0.0f, largest_blur,
            "Blur of the guide (the picture's brightness and alpha, one number per pixel, in which "
            "edges are sought), as the weight of each neighbour; calms the mesh.")
            .in("ddt-linear", "0")
            .in("ddt-sharp", "0.05"),
        number("contour", mesh, &MeshOptions::contour, 0.0f, most_contour,
               "Weight of the contours' direction, seen over seven pixels, beside the cost: a "
               "steadier mesh that follows them further. Unless given, 0 (the cost alone) with any "
               "cost but `abn` or any scheme but `one-round`.")
            .in("ddt-sharp", "0.4")
            .where(is_abn_one_round, "0"),
        number("meshes", mesh, &MeshOptions::meshes, 1, most_meshes,
               "So many meshes are made, of guides blurred by `blur` - 0.07 to `blur` + 0.07, and "
               "their surfaces averaged: steadier and smoother, for nearly so many times the time "
               "and memory."),
        number("min_gain", mesh, &MeshOptions::min_gain, 0.0f, largest_real,
               "A flip must lower the cost by more than this; less is noise. Unless given, `auto` "
               "with any cost but `abn` or any scheme but `one-round`.")
            .or_negative("auto", "0.005 with `abn`, and next to nothing with other costs and with "
                                 "`lawson` and the paper's schemes.")
            .in("ddt-linear", "auto")
            .in("ddt-sharp", "auto")
            .where(is_abn_one_round, "auto"),
        number("iterations", mesh, &MeshOptions::max_iterations, 0, most_iterations,
               "Rounds of flips at most; 0 keeps the starting mesh. Unless given, 64 with "
               "`annealing`.")
            .where(is_not_annealing, "64"),
        scheme("Which edges flip, in which order."),
        number("seed", mesh, &MeshOptions::seed, 0u, ~0u,
               "Another seed, another mesh of `annealing`."),
        choice("start", mesh, &MeshOptions::start, start_name, find_start, start_values(),
               "The diagonal that each cell of four pixels starts with."),
        toggle("clipped", surface, &SurfaceOptions::clipped,
               "1: values outside 0 to 1 will be cut off afterwards, as in a PNG. `ddt-sharp` may "
               "then produce them, and outlines get sharper. ImageBufs and Python arrays of "
               "unsigned 8- or 16-bit integers count as 1, but that does not turn on `fitted`."),
        number(
            "consistency", surface, &SurfaceOptions::consistency, 0, most_consistency,
            "Rounds that correct the surface so that its mean over each source pixel comes back; "
            "below 2x by the less, the nearer to 1x.")
            .in("ddt-sharp", "2"),
        toggle("fitted", surface, &SurfaceOptions::fitted,
               "1: weights fitted to pictures give the vertices and bends, in place of the rounds "
               "of `consistency`, if there are any. Unless given, 1 only in `ddt-sharp` with "
               "`clipped=1`, the cost `abn` and 2 rounds: those pictures had no highlights above "
               "white (1).")
            .in("ddt-sharp", "1")
            .where(is_clipped_abn_two_rounds, "0"),
        number("limit", surface, &SurfaceOptions::limit, 0.0f, largest_real,
               "How far a corrected pixel may leave the range of its 3x3 neighbours, as a share of "
               "that range; downwards, as a share of the darkest of them if that is less, and "
               "beside lights of 2 and more to half of itself at most, of 1 to 2 somewhat further. "
               "With `clipped` to half of the darkest, or below 0 where that is nearly black."),
        number("soft", surface, &SurfaceOptions::soft, 0.0f, largest_real,
               "Edges that would lose less than this by a flip are blended with their flipped "
               "state; steadier in sequences. Unless given, 0 with any cost but `abn`.")
            .in("ddt-linear", "0")
            .in("ddt-sharp", "0.3")
            .where(is_abn, "0"),
        choice("holes", surface, &FilterOptions::holes, holes_name, find_holes, holes_values(),
               "What becomes of missing pixels. Filling needs the whole image in memory."),
        choice("device", device, &FilterOptions::device, device_name, find_device, device_values(),
               "Where meshes are computed. No choice changes a bit of the result."),
    };
}

} // namespace

const std::vector<Option>& option_table() {
    // Never freed: a host may ask until the last moment of the process.
    static const auto* table = new std::vector<Option>(make_table());
    return *table;
}

const Option* find_option(std::string_view key) {
    for (const Option& option : option_table())
        if (key == option.key)
            return &option;
    return nullptr;
}

} // namespace ddt
