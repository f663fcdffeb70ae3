# SPDX-License-Identifier: Apache-2.0
# Fails if clang-format would change a source file that git tracks, or a new one it does not
# ignore. Other versions than Debian 12's format some of it otherwise.
# Run as: cmake -DCLANG_FORMAT=... -DSOURCE_DIR=... -P format_check.cmake
if(NOT CLANG_FORMAT)
  message("skipped: clang-format is not installed")
  return()
endif()
set(version 14)
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE said)
if(NOT said MATCHES "version ${version}\\.")
  string(STRIP "${said}" said)
  message("skipped: files are as clang-format ${version} has them; there is: ${said}")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/tracked_files.cmake)
list_tracked_files("*.cpp;*.h")
execute_process(
  COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files}
  WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "run: clang-format -i on the files named above")
endif()
