#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What configuring makes of this project where it is not as usual: with headers in folders of their own,
# for several build types at once, of other build types, and as a part of another project.
# Nothing is compiled; the commands that would are looked at.
#
#   configure_test.sh SOURCE_DIR GENERATOR CMAKE_ARGUMENT...
set -euo pipefail
source_dir=$1 generator=$2
shift 2
arguments=("$@" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed() { echo "FAILED: $*"; exit 1; }
quietly() { "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }; }

# with BUILD FILE TEXT: whether each command that compiles FILE has TEXT in it.
with() {
    local commands
    commands=$(grep -E "\"command\": .*/$2\",?\$" "$1/compile_commands.json") || failed "$2 is not compiled"
    ! grep -qvF -- "$3" <<<"$commands"
}

# By a generator of several build types, where it is at hand.
several=$generator
[ "$generator" != Ninja ] || several="Ninja Multi-Config"

# Libraries elsewhere than in /usr/include, as far as headers tell.
mkdir -p "$scratch/pc" "$scratch"/elsewhere/{highway,gl,egl}
pc() { printf '%s\n' "Name: $1" 'Description: a stand-in' "Version: $2" "Cflags: -I$3" >"$scratch/pc/$1.pc"; }
pc libhwy 1.0.3 "$scratch/elsewhere/highway"
export PKG_CONFIG_PATH=$scratch/pc${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
quietly cmake -S "$source_dir" -B "$scratch/build" -G "$several" "${arguments[@]}" -DDDT_TESTS=OFF \
    -DDDT_GL_HEADERS="$scratch/elsewhere/gl" -DDDT_EGL_HEADERS="$scratch/elsewhere/egl" \
    -DCMAKE_INSTALL_DATAROOTDIR=data
while read -r file folder; do
    with "$scratch/build" "$file" "$scratch/elsewhere/$folder " || failed "$file does not see the headers of $folder"
done <<END
core/triangulate/gain_simd.cpp highway
plugin/host/targets.cpp highway
plugin/colour/code_table.cpp highway
core/gl/context/functions.cpp gl
core/gl/context/context_egl.cpp egl
END

# Whatever the build type, what is built is where README says.
if [ "$several" != "$generator" ]; then
    for file in plugins/ddt.imageio.so bin/ddt lib/libddt_core.a 'hosts/openfx/oiio-ddt.ofx.bundle/Contents/[^/:]*/oiio-ddt.ofx'; do
        for type in Release Debug; do
            grep -q "^build $file: " "$scratch/build/CMakeFiles/impl-$type.ninja" || failed "$type has no $file"
        done
    done
fi

# Login shells are led to where the script is.
grep -q 'CREATE_LINK /usr/data/oiio-ddt/profile\.sh ' "$scratch/build/cmake_install.cmake" ||
    failed "/etc/profile.d leads elsewhere"

# Several files as one: what a module has in the place of the core's is an object by itself there. And a
# Python that does not do, given, has no other in its place.
quietly cmake -S "$source_dir" -B "$scratch/unity" -G "$generator" "${arguments[@]}" -DDDT_TESTS=OFF \
    -DDDT_PLUGIN=OFF -DCMAKE_UNITY_BUILD=ON -DDDT_PYTHON=/nonexistent/python
with "$scratch/unity" 'core/base/parallel_[a-z]*.cpp' " -c "
grep -q 'Python module: left out (.*; /nonexistent/python is no Python 3' "$scratch/log" ||
    { cat "$scratch/log"; failed "a Python that is not there"; }

# Without optimisation GCC breaks off, whatever asks for none.
while read -r level given; do
    IFS=';' read -ra flags <<<"$given"
    quietly cmake -S "$source_dir" -B "$scratch/typed" -G "$generator" "${arguments[@]}" -DDDT_TESTS=OFF \
        -DDDT_PLUGIN=OFF -DDDT_HOSTS=OFF "${flags[@]}"
    [ "$(grep -oP '(?<= )-O\S*(?=.* -c .*/core/surface/edges\.cpp",?$)' "$scratch/typed/compile_commands.json" |
        tail -n 1)" = "$level" ] || failed "not $level: $given"
    rm -rf "$scratch/typed"
done <<'END'
-O2 -DCMAKE_BUILD_TYPE=None
-Og -DCMAKE_BUILD_TYPE=Debug
-Og -DCMAKE_BUILD_TYPE=None;-DCMAKE_CXX_FLAGS=-g -O0
-O3 -DCMAKE_BUILD_TYPE=Own;-DCMAKE_CXX_FLAGS_OWN=-O3
-Og -DCMAKE_BUILD_TYPE=debug;-DCMAKE_CXX_FLAGS=-I/opt/my-OpenImageIO/include
-O2 -DCMAKE_BUILD_TYPE=None;-DCMAKE_CXX_FLAGS=-Wl,-O1
-O1 -DCMAKE_BUILD_TYPE=Sanitize
-O1 -DCMAKE_BUILD_TYPE=Threads
END

# Folders that no tree which can be moved has.
! cmake -S "$source_dir" -B "$scratch/absolute" "${arguments[@]}" -DCMAKE_INSTALL_PREFIX="$scratch/prefix" \
    -DCMAKE_INSTALL_MANDIR="$scratch/man" >"$scratch/log" 2>&1 || failed "man pages are installed beyond the prefix"
tr -s ' \n' ' ' <"$scratch/log" |
    grep -qF "CMAKE_INSTALL_MANDIR, $scratch/man, is not below CMAKE_INSTALL_PREFIX, $scratch/prefix" ||
    { cat "$scratch/log"; exit 1; }

# Another project that has this one as a part keeps its build type, folders, packages, tests and definitions.
mkdir "$scratch/whole"
cat >"$scratch/whole/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.20)
project(whole LANGUAGES C CXX)
enable_testing()
add_subdirectory("$source_dir" part)
file(WRITE \${CMAKE_BINARY_DIR}/mine.cpp "")
add_library(mine MODULE \${CMAKE_BINARY_DIR}/mine.cpp)
target_link_libraries(mine PRIVATE ddt::ddt_image)
END
whole=$scratch/whole/build
# It may look for the same packages in its own way.
for package in TBB OpenImageIO; do
    echo "set(${package}_FOUND TRUE)" >"$scratch/whole/Find$package.cmake"
done
quietly cmake -S "$scratch/whole" -B "$whole" -G "$generator" "${arguments[@]}" -DCMAKE_INSTALL_PREFIX="$scratch/prefix" \
    -DCMAKE_MODULE_PATH="$scratch/whole"
! grep -E '^CMAKE_BUILD_TYPE:[A-Z]*=.|^CMAKE_INSTALL_LIBDIR:[A-Z]*=.*linux-gnu|^CPACK_|^GTest_DIR' \
    "$whole/CMakeCache.txt" || failed "a part changes the whole's choices"
for file in CPackConfig.cmake plugins bin lib; do
    [ ! -e "$whole/$file" ] || failed "a part makes the whole's $file"
done
(cd "$whole" && ctest -N) | grep -qx 'Total Tests: 0' || failed "a part's tests are the whole's"
with "$whole" mine.cpp "$source_dir/plugin/include" || failed "a part's headers are not seen by the whole"
! with "$whole" mine.cpp "-DHWY_" || failed "a part's definitions are the whole's"
for file in core/triangulate/gain_simd.cpp plugin/host/targets.cpp plugin/colour/code_table.cpp; do
    with "$whole" $file "-DHWY_BROKEN_EMU128=0" || failed "$file: Highway is not compiled as elsewhere"
    # Without optimisation GCC breaks off.
    with "$whole" $file " -O" || failed "$file is not optimised"
done

# Asked for, the part's tests are of the part.
quietly cmake -S "$scratch/whole" -B "$whole" -DDDT_TESTS=ON
grep -qF "readme_test.sh\" \"$source_dir\" \"$whole/part\"" "$whole/part/tests/CTestTestfile.cmake" ||
    failed "tests of a part look for it elsewhere"
! grep -F "$scratch/whole\"" -r "$whole/part/tests" --include=CTestTestfile.cmake || failed "the whole is tested"
