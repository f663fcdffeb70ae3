# SPDX-License-Identifier: Apache-2.0
# The image libraries the plugin and the ImageBuf library need, as the imported targets
# OpenImageIO::OpenImageIO and PkgConfig::OpenColorIO. Used as CoreDependencies.cmake is, after it.
find_package(OpenImageIO 2.4 REQUIRED)

# Debian's OpenImageIO names OpenCV's headers among its own, though nothing public uses them and
# the package does not bring them along; CMake refuses folders that are not there.
get_target_property(folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach(folder ${folders})
  if(NOT EXISTS ${folder})
    list(REMOVE_ITEM folders ${folder})
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${folders}")

# By pkg-config: Debian's CMake config of OpenColorIO names an include folder that is not there.
pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)
message(STATUS "OpenImageIO ${OpenImageIO_VERSION}, OpenColorIO ${OpenColorIO_VERSION}")
