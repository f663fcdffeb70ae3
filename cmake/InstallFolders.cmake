# SPDX-License-Identifier: Apache-2.0
# Folders that a plain `cmake --install` makes are for everybody, whatever the umask of who installs,
# which CMake keeps to. Those that were there stay as they are: included before the first install(), this
# notes which of these folders and of all those above them are not there yet.
set(folders
  ${CMAKE_INSTALL_BINDIR}
  ${CMAKE_INSTALL_INCLUDEDIR}/ddt
  ${CMAKE_INSTALL_LIBDIR}/cmake/oiio-ddt
  ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  ${DDT_PLUGIN_INSTALL_DIR}
  ${CMAKE_INSTALL_MANDIR}/man1
  ${CMAKE_INSTALL_DATADIR}/doc/oiio-ddt
  ${CMAKE_INSTALL_DATADIR}/oiio-ddt
  ../etc/profile.d) # which ddt_profile() (cmake/Package.cmake) makes for some prefixes
install(CODE "set(ddt_folders \"${folders}\")")
install(CODE [[
  set(ddt_missing)
  foreach(folder IN LISTS ddt_folders)
    # Without .., for what is asked for before the prefix is there.
    get_filename_component(folder "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}" ABSOLUTE)
    while(NOT EXISTS "${folder}")
      list(APPEND ddt_missing "${folder}")
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
