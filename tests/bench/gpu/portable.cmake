# SPDX-License-Identifier: Apache-2.0
# Copies PROGRAM, and the libraries it needs beyond the C and C++ runtimes, to the folder TO.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${PROGRAM} RESOLVED_DEPENDENCIES_VAR libraries
  PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|pthread|gcc_s|stdc\\+\\+)\\.so" "^ld-linux")
file(COPY ${PROGRAM} ${libraries} DESTINATION ${TO} FOLLOW_SYMLINK_CHAIN)
