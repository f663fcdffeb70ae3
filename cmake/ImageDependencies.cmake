# SPDX-License-Identifier: Apache-2.0
# The image libraries the plugin and the ImageBuf library need, as the imported targets
# OpenImageIO::OpenImageIO and PkgConfig::DDT_OCIO. Used as CoreDependencies.cmake is, after it.
# By its own package: who links may have a FindOpenImageIO, which need not make its target. No version
# here: OpenImageIO's own check refuses another major one than is asked for.
find_package(OpenImageIO CONFIG REQUIRED ${ddt_quiet})
if(OpenImageIO_VERSION VERSION_LESS 2.4)
  message(FATAL_ERROR "OpenImageIO ${OpenImageIO_VERSION} is too old: 2.4 or later is needed")
endif()

# Debian's OpenImageIO names OpenCV's headers among its own, though nothing public uses them and
# the package does not bring them along; CMake refuses folders that are not there.
get_target_property(ddt_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach(ddt_folder IN LISTS ddt_folders)
  if(IS_ABSOLUTE "${ddt_folder}" AND NOT EXISTS "${ddt_folder}")
    list(REMOVE_ITEM ddt_folders "${ddt_folder}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${ddt_folders}")
unset(ddt_folders)

# By pkg-config: Debian's CMake config of OpenColorIO names an include folder that is not there.
set(DDT_OCIO_MODULE OpenColorIO>=2.1)
pkg_check_modules(DDT_OCIO REQUIRED ${ddt_quiet} IMPORTED_TARGET ${DDT_OCIO_MODULE})
message(${ddt_status} "OpenImageIO ${OpenImageIO_VERSION}, OpenColorIO ${DDT_OCIO_VERSION}")
