#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs into a scratch folder; compares the list of files with files.txt; builds a project
# against the result that compiles every installed header alone and the examples of README.md.
#
#   install_test.sh SOURCE_DIR BUILD_DIR GENERATOR
set -euo pipefail
source_dir=$1 build_dir=$2 generator=$3
here=$source_dir/tests/install
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# By somebody careful: folders that are made on the way are for everybody, those that were there as
# they were.
mkdir -p -m 755 "$scratch/prefix"
mkdir -m 700 "$scratch/prefix/share"
(umask 077 && cmake --install "$build_dir" --prefix "$scratch/prefix" >/dev/null &&
    cmake --install "$build_dir" --prefix "$scratch/new/deep/prefix" >/dev/null &&
    DESTDIR=$scratch/staged cmake --install "$build_dir" --prefix /usr >/dev/null)
[ -L "$scratch/staged/etc/profile.d/oiio-ddt.sh" ]
private=$(cd "$scratch" && find prefix new staged -type d ! -perm 755 | LC_ALL=C sort | xargs)
[ "$private" = prefix/share ] || { echo "FAILED: private folders: $private"; exit 1; }
# The folder of libraries and the build type are in some names; the list is without either.
(cd "$scratch/prefix" && find . -type f -printf '%P\n') |
    sed -e 's,^lib/[a-z0-9_]*-linux-gnu/,lib/,' -e 's,targets-[a-z]*\.cmake,targets-TYPE.cmake,' |
    LC_ALL=C sort >"$scratch/files.txt"
diff -u "$here/files.txt" "$scratch/files.txt" ||
    { echo "FAILED: the files installed are not those of tests/install/files.txt"; exit 1; }

mkdir "$scratch/consumer"
cp "$here"/consumer/* "$scratch/consumer/"
awk -v folder="$scratch/consumer" '
    /^```cpp/ { file = folder "/readme_" ++count ".cpp"; next }
    /^```/ { file = "" }
    file != "" { print >file }
' "$source_dir/README.md"
(cd "$scratch/prefix/include" && find . -name '*.h' -printf '%P\n') | while read -r header; do
    echo "#include <$header>" >"$scratch/consumer/header_${header//[^a-z]/_}.cpp"
done
# It may look for the same packages in its own way.
mkdir "$scratch/modules"
for package in TBB OpenImageIO; do
    echo "set(${package}_FOUND TRUE)" >"$scratch/modules/Find$package.cmake"
done
cmake -G "$generator" -S "$scratch/consumer" -B "$scratch/consumer/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
    -DCMAKE_MODULE_PATH="$scratch/modules" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/consumer/build" -j 2 >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
"$scratch/consumer/build/consumer" "$source_dir/testimages/scene.png" "$scratch/large.png"
iinfo "$scratch/large.png" | grep '768 x  576'
# Threads may be within its code for longer than it is wanted.
for object in module shared; do
    readelf -d "$scratch/consumer/build/lib$object.so" | grep NODELETE ||
        { echo "FAILED: lib$object.so can be unloaded"; exit 1; }
done

# Found by way of a link, as /lib is one to /usr/lib, it is where the link leads.
mkdir "$scratch/root"
ln -s "$scratch/prefix/lib" "$scratch/root/lib"
cmake -G "$generator" -S "$scratch/consumer" -B "$scratch/consumer/linked" -DCMAKE_PREFIX_PATH="$scratch/root" \
    >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
grep -q "oiio-ddt_DIR:PATH=$scratch/root" "$scratch/consumer/linked/CMakeCache.txt"

# Whoever asks for it quietly is told nothing.
mkdir "$scratch/quiet"
cat >"$scratch/quiet/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.20)
project(quiet LANGUAGES C CXX)
message(STATUS "from here on")
find_package(oiio-ddt QUIET)
find_package(oiio-ddt QUIET)
message(STATUS "found: ${oiio-ddt_FOUND}")
END
cmake -G "$generator" -S "$scratch/quiet" -B "$scratch/quiet/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
    >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
grep -q 'found: 1' "$scratch/log" || { cat "$scratch/log"; exit 1; }
! sed '1,/from here on/d' "$scratch/log" |
    grep -E 'oneTBB|Highway|OpenColorIO|OpenImageIO [0-9]|Found (Threads|PkgConfig)' ||
    { echo "FAILED: find_package(oiio-ddt QUIET) is not quiet"; exit 1; }

# The core alone is there without OpenImageIO; whatever else is asked for is not, and why is told.
mkdir "$scratch/core"
cat >"$scratch/core/main.cpp" <<'END'
#include <ddt/core.h>
int main() {
    const float grey[4] = {0.25f, 0.25f, 0.25f, 0.25f};
    float large[16] = {};
    ddt::enlarge(grey, 2, 2, 1, nullptr, large, 4, 4);
    return large[5] == 0.25f ? 0 : 1;
}
END
cat >"$scratch/core/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.20)
project(core LANGUAGES C CXX)
set(core its) # names of its own
set(image own)
find_package(oiio-ddt 0.1 REQUIRED ${WANTED})
message(STATUS "image: ${oiio-ddt_image_FOUND}")
add_executable(core main.cpp)
target_link_libraries(core PRIVATE ddt::ddt_core)
END
# configure_core NAME WANTED ARGUMENT...
configure_core() {
    rm -rf "${scratch:?}/core/$1"
    cmake -G "$generator" -S "$scratch/core" -B "$scratch/core/$1" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
        -DWANTED="$2" "${@:3}" >"$scratch/log" 2>&1
}
without=-DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON
mkdir "$scratch/other"
echo 'set(OpenImageIO_VERSION 9.9.9)' >"$scratch/other/OpenImageIOConfig.cmake"
echo 'set(PACKAGE_VERSION 9.9.9)' >"$scratch/other/OpenImageIOConfigVersion.cmake"
for wanted in 'COMPONENTS;core' 'COMPONENTS;core;OPTIONAL_COMPONENTS;image;nothing'; do
    configure_core alone "$wanted" $without || { cat "$scratch/log"; exit 1; }
    grep -Eq 'image: (FALSE)?$' "$scratch/log" || { cat "$scratch/log"; exit 1; }
done
cmake --build "$scratch/core/alone" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
"$scratch/core/alone/core"
configure_core both 'COMPONENTS;image' || { cat "$scratch/log"; exit 1; }
grep -q 'image: TRUE' "$scratch/log" || { cat "$scratch/log"; exit 1; }
while read -r wanted argument reason; do
    if configure_core refused "${wanted/all/}" "$argument"; then
        echo "FAILED: it is found with $wanted $argument"
        exit 1
    fi
    tr -s ' \n' ' ' <"$scratch/log" | grep -qF "$reason" || { cat "$scratch/log"; exit 1; }
done <<END
all $without oiio-ddt was built with OpenImageIO, whose CMake package is not found
COMPONENTS;image $without oiio-ddt was built with OpenImageIO, whose CMake package is not found
all -DOpenImageIO_DIR=$scratch/other ; there is 9.9.9
COMPONENTS;gpu -DANY= oiio-ddt has no component "gpu" here, but core and image
END
pc=$(dirname "$(find "$scratch/prefix" -name oiio-ddt.pc)")
! PKG_CONFIG_PATH=$pc pkg-config --print-requires oiio-ddt-core | grep -E 'OpenImageIO|OpenColorIO' ||
    { echo "FAILED: pkg-config's core needs image libraries"; exit 1; }
PKG_CONFIG_PATH=$pc pkg-config --exists oiio-ddt
printf '%s\n' 'Name: OpenImageIO' 'Description: another' 'Version: 9.9.9' >"$scratch/other/OpenImageIO.pc"
! PKG_CONFIG_PATH=$scratch/other:$pc pkg-config --exists oiio-ddt ||
    { echo "FAILED: pkg-config takes any OpenImageIO"; exit 1; }
# shellcheck disable=SC2046 # words on purpose
c++ -std=c++17 "$scratch/core/main.cpp" -o "$scratch/core/by-pkg-config" \
    $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs oiio-ddt-core)
"$scratch/core/by-pkg-config"

# The plugin and the wrapper find each other in the installed tree.
"$scratch/prefix/bin/ddt-oiiotool" --pattern constant:color=1,0,0 8x8 3 --resize:filter=ddt 200% \
    -o "$scratch/constant.png"
