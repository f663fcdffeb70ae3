// SPDX-License-Identifier: Apache-2.0
#include "ddt/names.h"

#include <charconv>

namespace ddt {

namespace {

template <class Value>
struct Named {
    const char* name;
    Value value;
};

constexpr FilterPreset filters[] = {
    {"ddt", Surface::patch, 0, 0.4f, 0.1f, 0.07f, 0.8f, false},
    {"ddt-linear", Surface::linear, 0, 0.0f, -1.0f, 0.0f, 0.8f, false},
    {"ddt-sharp", Surface::patch, 2, 0.3f, -1.0f, 0.05f, 0.4f, false}};

constexpr Named<Cost> costs[] = {
#define DDT_NAMED_COST(name, ...) {#name, Cost::name},
    DDT_COSTS(DDT_NAMED_COST)
#undef DDT_NAMED_COST
};

constexpr Named<Scheme> schemes[] = {
    {"one-round", Scheme::one_round},
    {"lawson", Scheme::lawson},
    {"basic", Scheme::basic},
    {"exproi", Scheme::exproi},
    {"maxgain", Scheme::maxgain},
    {"exproi-maxgain", Scheme::exproi_maxgain},
    {"exproiN-maxgain", Scheme::exproi_n_maxgain},
    {"look-ahead", Scheme::look_ahead},
    {"annealing", Scheme::annealing},
    {"pixel", Scheme::pixel},
};

constexpr Named<Device> devices[] = {{"auto", Device::automatic},
                                     {"cpu", Device::cpu},
                                     {"egl", Device::egl},
                                     {"osmesa", Device::osmesa}};
constexpr Named<Start> starts[] = {{"flat", Start::flat}, {"diagonal", Start::diagonal}};

template <class Value, size_t n>
const char* name_of(const Named<Value> (&table)[n], Value value) {
    for (const auto& entry : table)
        if (entry.value == value)
            return entry.name;
    return "";
}

template <class Value, size_t n>
bool find(const Named<Value> (&table)[n], std::string_view name, Value& value) {
    for (const auto& entry : table)
        if (name == entry.name) {
            value = entry.value;
            return true;
        }
    return false;
}

template <class Value, size_t n>
std::vector<std::string> names_of(const Named<Value> (&table)[n]) {
    std::vector<std::string> names;
    for (const auto& entry : table)
        names.emplace_back(entry.name);
    return names;
}

constexpr std::string_view family_begin = "exproi", family_end = "-maxgain";

/// The N of "exproiN-maxgain", 1 to 250; 0 for any other name.
int family_member(std::string_view name) {
    const size_t affixes = family_begin.size() + family_end.size();
    if (name.size() <= affixes || name.substr(0, family_begin.size()) != family_begin ||
        name.substr(name.size() - family_end.size()) != family_end)
        return 0;
    const std::string_view digits = name.substr(family_begin.size(), name.size() - affixes);
    int n = 0;
    const char* end = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), end, n);
    return parsed.ec == std::errc() && parsed.ptr == end && n >= 1 && n <= 250 ? n : 0;
}

} // namespace

const FilterPreset* find_filter(std::string_view name) {
    for (const FilterPreset& filter : filters)
        if (name == filter.name)
            return &filter;
    return nullptr;
}
std::vector<std::string> filter_names() {
    std::vector<std::string> names;
    for (const FilterPreset& filter : filters)
        names.emplace_back(filter.name);
    return names;
}
bool set_filter(std::string_view name, SurfaceOptions& surface, MeshOptions& mesh) {
    const FilterPreset* filter = find_filter(name);
    if (!filter)
        return false;
    surface.kind = filter->kind;
    surface.consistency = filter->consistency;
    surface.soft = filter->soft;
    surface.fitted = filter->fitted;
    mesh.cost = Cost::abn;
    mesh.scheme = Scheme::one_round;
    mesh.min_gain = filter->min_gain;
    mesh.blur = filter->blur;
    mesh.contour = filter->contour;
    return true;
}

const char* cost_name(Cost cost) {
    return name_of(costs, cost);
}
bool find_cost(std::string_view name, Cost& cost) {
    return find(costs, name, cost);
}
std::vector<std::string> cost_names() {
    return names_of(costs);
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
    Scheme scheme;
    if (!find(schemes, name, scheme) || scheme == Scheme::exproi_n_maxgain)
        return false;
    options.scheme = scheme;
    return true;
}
std::vector<std::string> scheme_names() {
    return names_of(schemes);
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

const char* device_name(Device device) {
    return name_of(devices, device);
}
bool find_device(std::string_view name, Device& device) {
    return find(devices, name, device);
}
std::vector<std::string> device_names() {
    return names_of(devices);
}

} // namespace ddt
