# SPDX-License-Identifier: Apache-2.0
# Folders that a plain `cmake --install` makes are for everybody, whatever the umask of who installs,
# which CMake keeps to. Those that were there stay as they are: included before the first install(), this
# notes which of these folders and of those above them, up to the prefix, are not there yet.
set(folders
  ${CMAKE_INSTALL_BINDIR}
  ${CMAKE_INSTALL_INCLUDEDIR}/ddt
  ${CMAKE_INSTALL_LIBDIR}/cmake/oiio-ddt
  ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  ${DDT_PLUGIN_INSTALL_DIR}
  ${CMAKE_INSTALL_MANDIR}/man1
  ${CMAKE_INSTALL_DATADIR}/doc/oiio-ddt
  ${CMAKE_INSTALL_DATADIR}/oiio-ddt)
install(CODE "set(ddt_folders \"${folders}\")")
install(CODE [[
  set(ddt_missing)
  foreach(folder IN LISTS ddt_folders)
    while(NOT EXISTS "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}")
      list(APPEND ddt_missing "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}")
      if(folder STREQUAL "" OR folder STREQUAL "/")
        break()
      endif()
      get_filename_component(folder "${folder}" DIRECTORY)
    endwhile()
  endforeach()]])

# To be called after the last install().
function(ddt_open_new_folders)
  install(CODE [[
    foreach(folder IN LISTS ddt_missing)
      if(IS_DIRECTORY "${folder}")
        file(CHMOD "${folder}" DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
          GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
      endif()
    endforeach()]])
endfunction()
