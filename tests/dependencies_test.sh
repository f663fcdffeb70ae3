#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which OpenImageIO is taken, shown by stand-ins whose CMake packages refuse another major version
# than is asked for, as OpenImageIO's own do.
#   dependencies_test.sh CMAKE GENERATOR BUILD_PROGRAM
set -euo pipefail
cmake=$1 generator=$2 build_program=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir "$scratch/project"
cat >"$scratch/project/CMakeLists.txt" <<EOF
cmake_minimum_required(VERSION 3.20)
project(stand_in NONE)
function(pkg_check_modules)
endfunction()
include($here/../cmake/ImageDependencies.cmake)
EOF

# configure VERSION: into $scratch/out, with nothing but a stand-in of that version.
configure() {
    local package=$scratch/$1/lib/cmake/OpenImageIO
    mkdir -p "$package"
    echo 'add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)' >"$package/OpenImageIOConfig.cmake"
    cat >"$package/OpenImageIOConfigVersion.cmake" <<EOF
set(PACKAGE_VERSION $1)
if(NOT PACKAGE_FIND_VERSION OR PACKAGE_FIND_VERSION_MAJOR EQUAL ${1%%.*})
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
EOF
    "$cmake" -S "$scratch/project" -B "$scratch/build-$1" -G "$generator" \
        -DCMAKE_MAKE_PROGRAM="$build_program" -DOpenImageIO_DIR="$package" >"$scratch/out" 2>&1
}

fail() {
    echo "FAILED: $1; output:"
    cat "$scratch/out"
    exit 1
}

for version in 2.4.7 2.5.1 3.0.0 3.1.16; do
    configure "$version" || fail "$version was refused"
    grep -qF "OpenImageIO $version," "$scratch/out" || fail "$version was not named"
done
configure 2.3.9 && fail "2.3.9 was taken"
grep -qF "OpenImageIO 2.3.9 is too old: 2.4 or later is needed" "$scratch/out" || fail "2.3.9: no reason"
echo "All as expected."
