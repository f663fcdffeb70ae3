# SPDX-License-Identifier: Apache-2.0
# Installs the libraries for other CMake projects:
#
#   find_package(oiio-ddt)
#   target_link_libraries(mine PRIVATE ddt::ddt_image)   # ImageBuf in and out
#   target_link_libraries(mine PRIVATE ddt::ddt_core)    # plain float buffers, no OpenImageIO
#
# plugin/ installs the plugin and its wrapper script itself. tests/install holds the list of all
# files that are installed.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/oiio-ddt)

install(DIRECTORY core/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS ddt_core EXPORT oiio-ddt-targets)
if(DDT_PLUGIN)
  install(DIRECTORY plugin/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(TARGETS ddt_image EXPORT oiio-ddt-targets)
endif()
install(EXPORT oiio-ddt-targets NAMESPACE ddt:: DESTINATION ${package_dir})

set(DDT_WITH_TBB ${DDT_TBB_FOUND})
set(DDT_WITH_HIGHWAY ${DDT_HWY_FOUND})
# What they were built with and pkg-config knows, and from which version on.
set(DDT_WITH_MODULES)
if(DDT_PLUGIN)
  string(APPEND DDT_WITH_MODULES " OpenColorIO>=2.1")
endif()
if(DDT_HWY_FOUND)
  string(APPEND DDT_WITH_MODULES " libhwy>=1.0")
endif()
if(DDT_GEOS_FOUND)
  string(APPEND DDT_WITH_MODULES " geos>=3.6")
endif()
if(DDT_PLUGIN)
  string(REGEX MATCH "^[0-9]+[.][0-9]+" DDT_OIIO_SERIES "${OpenImageIO_VERSION}")
endif()
configure_package_config_file(cmake/oiio-ddt-config.cmake.in oiio-ddt-config.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/oiio-ddt-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/oiio-ddt-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/oiio-ddt-config-version.cmake
  cmake/CoreDependencies.cmake cmake/ImageDependencies.cmake
  DESTINATION ${package_dir})

# The same for pkg-config: pkg-config --cflags --libs oiio-ddt
string(REGEX REPLACE ">=[^ ]*" "" DDT_PC_REQUIRES "${DDT_WITH_MODULES}")
set(DDT_PC_LIBS -lddt_core)
if(DDT_TBB_FOUND)
  string(APPEND DDT_PC_REQUIRES " tbb")
endif()
if(DDT_PLUGIN)
  string(PREPEND DDT_PC_REQUIRES "OpenImageIO")
  set(DDT_PC_LIBS "-lddt_image -lddt_core")
endif()
# From where the file lies, so that an installed tree can be moved.
file(RELATIVE_PATH DDT_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/package/oiio-ddt.pc.in oiio-ddt.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/oiio-ddt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
