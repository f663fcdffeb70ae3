# SPDX-License-Identifier: Apache-2.0
# Fails if a source file that git tracks, or a new one it does not ignore, lacks the licence's line
# among its first two. Run as: cmake -DSOURCE_DIR=... -P licence_check.cmake
execute_process(
  COMMAND git ls-files --cached --others --exclude-standard
  WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE files RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message("skipped: git does not list the files of ${SOURCE_DIR}")
  return()
endif()
string(STRIP "${files}" files)
string(REPLACE "\n" ";" files "${files}")
set(lacking "")
foreach(file ${files})
  if(file MATCHES "[.](cpp|h|c|cc|glsl|comp|py|pyi|sh|cmake|in)$|CMakeLists[.]txt$|(^|/)(check|demo|run)$"
     AND EXISTS ${SOURCE_DIR}/${file})
    file(STRINGS ${SOURCE_DIR}/${file} lines LIMIT_COUNT 3)
    if(NOT lines MATCHES "SPDX-License-Identifier: Apache-2[.]0")
      list(APPEND lacking ${file})
    endif()
  endif()
endforeach()
if(lacking)
  list(JOIN lacking "\n  " lacking)
  message(FATAL_ERROR "without a line SPDX-License-Identifier: Apache-2.0:\n  ${lacking}")
endif()
