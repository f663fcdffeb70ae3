# SPDX-License-Identifier: Apache-2.0
# The unit tests once more, compiled with the address and undefined-behaviour sanitizers; by clang
# where there is one, for then the fuzzers are libFuzzer's and run too. A folder has one compiler.
find_program(DDT_CLANG clang)
find_program(DDT_CLANGXX clang++)
set(sanitize_dir ${PROJECT_BINARY_DIR}/sanitize)
set(sanitize_compilers -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
  -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER})
if(DDT_CLANG AND DDT_CLANGXX)
  set(sanitize_dir ${PROJECT_BINARY_DIR}/sanitize_clang)
  set(sanitize_compilers -DCMAKE_CXX_COMPILER=${DDT_CLANGXX} -DCMAKE_C_COMPILER=${DDT_CLANG})
endif()
add_test(NAME sanitize.build
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${PROJECT_SOURCE_DIR} ${sanitize_dir}
    --build-generator ${CMAKE_GENERATOR}
    --build-noclean
    --build-target unit_tests
    --build-options -DCMAKE_BUILD_TYPE=Sanitize -DCMAKE_UNITY_BUILD=ON
      -DDDT_PLUGIN=${DDT_PLUGIN} -DDDT_WERROR=${DDT_WERROR}
      ${sanitize_compilers})
set_tests_properties(sanitize.build PROPERTIES LABELS all FIXTURES_SETUP sanitized RUN_SERIAL TRUE)
# Left out, beside large_when_sanitized: colour_fork, since a child of a process with threads may find
# the sanitizer's own locks held; of what is tested on devices, each test a process, what is large or
# takes its time in Mesa's compiler, and OSMesa where it is the same code with EGL.
string(CONCAT sanitize_large
  "colour_fork|SameBits.EverySchemeAndCost|Check.EveryProgramIsChecked|Hardware[.]"
  "|Transfer.NumbersFitStorageBlocks|Process.AutomaticNeverPicks|Shaders.TheReferenceCompiler"
  "|/(Faults|JobCheck|SelfChecks|TinCheck|TinOnDevice|SameBits|Shapes|Stages|Transfer)[.].*osmesa")
add_test(NAME sanitize.run
  COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${sanitize_dir} --output-on-failure -j 2
    --exclude-regex ${sanitize_large})
set_tests_properties(sanitize.run PROPERTIES LABELS all FIXTURES_REQUIRED sanitized RUN_SERIAL TRUE)
if(DDT_PLUGIN AND DDT_CLANG AND DDT_CLANGXX)
  # The same numbers every time: what is new is for longer runs to find (tests/fuzz/run).
  add_test(NAME fuzz.run
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/run --seconds 5 --seed 1 --built ${sanitize_dir})
  set_tests_properties(fuzz.run PROPERTIES LABELS all FIXTURES_REQUIRED sanitized RUN_SERIAL TRUE)
endif()
