# SPDX-License-Identifier: Apache-2.0
# What the core needs, as the imported targets TBB::tbb, PkgConfig::HWY and Threads::Threads, and what
# it can use, PkgConfig::GEOS. Used by this project and, installed, by those that link its libraries.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
message(STATUS "oneTBB ${TBB_VERSION}, Highway ${HWY_VERSION}")
pkg_check_modules(GEOS QUIET IMPORTED_TARGET geos>=3.6)
if(GEOS_FOUND)
  message(STATUS "GEOS ${GEOS_VERSION}: points can be triangulated (ddt scatter, ddt fill, holes=fill)")
else()
  message(STATUS "GEOS not found: no ddt scatter without triangles, no ddt fill, no holes=fill")
endif()
