# SPDX-License-Identifier: Apache-2.0
# Installs the libraries for other CMake projects:
#
#   find_package(oiio-ddt)                               # or COMPONENTS core
#   target_link_libraries(mine PRIVATE ddt::ddt_image)   # ImageBuf in and out
#   target_link_libraries(mine PRIVATE ddt::ddt_core)    # plain float buffers, no OpenImageIO
#
# plugin/ installs the plugin and its wrapper script itself. tests/install holds the list of all
# files that are installed.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/oiio-ddt)

set(headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
install(DIRECTORY core/include/ ${headers})
set(DDT_COMPONENTS core)
install(TARGETS ddt_core EXPORT oiio-ddt-core-targets)
if(DDT_PLUGIN)
  install(DIRECTORY plugin/include/ ${headers})
  list(APPEND DDT_COMPONENTS image)
  install(TARGETS ddt_image EXPORT oiio-ddt-image-targets)
endif()
foreach(component IN LISTS DDT_COMPONENTS)
  install(EXPORT oiio-ddt-${component}-targets NAMESPACE ddt:: DESTINATION ${package_dir})
endforeach()

set(DDT_WITH_TBB ${DDT_TBB_FOUND})
set(DDT_WITH_HIGHWAY ${DDT_HWY_FOUND})
# What they were built with and pkg-config knows, and from which version on.
set(DDT_CORE_MODULES)
if(DDT_HWY_FOUND)
  set(DDT_CORE_MODULES ${DDT_HWY_MODULE})
endif()
if(DDT_PLUGIN)
  set(DDT_IMAGE_MODULES ${DDT_OCIO_MODULE})
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

# The same for pkg-config: pkg-config --cflags --libs oiio-ddt, or oiio-ddt-core. From where the files
# lie, so that an installed tree can be moved.
file(RELATIVE_PATH DDT_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" DDT_PC_PREFIX "${DDT_PC_PREFIX}")
# ddt_install_pc(NAME LIBRARIES MODULE...)
function(ddt_install_pc DDT_PC_NAME DDT_PC_LIBS)
  string(REGEX REPLACE "([<>]=?)" " \\1 " DDT_PC_REQUIRES "${ARGN}")
  list(JOIN DDT_PC_REQUIRES ", " DDT_PC_REQUIRES)
  configure_file(cmake/package/oiio-ddt.pc.in ${DDT_PC_NAME}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${DDT_PC_NAME}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
set(pc_modules ${DDT_CORE_MODULES})
if(DDT_TBB_FOUND)
  list(APPEND pc_modules tbb)
endif()
ddt_install_pc(oiio-ddt-core "-lddt_core -pthread -ldl" ${pc_modules})
if(DDT_PLUGIN)
  string(REGEX MATCH "[0-9]+$" minor ${DDT_OIIO_SERIES})
  math(EXPR next "${minor} + 1")
  string(REGEX REPLACE "[0-9]+$" ${next} next ${DDT_OIIO_SERIES})
  ddt_install_pc(oiio-ddt -lddt_image oiio-ddt-core OpenImageIO>=${DDT_OIIO_SERIES}
    OpenImageIO<${next} ${DDT_IMAGE_MODULES})
else()
  ddt_install_pc(oiio-ddt "" oiio-ddt-core)
endif()
