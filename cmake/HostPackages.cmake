# SPDX-License-Identifier: Apache-2.0
# Where the modules for other hosts are found by them on Debian. Each is a component, hence a package,
# of its own (cmake/Package.cmake), which a plain `cmake --install` leaves out.
#
# OpenFX's own folder, /usr/OFX, Debian does not allow: the effect is in a folder that login shells
# name in OFX_PLUGIN_PATH (cmake/Package.cmake). ImageMagick's delegates belong into a file of another
# package, and lie among the documents as an example.
if(TARGET ddt_gegl)
  install(TARGETS ddt_gegl LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gegl-0.4
    COMPONENT gegl EXCLUDE_FROM_ALL)
endif()
if(TARGET ddt_python)
  set(modules lib/python3/dist-packages)
  install(TARGETS ddt_python LIBRARY DESTINATION ${modules}/oiio_ddt
    COMPONENT python3 EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/hosts/python/oiio_ddt DESTINATION ${modules}
    COMPONENT python3 EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  execute_process(COMMAND ${DDT_PYTHON} -c
    "from sys import version_info as v; print(f'python3 (>= {v[0]}.{v[1]}), python3 (<< {v[0]}.{v[1] + 1}), python3-numpy')"
    OUTPUT_VARIABLE CPACK_DEBIAN_PYTHON3_PACKAGE_DEPENDS OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(scripts ${PROJECT_SOURCE_DIR}/cmake/package/python3)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_CONTROL_EXTRA "${scripts}/postinst;${scripts}/prerm")
endif()
if(TARGET ddt_imagemagick)
  # Where the library looks for filters; its package makes the folder.
  get_target_property(quantum ddt_imagemagick DDT_QUANTUM)
  file(GLOB folders
    ${MagickCore_LIBDIR}/ImageMagick-${MagickCore_VERSION}*/modules-${quantum}/filters)
  set(DDT_FILTERS_FROM_LIB)
  if(folders)
    file(RELATIVE_PATH DDT_FILTERS_FROM_LIB "${MagickCore_LIBDIR}" "${folders}")
  endif()
  if(DDT_FILTERS_FROM_LIB MATCHES "^ImageMagick-[^;]*/filters$")
    set(filters ${CMAKE_INSTALL_LIBDIR}/${DDT_FILTERS_FROM_LIB})
    install(TARGETS ddt_imagemagick LIBRARY DESTINATION ${filters}
      COMPONENT imagemagick EXCLUDE_FROM_ALL)
    install(FILES plugin/imagemagick/ddt.la DESTINATION ${filters}
      COMPONENT imagemagick EXCLUDE_FROM_ALL)
    install(FILES plugin/imagemagick/delegates.xml
      DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/oiio-ddt-imagemagick/examples
      COMPONENT imagemagick EXCLUDE_FROM_ALL)
    set(CPACK_DEBIAN_IMAGEMAGICK_PACKAGE_SUGGESTS oiio-ddt) # the delegates' program
  else()
    message(STATUS "ImageMagick's package: left out (its folder of filters is not one: \"${folders}\")")
  endif()
endif()
if(TARGET ddt_openfx)
  set(DDT_OFX_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/OFX/Plugins)
  get_target_property(built ddt_openfx LIBRARY_OUTPUT_DIRECTORY)
  file(RELATIVE_PATH in_bundle ${PROJECT_BINARY_DIR}/hosts/openfx ${built})
  install(TARGETS ddt_openfx LIBRARY DESTINATION ${DDT_OFX_INSTALL_DIR}/${in_bundle}
    COMPONENT openfx EXCLUDE_FROM_ALL)
endif()
