# SPDX-License-Identifier: Apache-2.0
# Run by CPack for each kind of package.

# Without these packages have no dependencies, or CPack's reason is hard to find.
if(CPACK_GENERATOR STREQUAL "DEB")
  foreach(program dpkg-shlibdeps file)
    find_program(found_${program} ${program})
    if(NOT found_${program})
      message(FATAL_ERROR "Debian packages need ${program}: install dpkg-dev and file")
    endif()
  endforeach()
endif()

# Sources are not installed anywhere.
if(CPACK_TOPLEVEL_TAG MATCHES "Source$")
  set(CPACK_PACKAGING_INSTALL_PREFIX /)
endif()
