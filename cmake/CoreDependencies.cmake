# SPDX-License-Identifier: Apache-2.0
# What the core needs, Threads::Threads, and what it can use, PkgConfig::DDT_HWY (an empty target where
# Highway is left out) and, if DDT_TBB_FOUND, TBB::tbb. Used by this project, where DDT_HIGHWAY and DDT_TBB
# are the user's wishes and DDT_NEEDED is QUIET, and, installed, by those that link its libraries, where they say
# what these were built with and DDT_NEEDED is REQUIRED. Names begin with DDT_, since those who link may
# look for the same packages in ways of their own. A find_package(oiio-ddt QUIET) is told nothing.
set(ddt_quiet)
set(ddt_status STATUS)
if(${CMAKE_FIND_PACKAGE_NAME}_FIND_QUIETLY)
  set(ddt_quiet QUIET)
  set(ddt_status VERBOSE)
endif()
find_package(Threads REQUIRED ${ddt_quiet})
find_package(PkgConfig REQUIRED ${ddt_quiet})
set(DDT_TBB_FOUND FALSE)
if(DDT_TBB)
  # By its own package: who links may have a FindTBB, which need not make its target.
  find_package(TBB CONFIG ${DDT_NEEDED} ${ddt_quiet})
  set(DDT_TBB_FOUND ${TBB_FOUND})
endif()
if(DDT_TBB_FOUND)
  message(${ddt_status} "oneTBB ${TBB_VERSION}")
else()
  message(${ddt_status} "oneTBB: left out; work is shared among threads that end with the call")
endif()
set(DDT_HWY_FOUND FALSE)
set(DDT_HWY_MODULE libhwy>=1.0)
if(DDT_HIGHWAY)
  pkg_check_modules(DDT_HWY ${DDT_NEEDED} ${ddt_quiet} IMPORTED_TARGET ${DDT_HWY_MODULE})
endif()
if(DDT_HWY_FOUND)
  message(${ddt_status} "Highway ${DDT_HWY_VERSION}")
else()
  message(${ddt_status} "Highway: left out; one instruction set, the one that the compiler is told to use")
  if(NOT TARGET PkgConfig::DDT_HWY)
    add_library(PkgConfig::DDT_HWY INTERFACE IMPORTED)
  endif()
endif()
