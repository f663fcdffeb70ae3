// SPDX-License-Identifier: Apache-2.0
// The shaders of the folder shaders/, embedded when this was built.
#pragma once

namespace ddt::gl {

struct ShaderText {
    const char* name; ///< the file's; null ends the table
    const char* text;
};
extern const ShaderText shader_texts[];

} // namespace ddt::gl
