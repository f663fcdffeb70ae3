// SPDX-License-Identifier: Apache-2.0
// The names of filters, costs, schemes, starts, devices and so on, as options, tables and tools
// spell them. The functions are safe to call from several threads at once. Those that return a
// std::string or several may throw std::bad_alloc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ddt/options.h"

namespace ddt {

/// "ddt", "ddt-linear" and "ddt-sharp".
std::vector<std::string> filter_names();

/// "abn", "scf", ...
const char* cost_name(Cost cost);
/// Set `cost` to the one of that name; false, and nothing changed, if there is none.
bool find_cost(std::string_view name, Cost& cost);
std::vector<std::string> cost_names();

/// "one-round", "exproi2-maxgain", ...: from MeshOptions::scheme and wide_iterations.
std::string scheme_name(const MeshOptions& options);
/// Set scheme and wide_iterations by name; false, and nothing changed, if there is none.
bool find_scheme(std::string_view name, MeshOptions& options);
/// All names; of the family exproi1-maxgain, exproi2-maxgain ... only the second.
std::vector<std::string> scheme_names();

/// "flat" or "diagonal".
const char* start_name(Start start);
bool find_start(std::string_view name, Start& start);
std::vector<std::string> start_names();

/// "auto", "cpu", "egl" or "osmesa".
const char* device_name(Device device);
bool find_device(std::string_view name, Device& device);
std::vector<std::string> device_names();

/// "keep", "fill" or "fill-alpha".
const char* holes_name(Holes holes);
bool find_holes(std::string_view name, Holes& holes);
std::vector<std::string> holes_names();

} // namespace ddt
