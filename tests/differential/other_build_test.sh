#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The core once more, by other means: its own hashes, and the bits of random jobs, are those of this
# build.
#
#   other_build_test.sh SOURCE_DIR BUILD_DIR NAME CMAKE_ARGUMENT...
#
# Builds in BUILD_DIR/NAME, with little optimisation, which takes a minute. For another processor, $EMULATOR
# runs what was built.
set -euo pipefail
source_dir=$1 build_dir=$2 other=$2/$3
shift 3
quietly() { "$@" >"$other.log" 2>&1 || { cat "$other.log"; exit 1; }; }
quietly cmake -S "$source_dir" -B "$other" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 -DDDT_TESTS=ON \
    -DDDT_PLUGIN=OFF -DDDT_HOSTS=OFF -DDDT_GPU=OFF "$@"
grep -E '^-- (oneTBB|Highway)' "$other.log"
quietly cmake --build "$other" -j 2 --target ddt_bits ddt_golden_tests
run() { ${EMULATOR:-} "$other/bin/$1" "${@:2}"; }
run ddt_golden_tests --gtest_brief=1
diff <("$build_dir/bin/ddt_bits") <(run ddt_bits) || { echo "FAILED: other bits"; exit 1; }
echo "the same bits"
