# SPDX-License-Identifier: Apache-2.0
# Compile flags that every target gets.
#
# The bits of the result are a promise (see core/base/arith.h): no contraction of a*b+c to one rounding,
# no reordering of float sums.
add_compile_options(-ffp-contract=off -fno-fast-math)
add_compile_options(-Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wno-psabi)
# A scheme, cost or device that is added is named wherever one is chosen by its name.
add_compile_options(-Werror=switch)
# Conditions without branches are meant so (core/lattice).
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14)
  add_compile_options(-Wno-bitwise-instead-of-logical)
endif()
# What Highway calls NEON has AES, of which nothing here is used. For all code, or what the compiler
# adds to it by itself, members of classes, could not be part of what has it.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64" AND NOT CMAKE_CXX_FLAGS MATCHES "-m(arch|cpu)=")
  add_compile_options(-march=armv8-a+crypto)
endif()
if(DDT_WERROR)
  add_compile_options(-Werror)
endif()
# Several files compiled as one, in which a file's own names are those of the files after it, too.
set(DDT_UNITY_WARNINGS -Wno-shadow)
if(CMAKE_UNITY_BUILD)
  add_compile_options(${DDT_UNITY_WARNINGS})
endif()

# For code that takes no time to run, tests and the command line: less to compile.
set(DDT_BRIEFLY $<$<CONFIG:Release>:-O1>)
# For code that does. With -O2, which RelWithDebInfo and distributions compile with, loops over channels
# stay loops and less is inlined: ddt takes 1.4 to 1.65 times as long (kodim23 at 2x, 17.1 and 28.1 ns a
# pixel).
set(DDT_FAST $<$<CONFIG:RelWithDebInfo>:-O3>)
if(CMAKE_CXX_FLAGS MATCHES "-O2( |$)")
  set(DDT_FAST -O3)
endif()

# -DCMAKE_BUILD_TYPE=Sanitize: address and undefined-behaviour sanitizers for the unit tests.
# -g1: enough for file and line in their reports, and a quarter of the time to compile.
set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -DDDT_ADDRESS_SANITIZER")
# What the address sanitizer or the processor finds as well need not be checked at every access: half
# of the time to compile.
string(APPEND CMAKE_CXX_FLAGS_SANITIZE " -fno-sanitize=null,object-size,alignment,pointer-overflow")
# GCC 12 takes the standard library's own members for uninitialised under the sanitizers.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND CMAKE_CXX_FLAGS_SANITIZE " -Wno-maybe-uninitialized")
endif()
# Of the instruction sets one narrow and one wide: compiling each takes a while when every step is
# checked.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  string(APPEND CMAKE_CXX_FLAGS_SANITIZE
    " -mssse3 '-DHWY_DISABLED_TARGETS=~(HWY_SSSE3|HWY_AVX2)'")
endif()
# For folders whose code is mostly OpenImageIO's templates, or calls of a driver, and has few loops: half
# of the time to compile.
set(DDT_SANITIZE_QUICKLY $<$<CONFIG:Sanitize>:-O0>)
set(CMAKE_EXE_LINKER_FLAGS_SANITIZE "-fsanitize=address,undefined")

# -DCMAKE_BUILD_TYPE=Threads: the thread sanitizer, for tests/threads. One instruction set: threads are
# the same in all.
set(CMAKE_CXX_FLAGS_THREADS "-O1 -g1 -fsanitize=thread -Wno-tsan -DDDT_THREAD_SANITIZER")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  string(APPEND CMAKE_CXX_FLAGS_THREADS " -mssse3 -DHWY_DISABLED_TARGETS=~HWY_SSSE3")
endif()
set(CMAKE_EXE_LINKER_FLAGS_THREADS "-fsanitize=thread")

# Highway's functions on vectors of a wider instruction set than the rest is compiled for must be inlined,
# which they are not with -O0: GCC 12 breaks off, and what it makes of others crashes. Nor does a build
# type, which may be any, or none, have to ask for optimisation.
function(ddt_optimisation type result)
  string(TOUPPER "${type}" type)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  list(FILTER flags INCLUDE REGEX "^-O([0-3gsz]|fast)?$")
  set(last)
  if(flags)
    list(GET flags -1 last)
  endif()
  set(level)
  if(last STREQUAL "-O0" OR (NOT last AND type STREQUAL "DEBUG"))
    set(level -Og)
  elseif(NOT last)
    set(level -O2)
  endif()
  set(${result} "${level}" PARENT_SCOPE)
endfunction()
if(CMAKE_CONFIGURATION_TYPES)
  foreach(type IN LISTS CMAKE_CONFIGURATION_TYPES)
    ddt_optimisation(${type} level)
    add_compile_options("$<$<CONFIG:${type}>:${level}>")
  endforeach()
else()
  ddt_optimisation("${CMAKE_BUILD_TYPE}" level)
  add_compile_options(${level})
endif()

# With clang also what libFuzzer goes by, for tests/fuzz.
if(CMAKE_BUILD_TYPE STREQUAL "Sanitize" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set(DDT_LIBFUZZER ON)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
