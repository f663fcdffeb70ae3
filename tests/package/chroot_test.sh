#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The packages, installed in a clean Debian or Ubuntu, used there by a login shell, removed without a
# trace. Of those for other hosts ImageMagick's and OpenFX' are used; GEGL's and Python's, whose hosts
# would take long to install, are only installed and removed.
#
#   chroot_test.sh SOURCE_DIR BUILD_DIR
#
# Skipped (status 77) without mmdebstrap or root, and where the clean system or what the package
# depends on is not to be had within DDT_TEST_SECONDS (240 unless set).
set -euo pipefail
source_dir=$1 build_dir=$2
for program in mmdebstrap cpack chroot; do
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
# Ends the test for want of something: without a result, or, once the package itself was tested, as done.
tested=
skipped() {
    [ -z "$tested" ] || { echo "left out: $*"; exit 0; }
    tail -n 5 "$work/log"
    echo "skipped: $*"
    exit 77
}
# A step that depends on the network and on how busy the machine is: skipped unless it is done so many
# seconds after the test began.
seconds=${DDT_TEST_SECONDS:-240}
within_time() {
    local code=0 left=$((seconds - SECONDS))
    timeout -k 5 $((left > 0 ? left : 1)) "$@" >"$work/log" 2>&1 || code=$?
    [ $code != 124 ] || skipped "takes too long here: $*"
    return $code
}

cpack --config "$build_dir/CPackConfig.cmake" -B "$work/cpack" >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
deb=$(echo "$work"/cpack/oiio-ddt_*.deb)
[ -f "$deb" ] || failed "no package: $(ls "$work/cpack")"

# A clean system as this one, from where this one gets its packages.
. /etc/os-release
components=main usual_mirror=http://deb.debian.org/debian
[ "$ID" != ubuntu ] || components=main,universe usual_mirror=http://archive.ubuntu.com/ubuntu
mirror=$(sed -nE "s,^(deb|URIs:)[^h]*(https?:[^ ]*/$ID)/?( .*)?$,\2,p" /etc/apt/sources.list \
    /etc/apt/sources.list.d/* 2>/dev/null | head -n 1 || true)
# The lists of packages are kept.
within_time mmdebstrap --variant=apt --skip=cleanup/apt --dpkgopt=force-unsafe-io \
    --components=$components "$VERSION_CODENAME" "$chroot" "${mirror:-$usual_mirror}" ||
    skipped "no clean system to be had here"
cp /etc/resolv.conf /etc/hosts "$chroot/etc/" 2>/dev/null || true
cp "$work"/cpack/*.deb "$source_dir/testimages/scene.png" "$chroot/root/"
clean=(env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive)
inside() { chroot "$chroot" "${clean[@]}" bash "$@"; }
apt() { within_time chroot "$chroot" "${clean[@]}" apt-get -y -qq --no-install-recommends "$@"; }
traces() { (cd "$chroot" && find . -xdev \( -path ./proc -o -path ./tmp \) -prune -o -iname '*ddt*' -print | LC_ALL=C sort); }
before=$(traces)
package=/root/$(basename "$deb")
others=() # those that this build has
for host in openfx imagemagick gegl python3; do
    for deb in "$work"/cpack/oiio-ddt-${host}_*.deb; do
        [ ! -f "$deb" ] || others+=("$host")
    done
done
package_of() { echo "/root/$(basename "$work"/cpack/oiio-ddt-"$1"_*.deb)"; }
apt install --simulate "$package" || { cat "$work/log"; failed "what the package depends on is not to be had"; }
apt install --download-only "$package" || skipped "what the package depends on is not to be had"
apt install "$package" || { tail -n 30 "$work/log"; failed "apt install"; }
inside -lc 'cd /root && oiiotool scene.png --resize:filter=ddt 200% -o large.png && iinfo large.png &&
    ddt resize scene.png 200% same.png && idiff -q large.png same.png' ||
    failed "oiiotool in a login shell"
inside -lc 'ddt-oiiotool --pattern checker 8x8 3 --resize:filter=ddt 200% -o /root/checker.png' ||
    failed "the wrapper"
apt remove oiio-ddt || { cat "$work/log"; failed "apt remove"; }
diff <(echo "$before") <(traces) || failed "apt remove leaves these"
echo "installed, used, removed without a trace: oiio-ddt"

# What follows adds to that, if there is time: on a busy machine there is not.
tested=yes seconds=${DDT_TEST_SECONDS:-160}
apt install "$package" || { tail -n 30 "$work/log"; failed "apt install again"; }
installed=(oiio-ddt)
for host in "${others[@]}"; do
    other=$(package_of "$host")
    case $host in
    openfx)
        apt install "$other" || { tail -n 30 "$work/log"; failed "apt install $other"; }
        inside -lc 'effect=$(echo "$OFX_PLUGIN_PATH"/oiio-ddt.ofx.bundle/Contents/*/oiio-ddt.ofx) &&
            [ -f "$effect" ] && ! ldd "$effect" | grep "not found"' || failed "the OpenFX effect"
        ;;
    imagemagick)
        release=$(dpkg-deb -f "$work"/cpack/oiio-ddt-imagemagick_*.deb Depends |
            sed -E 's/.*libmagickcore-([67]).*/\1/')
        program=convert-im6.q16
        [ "$release" = 6 ] || program=magick-im7.q16
        magick=imagemagick-$release.q16
        apt install --download-only "$other" "$magick" || skipped "ImageMagick is not to be had"
        apt install "$other" "$magick" || { tail -n 30 "$work/log"; failed "apt install $other"; }
        inside -lc 'cd /root && '$program' scene.png -process "ddt 2" -depth 16 by-module.png &&
            oiiotool scene.png --resize:filter=ddt 200% -d uint16 -o large16.png &&
            idiff -q by-module.png large16.png' || failed "ImageMagick's module"
        ;;
    *)
        inside -c "dpkg --force-depends -i $other" >"$work/log" 2>&1 ||
            { cat "$work/log"; failed "dpkg -i $other"; }
        inside -c "dpkg -r oiio-ddt-$host" >"$work/log" 2>&1 ||
            { cat "$work/log"; failed "dpkg -r oiio-ddt-$host"; }
        continue
        ;;
    esac
    installed+=("oiio-ddt-$host")
done
apt remove "${installed[@]}" || { cat "$work/log"; failed "apt remove"; }
diff <(echo "$before") <(traces) || failed "apt remove leaves these"
echo "installed, used, removed without a trace: ${installed[*]}; installed and removed: ${others[*]}"
