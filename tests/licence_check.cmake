# SPDX-License-Identifier: Apache-2.0
# Fails if a file that git tracks, or a new one it does not ignore, lacks the licence's line among its
# first three: all but pictures, documents, the fuzzers' corpus and the few named below, which have no place
# for it. Run as: cmake -DSOURCE_DIR=... -P licence_check.cmake
include(${CMAKE_CURRENT_LIST_DIR}/tracked_files.cmake)
list_tracked_files("")
list(REMOVE_ITEM files
  LICENSE cmake/package/changelog.txt cmake/package/copyright plugin/python/oiio_ddt/py.typed
  tests/golden/golden.txt tests/install/files.txt)
set(lacking "")
foreach(file ${files})
  if(NOT file MATCHES "[.](png|exr|md)$|^tests/fuzz/corpus/"
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
