// SPDX-License-Identifier: Apache-2.0
// An image's metadata as a text, which a file of any format can carry.
#pragma once

#include <string>

#include <OpenImageIO/paramlist.h>

namespace ddt::tool {

/// A line each, whatever their types; pointers are left out.
std::string text_of(const OIIO::ParamValueList& metadata);

/// The metadata of a text that text_of() made, in its order. False, and `metadata` is empty, for
/// any other text.
bool metadata_of(const std::string& text, OIIO::ParamValueList& metadata);

} // namespace ddt::tool
