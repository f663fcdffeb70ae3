#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian package: made, looked at by lintian, installed in a clean Debian, used there by a login
# shell, removed without a trace; and what it holds for other projects builds and runs.
#
#   package_test.sh SOURCE_DIR BUILD_DIR
#
# Skipped (status 77) without lintian, debootstrap, root or the network.
set -euo pipefail
source_dir=$1 build_dir=$2
for program in lintian debootstrap cpack; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: not root"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed() { echo "FAILED: $*"; exit 1; }

cpack --config "$build_dir/CPackConfig.cmake" -B "$work/cpack" >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
deb=$(echo "$work"/cpack/oiio-ddt_*.deb)
[ -f "$deb" ] || failed "no package: $(ls "$work/cpack")"
said=$(lintian --fail-on none --allow-root --tag-display-limit 0 "$work"/cpack/*.deb 2>&1 || true)
echo "$said"
! grep -E '^(E|W): ' <<<"$said" || failed "lintian complains"

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
    $(PKG_CONFIG_PATH=$pc pkg-config --define-variable=prefix="$prefix" --cflags --libs oiio-ddt) ||
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

# A clean Debian, from where this machine gets its packages.
mirror=$(sed -nE 's/^(deb|URIs:)[^h]*(https?:[^ ]*debian) ?.*/\2/p' /etc/apt/sources.list \
    /etc/apt/sources.list.d/* 2>/dev/null | head -n 1)
. /etc/os-release
chroot=$work/chroot
debootstrap --variant=minbase "$VERSION_CODENAME" "$chroot" "${mirror:-http://deb.debian.org/debian}" \
    >"$work/log" 2>&1 || { tail "$work/log"; echo "skipped: no Debian to be had"; exit 77; }
cp /etc/apt/sources.list "$chroot/etc/apt/" 2>/dev/null || true
cp /etc/resolv.conf /etc/hosts "$chroot/etc/" 2>/dev/null || true
cp "$deb" "$source_dir/testimages/scene.png" "$chroot/root/"
inside() { chroot "$chroot" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C \
    DEBIAN_FRONTEND=noninteractive bash "$@"; }
traces() { (cd "$chroot" && find . -xdev \( -path ./proc -o -path ./tmp \) -prune -o -iname '*ddt*' -print | LC_ALL=C sort); }
before=$(traces)
inside -c "apt-get update -qq && apt-get install -y -qq --no-install-recommends /root/$(basename "$deb")" \
    >"$work/log" 2>&1 || { tail -n 30 "$work/log"; failed "apt install"; }
inside -lc 'cd /root && oiiotool scene.png --resize:filter=ddt 200% -o large.png && iinfo large.png &&
    ddt resize scene.png 200% same.png && idiff -q large.png same.png' ||
    failed "oiiotool in a login shell"
inside -lc 'ddt-oiiotool --pattern checker 8x8 3 --resize:filter=ddt 200% -o /root/checker.png' ||
    failed "the wrapper"
inside -c 'apt-get remove -y -qq oiio-ddt' >"$work/log" 2>&1 || { cat "$work/log"; failed "apt remove"; }
diff <(echo "$before") <(traces) || failed "apt remove leaves these"
echo "installed, used, removed without a trace"
