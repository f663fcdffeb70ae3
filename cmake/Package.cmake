# SPDX-License-Identifier: Apache-2.0
# Debian packages: cmake --build build --target package writes build/oiio-ddt_VERSION_ARCH.deb.
#
# What is installed under another component's name than the default makes a package of its own,
# oiio-ddt-COMPONENT (cmake/HostPackages.cmake). To be included after everything is installed.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME oiio-ddt)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
# Nobody's address: whoever hands the package on gives their own.
set(DDT_PACKAGE_CONTACT "the oiio-ddt authors <oiio-ddt@example.org>" CACHE STRING
  "The Debian package's maintainer, as Name <address>")
set(CPACK_PACKAGE_CONTACT "${DDT_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package/options.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/permissions.cmake)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
list(REMOVE_ITEM CPACK_COMPONENTS_ALL Unspecified)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "image enlargement by data-dependent triangulation")
set(CPACK_COMPONENT_OIIO-DDT_DESCRIPTION
"A plugin adds the filters ddt, ddt-linear and ddt-sharp to programs that use
OpenImageIO, such as oiiotool and maketx. The command ddt enlarges images,
sequences and parts of images, and there is a library for C++.")
set(CPACK_DEBIAN_OIIO-DDT_PACKAGE_NAME oiio-ddt)
set(CPACK_DEBIAN_OIIO-DDT_PACKAGE_DEPENDS openimageio-tools)
set(CPACK_DEBIAN_OIIO-DDT_PACKAGE_SUGGESTS
  "libopenimageio-dev, libopencolorio-dev, libtbb-dev, libhwy-dev")

# Not in a component that is packaged: Debian has the text, and wants it in no package of its own.
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/oiio-ddt COMPONENT licence)

# Debian's policy: each package says whose it is and what changed.
set(documents ${CMAKE_CURRENT_BINARY_DIR}/package)
configure_file(cmake/package/copyright ${documents}/copyright COPYONLY)
configure_file(cmake/package/changelog.txt ${documents}/changelog @ONLY)
execute_process(COMMAND gzip -9nkf ${documents}/changelog COMMAND_ERROR_IS_FATAL ANY)
set(host_gegl "GEGL and GIMP: gegl:ddt")
set(host_imagemagick "ImageMagick: convert -process ddt")
set(host_openfx "OpenFX hosts: Enlarge (ddt)")
set(host_python3 "Python: oiio_ddt")
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(package oiio-ddt)
  set(only_packaged)
  if(NOT component STREQUAL oiio-ddt)
    string(APPEND package -${component})
    set(only_packaged EXCLUDE_FROM_ALL)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
    set(CPACK_COMPONENT_${upper}_DESCRIPTION
      "The filters ddt, ddt-linear and ddt-sharp of oiio-ddt,
for ${host_${component}}.")
  endif()
  install(FILES ${documents}/copyright ${documents}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} ${only_packaged})
endforeach()

# Login shells tell hosts where plugins are, by `script`. By the GNU standards /etc belongs to the
# prefix /usr, which the script names; others get neither. A link, and not a file that dpkg would keep
# as the user's on removal. Further arguments are install()'s.
function(ddt_profile package script)
  configure_file(${script} ${documents}/${package}/profile.sh @ONLY)
  install(CODE "
    if(CMAKE_INSTALL_PREFIX MATCHES \"^/usr$|/_CPack_Packages/.*/usr$\")
      file(INSTALL \"${documents}/${package}/profile.sh\"
        DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/${package}\")
      set(etc \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/../etc/profile.d\")
      file(MAKE_DIRECTORY \"\${etc}\")
      set(link \"\${etc}/${package}.sh\")
      message(STATUS \"Installing: \${link}\")
      file(CREATE_LINK /usr/${CMAKE_INSTALL_DATADIR}/${package}/profile.sh \"\${link}\" SYMBOLIC)
      list(APPEND CMAKE_INSTALL_MANIFEST_FILES /etc/profile.d/${package}.sh)
    endif()" ${ARGN})
endfunction()
ddt_profile(oiio-ddt cmake/package/profile.sh.in COMPONENT oiio-ddt)
if(TARGET ddt_openfx)
  ddt_profile(oiio-ddt-openfx cmake/package/profile-openfx.sh.in COMPONENT openfx EXCLUDE_FROM_ALL)
endif()
# The target package_source: what is not built.
set(CPACK_SOURCE_GENERATOR TGZ)
string(REGEX REPLACE "([][+.*?()^$|\\])" "\\\\\\1" build "${PROJECT_BINARY_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${build}/" "/[.]git/")
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
