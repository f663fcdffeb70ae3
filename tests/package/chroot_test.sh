#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian package, installed in a clean Debian, used there by a login shell, removed without a
# trace.
#
#   chroot_test.sh SOURCE_DIR BUILD_DIR
#
# Skipped (status 77) without debootstrap or root, and where the clean Debian or what the package
# depends on is not to be had within DDT_TEST_SECONDS (160 unless set).
set -euo pipefail
source_dir=$1 build_dir=$2
for program in debootstrap cpack chroot; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: not root"; exit 77; }
work=$(mktemp -d)
chroot=$work/chroot
finish() {
    local status=$?
    ! mountpoint -q "$chroot/proc" || umount -l "$chroot/proc"
    ! mountpoint -q "$chroot/sys" || umount -l "$chroot/sys"
    rm -rf --one-file-system "$work"
    exit $status
}
trap finish EXIT
trap 'exit 1' INT TERM
failed() { echo "FAILED: $*"; exit 1; }
# A step that depends on the network and on how busy the machine is: skipped unless it is done in time.
within_time() {
    local code=0
    timeout -k 5 $((${DDT_TEST_SECONDS:-160} - SECONDS)) "$@" >"$work/log" 2>&1 || code=$?
    [ $code != 124 ] || { echo "skipped: takes too long here: $*"; exit 77; }
    return $code
}
skipped() { tail -n 5 "$work/log"; echo "skipped: $*"; exit 77; }

cpack --config "$build_dir/CPackConfig.cmake" -B "$work/cpack" >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
deb=$(echo "$work"/cpack/oiio-ddt_*.deb)
[ -f "$deb" ] || failed "no package: $(ls "$work/cpack")"

# A clean Debian, from where this machine gets its packages.
mirror=$(sed -nE 's/^(deb|URIs:)[^h]*(https?:[^ ]*debian) ?.*/\2/p' /etc/apt/sources.list \
    /etc/apt/sources.list.d/* 2>/dev/null | head -n 1 || true)
. /etc/os-release
mkdir -p "$chroot/etc/dpkg/dpkg.cfg.d"
echo force-unsafe-io >"$chroot/etc/dpkg/dpkg.cfg.d/unsafe-io"
within_time debootstrap --variant=minbase "$VERSION_CODENAME" "$chroot" \
    "${mirror:-http://deb.debian.org/debian}" || skipped "no clean Debian to be had here"
cp /etc/resolv.conf /etc/hosts "$chroot/etc/" 2>/dev/null || true
cp "$deb" "$source_dir/testimages/scene.png" "$chroot/root/"
clean=(env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive)
inside() { chroot "$chroot" "${clean[@]}" bash "$@"; }
apt() { within_time chroot "$chroot" "${clean[@]}" apt-get -y -qq --no-install-recommends "$@"; }
traces() { (cd "$chroot" && find . -xdev \( -path ./proc -o -path ./tmp \) -prune -o -iname '*ddt*' -print | LC_ALL=C sort); }
before=$(traces)
package=/root/$(basename "$deb")
apt update || skipped "no lists of packages to be had"
apt install --simulate "$package" || { cat "$work/log"; failed "what the package depends on is not in Debian"; }
apt install --download-only "$package" || skipped "what the package depends on is not to be had"
apt install "$package" || { tail -n 30 "$work/log"; failed "apt install"; }
inside -lc 'cd /root && oiiotool scene.png --resize:filter=ddt 200% -o large.png && iinfo large.png &&
    ddt resize scene.png 200% same.png && idiff -q large.png same.png' ||
    failed "oiiotool in a login shell"
inside -lc 'ddt-oiiotool --pattern checker 8x8 3 --resize:filter=ddt 200% -o /root/checker.png' ||
    failed "the wrapper"
apt remove oiio-ddt || { cat "$work/log"; failed "apt remove"; }
diff <(echo "$before") <(traces) || failed "apt remove leaves these"
echo "installed, used, removed without a trace"
