#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian package: made, looked at by lintian; what it holds for other projects builds and runs.
#
#   package_test.sh BUILD_DIR
#
# Skipped (status 77) without lintian.
set -euo pipefail
build_dir=$1
for program in lintian cpack; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed() { echo "FAILED: $*"; exit 1; }

# By somebody careful: what others may not read is the package's folder alone.
(umask 077 && cpack --config "$build_dir/CPackConfig.cmake" -B "$work/cpack" >"$work/log" 2>&1) ||
    { cat "$work/log"; exit 1; }
deb=$(echo "$work"/cpack/oiio-ddt_*.deb)
[ -f "$deb" ] || failed "no package: $(ls "$work/cpack")"
for package in "$work"/cpack/*.deb; do
    ! dpkg-deb -c "$package" | grep -vE '^(drwxr-xr-x|-rw[x-]r-[x-]r-[x-]|lrwxrwxrwx) ' ||
        failed "$package: not for all users"
done
profile=$(dpkg-deb -c "$deb" | grep -cE ' \./(usr/share/oiio-ddt/profile\.sh|etc/profile\.d/oiio-ddt\.sh -> /usr/share/oiio-ddt/profile\.sh)$')
[ "$profile" = 2 ] || failed "login shells are not told of the plugin"
lintian --fail-on error,warning --allow-root --tag-display-limit 0 "$work"/cpack/*.deb ||
    failed "lintian complains"

# For other projects: what the package holds, without installing it here.
dpkg-deb -x "$deb" "$work/root"
prefix=$work/root/usr
pc=$(dirname "$(find "$prefix" -name oiio-ddt.pc)")
cat >"$work/main.cpp" <<'END'
#include <ddt/resize.h>
int main() {
    const float grey[2] = {0.25f, 0.25f};
    OIIO::ImageBuf in(OIIO::ImageSpec(4, 4, 1, OIIO::TypeFloat)), out;
    for (int i = 0; i < 16; ++i)
        in.setpixel(i % 4, i / 4, grey, 1);
    return ddt::resize(out, in, {}, OIIO::ROI(0, 9, 0, 9)) && out.getchannel(5, 5, 0, 0) == 0.25f ? 0 : 1;
}
END
# shellcheck disable=SC2046 # words on purpose
c++ -std=c++17 "$work/main.cpp" -o "$work/by-pkg-config" \
    $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs oiio-ddt) ||
    failed "pkg-config"
"$work/by-pkg-config" || failed "the program by pkg-config"
mkdir "$work/consumer"
cp "$work/main.cpp" "$work/consumer/"
cat >"$work/consumer/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.20)
project(consumer LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(oiio-ddt REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE ddt::ddt_image)
END
{ cmake -S "$work/consumer" -B "$work/consumer/build" -DCMAKE_PREFIX_PATH="$prefix" &&
    cmake --build "$work/consumer/build"; } >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/consumer/build/consumer" || failed "the program by find_package"
