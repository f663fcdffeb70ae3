# SPDX-License-Identifier: Apache-2.0
# Makes the file SHADERS_CPP of the shader files FILES (a ;-list of paths), as the table declared in
# core/gl/shader_text.h. Run at build time: cmake -DFILES=... -DSHADERS_CPP=... -P EmbedShaders.cmake
set(table "")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND table "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${SHADERS_CPP} "// Made by cmake/EmbedShaders.cmake from shaders/.
#include \"core/gl/shader_text.h\"

namespace ddt::gl {

const ShaderText shader_texts[] = {
${table}    {nullptr, nullptr}};

} // namespace ddt::gl
")
