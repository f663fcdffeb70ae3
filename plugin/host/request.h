// SPDX-License-Identifier: Apache-2.0
// What a host's user asks for, as text: the filter and the light.
#pragma once

#include <string>
#include <string_view>

#include "plugin/host/enlargement.h"

namespace ddt::host {

/// Put a filter's specification ("ddt-sharp,cost=scf") and the light of the pixels (see
/// find_meaning()) into the work; an option light= of the filter counts instead of `light`. False
/// with one line in `error` for what is not allowed.
bool set_filter(std::string_view filter, std::string_view light, Enlargement& work,
                std::string& error);
/// The same of a specification that was parsed.
bool set_filter(const FilterOptions& filter, std::string_view light, Enlargement& work,
                std::string& error);

} // namespace ddt::host
