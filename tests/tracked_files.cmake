# SPDX-License-Identifier: Apache-2.0
# Sets `files` to those below SOURCE_DIR that git tracks, and new ones it does not ignore, whose names
# match `patterns` (all, where that is empty); ends the script with a line "skipped: ..." where git does
# not list them.
macro(list_tracked_files patterns)
  execute_process(
    COMMAND git ls-files --cached --others --exclude-standard ${patterns}
    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE files RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message("skipped: git does not list the files of ${SOURCE_DIR}")
    return()
  endif()
  string(STRIP "${files}" files)
  string(REPLACE "\n" ";" files "${files}")
endmacro()
