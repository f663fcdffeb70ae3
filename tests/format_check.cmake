# SPDX-License-Identifier: Apache-2.0
# Fails if clang-format would change a source file that git tracks, or a new one it does not
# ignore. Run as: cmake -DCLANG_FORMAT=... -DSOURCE_DIR=... -P format_check.cmake
if(NOT CLANG_FORMAT)
  message("skipped: clang-format is not installed")
  return()
endif()
execute_process(
  COMMAND git ls-files --cached --others --exclude-standard *.cpp *.h
  WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE files RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message("skipped: git does not list the files of ${SOURCE_DIR}")
  return()
endif()
string(STRIP "${files}" files)
string(REPLACE "\n" ";" files "${files}")
execute_process(
  COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files}
  WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "run: clang-format -i on the files named above")
endif()
