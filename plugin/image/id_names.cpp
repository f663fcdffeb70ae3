// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/id_names.h"

#include <algorithm>
#include <cctype>

#include <OpenImageIO/strutil.h>

namespace ddt {
namespace {

using OIIO::Strutil::icontains;
using OIIO::Strutil::iends_with;
using OIIO::Strutil::iequals;
using OIIO::Strutil::istarts_with;

bool letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c));
}
bool digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c));
}
bool upper(char c) {
    return std::isupper(static_cast<unsigned char>(c));
}

/// `name` is layer, then two digits, then nothing or a dot and more: a rank of a cryptomatte.
bool is_rank_of(OIIO::string_view name, OIIO::string_view layer) {
    if (layer.empty() || !istarts_with(name, layer))
        return false;
    name.remove_prefix(layer.size());
    return name.size() >= 2 && digit(name[0]) && digit(name[1]) &&
           (name.size() == 2 || name[2] == '.');
}

/// Also without metadata: "uCryptoAsset00", "crypto_v2_object00" and their like.
bool looks_like_rank(const std::string& piece) {
    return icontains(piece, "crypto") && digit(piece.back()) && digit(piece[piece.size() - 2]);
}

/// As Blender calls objects' and materials' numbers.
bool ends_with_index(const std::string& layer) {
    for (const char* index : {"IndexOB", "IndexMA", "Object Index", "Material Index"})
        if (iends_with(layer, index))
            return true;
    return false;
}

} // namespace

bool is_id_name(OIIO::string_view name) {
    if (!iends_with(name, "id"))
        return false;
    size_t start = name.size() - 1;
    while (start > 0 && letter(name[start - 1]) && !(upper(name[start]) && !upper(name[start - 1])))
        --start;
    // "ID" itself is two capitals: a word that starts at its D starts at its I.
    const OIIO::string_view word = name.substr(std::min(start, name.size() - 2));
    static const char* const of_what[] = {
        "",          "asset",    "cell",     "class",    "component", "curve",   "element",
        "entity",    "face",     "g",        "geometry", "group",     "gu",      "inst",
        "instance",  "item",     "label",    "layer",    "light",     "mat",     "material",
        "mesh",      "model",    "mtl",      "node",     "obj",       "object",  "parent",
        "part",      "particle", "pixel",    "point",    "poly",      "polygon", "prim",
        "primitive", "region",   "render",   "scene",    "segment",   "shader",  "shape",
        "surface",   "tri",      "triangle", "u",        "user",      "uu",      "vert",
        "vertex"};
    const OIIO::string_view stem = word.substr(0, word.size() - 2);
    return std::any_of(std::begin(of_what), std::end(of_what),
                       [&](const char* what) { return iequals(stem, what); });
}

std::vector<std::string> cryptomattes(const OIIO::ImageSpec& spec) {
    std::vector<std::string> names;
    for (const auto& attribute : spec.extra_attribs)
        if (istarts_with(attribute.name(), "cryptomatte/") && iends_with(attribute.name(), "/name"))
            names.push_back(attribute.get_string());
    return names;
}

bool is_cryptomatte(const std::string& name, const std::vector<std::string>& known) {
    const std::vector<std::string> pieces = pieces_of(name);
    return std::any_of(pieces.begin(), pieces.end(), looks_like_rank) ||
           std::any_of(known.begin(), known.end(),
                       [&](const std::string& layer) { return is_rank_of(name, layer); });
}

bool is_layer_of_ids(const Layer& layer) {
    return layer.channels.size() == 1 &&
           is_any_of(layer.components.front(), {"r", "red", "v", "value", "x", "y", "z"}) &&
           (is_id_name(layer.name) || ends_with_index(layer.name));
}

} // namespace ddt
