# SPDX-License-Identifier: Apache-2.0
# What the core needs, as the imported targets TBB::tbb, PkgConfig::HWY and Threads::Threads.
# Used by this project and, installed, by those that link its libraries.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
message(STATUS "oneTBB ${TBB_VERSION}, Highway ${HWY_VERSION}")
