# SPDX-License-Identifier: Apache-2.0
# Where the modules for other hosts are found by them on Debian. Each is a component, hence a package,
# of its own (cmake/Package.cmake), which a plain `cmake --install` leaves out.
#
# Not these: ImageMagick's module, whose delegates belong into a file of another package, and the
# OpenFX effect, whose folder /usr/OFX Debian does not allow.
if(TARGET ddt_gegl)
  install(TARGETS ddt_gegl LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gegl-0.4
    COMPONENT gegl EXCLUDE_FROM_ALL)
endif()
if(TARGET ddt_python)
  set(modules lib/python3/dist-packages)
  install(TARGETS ddt_python LIBRARY DESTINATION ${modules}/oiio_ddt
    COMPONENT python3 EXCLUDE_FROM_ALL)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/hosts/python/oiio_ddt DESTINATION ${modules}
    COMPONENT python3 EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  execute_process(COMMAND ${DDT_PYTHON} -c
    "from sys import version_info as v; print(f'python3 (>= {v[0]}.{v[1]}), python3 (<< {v[0]}.{v[1] + 1}), python3-numpy')"
    OUTPUT_VARIABLE CPACK_DEBIAN_PYTHON3_PACKAGE_DEPENDS OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(scripts ${PROJECT_SOURCE_DIR}/cmake/package/python3)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_CONTROL_EXTRA "${scripts}/postinst;${scripts}/prerm")
endif()
