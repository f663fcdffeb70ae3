# SPDX-License-Identifier: Apache-2.0
# Make the module `target` show the symbols named after it and no others, and take none of the
# program's, or of another such module's, for its own. Hidden visibility alone does not: templates of
# the standard library are shown all the same, as what the standard library declares is. -Xlinker,
# since -Wl would end a path at its first comma.
function(ddt_entry_points target)
  string(REPLACE ";" "; " symbols "${ARGN}")
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${target}.map)
  file(CONFIGURE OUTPUT ${script} CONTENT "{ global: ${symbols}; local: *; };\n" @ONLY)
  set_target_properties(${target} PROPERTIES LINK_DEPENDS ${script})
  target_link_options(${target} PRIVATE "SHELL:-Xlinker \"--version-script=${script}\"" -Wl,-Bsymbolic)
endfunction()
