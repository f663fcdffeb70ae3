// SPDX-License-Identifier: Apache-2.0
#include "ddt/names.h"

#include "core/base/parse_number.h"
#include "core/options/values.h"

namespace ddt {

namespace {

template <class Value>
struct Named {
    Value value;
    NamedValue named;
};

constexpr Named<Cost> costs[] = {
#define DDT_NAMED(name, Class, min_gain, temperature, help) {Cost::name, {#name, help}},
    DDT_COSTS(DDT_NAMED)
#undef DDT_NAMED
};

constexpr Named<Scheme> schemes[] = {
#define DDT_NAMED(enumerator, name, help) {Scheme::enumerator, {name, help}},
    DDT_SCHEMES(DDT_NAMED)
#undef DDT_NAMED
};

constexpr Named<Start> starts[] = {
    {Start::flat, {"flat", "The diagonal that differs less."}},
    {Start::diagonal, {"diagonal", "The same diagonal everywhere."}},
};

constexpr Named<Device> devices[] = {
    {Device::automatic,
     {"auto", "The GPU by OpenGL, if there is one, its shaders know the scheme and the image is "
              "large enough: for each CPU thread 20000 source pixels, or 800000 (counting earlier "
              "images) if the GPU is yet to be opened. Else the CPU."}},
    {Device::cpu, {"cpu", "The processor's cores."}},
    {Device::egl, {"egl", "OpenGL by EGL and no other way, a software renderer included."}},
    {Device::osmesa, {"osmesa", "OpenGL by OSMesa, a software renderer."}},
};

constexpr Named<Holes> holes_table[] = {
    {Holes::keep, {"keep", "They stay as they are."}},
    {Holes::fill,
     {"fill", "Pixels with a NaN are filled over triangles of the pixels around them, so that "
              "edges run on."}},
    {Holes::fill_alpha, {"fill-alpha", "Pixels whose alpha is 0, too. Without alpha, as `fill`."}},
};

template <class Value, size_t n>
const char* name_of(const Named<Value> (&table)[n], Value value) {
    for (const auto& entry : table)
        if (entry.value == value)
            return entry.named.name;
    return "";
}

template <class Value, size_t n>
bool find(const Named<Value> (&table)[n], std::string_view name, Value& value) {
    for (const auto& entry : table)
        if (name == entry.named.name) {
            value = entry.value;
            return true;
        }
    return false;
}

template <class Value, size_t n>
std::vector<NamedValue> values_of(const Named<Value> (&table)[n]) {
    std::vector<NamedValue> values;
    for (const auto& entry : table)
        values.push_back(entry.named);
    return values;
}

template <class Value, size_t n>
std::vector<std::string> names_of(const Named<Value> (&table)[n]) {
    std::vector<std::string> names;
    for (const auto& entry : table)
        names.emplace_back(entry.named.name);
    return names;
}

constexpr std::string_view family_begin = "exproi", family_end = "-maxgain";

/// The N of "exproiN-maxgain", 1 to most_iterations; 0 for any other name.
int family_member(std::string_view name) {
    const size_t affixes = family_begin.size() + family_end.size();
    if (name.size() <= affixes || name.substr(0, family_begin.size()) != family_begin ||
        name.substr(name.size() - family_end.size()) != family_end)
        return 0;
    int n = 0;
    parse_number(name.substr(family_begin.size(), name.size() - affixes), 1, most_iterations, n);
    return n;
}

} // namespace

const char* cost_name(Cost cost) {
    return name_of(costs, cost);
}
bool find_cost(std::string_view name, Cost& cost) {
    return find(costs, name, cost);
}
std::vector<std::string> cost_names() {
    return names_of(costs);
}
std::vector<NamedValue> cost_values() {
    return values_of(costs);
}

std::string scheme_name(const MeshOptions& options) {
    if (options.scheme == Scheme::exproi_n_maxgain)
        return std::string(family_begin) + std::to_string(options.wide_iterations) +
               std::string(family_end);
    return name_of(schemes, options.scheme);
}
bool find_scheme(std::string_view name, MeshOptions& options) {
    if (const int n = family_member(name)) {
        options.scheme = Scheme::exproi_n_maxgain;
        options.wide_iterations = n;
        return true;
    }
    return find(schemes, name, options.scheme);
}
std::vector<std::string> scheme_names() {
    return names_of(schemes);
}
std::vector<NamedValue> scheme_values() {
    return values_of(schemes);
}
std::string other_schemes() {
    return std::string(family_begin) + "N" + std::string(family_end) + " for N from 1 to " +
           std::to_string(most_iterations);
}

const char* start_name(Start start) {
    return name_of(starts, start);
}
bool find_start(std::string_view name, Start& start) {
    return find(starts, name, start);
}
std::vector<std::string> start_names() {
    return names_of(starts);
}
std::vector<NamedValue> start_values() {
    return values_of(starts);
}

const char* device_name(Device device) {
    return name_of(devices, device);
}
bool find_device(std::string_view name, Device& device) {
    return find(devices, name, device);
}
std::vector<std::string> device_names() {
    return names_of(devices);
}
std::vector<NamedValue> device_values() {
    return values_of(devices);
}

const char* holes_name(Holes holes) {
    return name_of(holes_table, holes);
}
bool find_holes(std::string_view name, Holes& holes) {
    return find(holes_table, name, holes);
}
std::vector<std::string> holes_names() {
    return names_of(holes_table);
}
std::vector<NamedValue> holes_values() {
    return values_of(holes_table);
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

} // namespace ddt
