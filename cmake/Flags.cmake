# Compile flags that every target gets.
#
# The bits of the result are a promise (see core/arith): no contraction of a*b+c to one rounding,
# no reordering of float sums.
add_compile_options(-ffp-contract=off -fno-fast-math)
add_compile_options(-Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wno-psabi)
if(DDT_WERROR)
  add_compile_options(-Werror)
endif()

# -DCMAKE_BUILD_TYPE=Sanitize: address and undefined-behaviour sanitizers for the unit tests.
# -g1: enough for file and line in their reports, and a quarter of the time to compile.
set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all")
# SSSE3: without Highway's emulation for machines that lack it, whose loops take minutes to compile
# when each step is checked. All other instruction sets stay.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  string(APPEND CMAKE_CXX_FLAGS_SANITIZE " -mssse3")
endif()
set(CMAKE_EXE_LINKER_FLAGS_SANITIZE "-fsanitize=address,undefined")
