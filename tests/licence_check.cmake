# SPDX-License-Identifier: Apache-2.0
# Fails if a source file that git tracks, or a new one it does not ignore, lacks the licence's line
# among its first two. Run as: cmake -DSOURCE_DIR=... -P licence_check.cmake
include(${CMAKE_CURRENT_LIST_DIR}/tracked_files.cmake)
list_tracked_files("")
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
