#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ddt resize makes the windows and pixels that oiiotool makes with the plugin.
#
#   resize_test.sh BIN_DIR PLUGIN_DIR TESTIMAGES
set -euo pipefail
bin=$1 testimages=$3
export OIIO_LIBRARY_PATH=$2
unset OCIO DDT_DEVICE
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What iinfo says of a file's size, windows and tiles: a line at least.
windows() {
    iinfo -v "$1" | sed -nE -e 's/^\/.* : +([0-9]+ x)/\1/p' -e '/^ +(full\/display|pixel data|tile size)/p' | grep .
}
same_windows() {
    local a b
    a=$(windows "$1") && b=$(windows "$2") && [ "$a" = "$b" ]
}

compare() {
    local image=$1 size
    shift
    for size in "$@"; do
        ours=$scratch/ours.exr theirs=$scratch/theirs.exr
        "$bin/ddt" resize "$testimages/$image" "$size" "$ours" --type half
        oiiotool "$testimages/$image" --resize:filter=ddt "$size" -d half -o "$theirs"
        same_windows "$ours" "$theirs" ||
            { echo "FAILED: windows of $image at $size"; exit 1; }
        idiff -q "$ours" "$theirs" || { echo "FAILED: pixels of $image at $size"; exit 1; }
    done
}
compare window.exr 50% 333% 33.3%x120% 1.7 0x77 100x0 64x48+10-20 130x99+10-20
compare scene.png 333% 64x48+10-20

# Whatever the format has room for: windows, negative coordinates, halfs.
compare_as() {
    local image=$1 size=$2 extension
    shift 2
    for extension in "$@"; do
        ours=$scratch/ours.$extension theirs=$scratch/theirs.$extension
        "$bin/ddt" resize "$image" "$size" "$ours"
        oiiotool "$image" --resize:filter=ddt "$size" -o "$theirs"
        same_windows "$ours" "$theirs" ||
            { echo "FAILED: windows of $image at $size in $extension"; exit 1; }
        idiff -q "$ours" "$theirs" || { echo "FAILED: pixels of $image at $size in $extension"; exit 1; }
    done
}
oiiotool "$testimages/window.exr" --origin +20-7 --fullsize 64x48-10+2 -o "$scratch/left.exr"
for size in 200% 70%; do
    compare_as "$testimages/window.exr" $size png tif
    compare_as "$scratch/left.exr" $size png dpx
done

# The source's tiles, or rows where the format has none or no such: TIFF's are multiples of 16.
oiiotool "$testimages/scene.png" -d half --tile 32 48 -o "$scratch/tiled.exr"
compare_as "$scratch/tiled.exr" 200% exr tif png iff
oiiotool "$testimages/scene.png" --planarconfig separate --tile 80 16 -o "$scratch/tiled.tif"
compare_as "$scratch/tiled.tif" 270% tif exr
oiiotool "$testimages/window.exr" --tile 50 30 -o "$scratch/odd.exr"
compare_as "$scratch/odd.exr" 200% exr
"$bin/ddt" resize "$scratch/odd.exr" 200% "$scratch/odd.tif"

# What the writer makes other numbers of is rounded once.
oiiotool "$testimages/scene.png" -d half -o "$scratch/half.exr"
compare_as "$scratch/half.exr" 150% png tif jpg
oiiotool "$testimages/scene.png" -d uint16 -o "$scratch/deep.png"
compare_as "$scratch/deep.png" 150% jpg
compare_as "$testimages/scene.png" 150% exr hdr

# Colours of 8 bits that are multiplied by alpha when they are read: as floats.
oiiotool --pattern noise:type=uniform:min=0:max=1 40x30 4 --chnames R,G,B,A \
    --attrib:type=int oiio:UnassociatedAlpha 1 -d uint8 -o "$scratch/straight.tif"
compare_as "$scratch/straight.tif" 200% exr tif
oiiotool "$scratch/straight.tif.ddt?scale=2" -o "$scratch/named.tif"
idiff -q "$scratch/named.tif" "$scratch/ours.tif" || { echo "FAILED: pixels of straight.tif.ddt"; exit 1; }

# Files of integers that name no colour space.
oiiotool "$testimages/scene.png" -o "$scratch/plain.dpx"
oiiotool "$testimages/scene.png" -o "$scratch/plain.sgi"
compare_as "$scratch/plain.dpx" 200% dpx
compare_as "$scratch/plain.sgi" 200% sgi

# A type that is asked for has all its bits.
oiiotool "$testimages/scene.png" -d uint10 -o "$scratch/ten.dpx"
"$bin/ddt" resize "$scratch/ten.dpx" 200% "$scratch/sixteen.dpx" --type uint16
iinfo "$scratch/sixteen.dpx" | grep -q ' uint16 ' || { echo "FAILED: bits"; exit 1; }

# Compressed as it is told, or not at all.
compression() { iinfo -v "$1" | sed -n 's/^ *compression: "\(.*\)"/\1/p'; }
for given in none piz; do
    "$bin/ddt" resize "$testimages/scene.png" 200% "$scratch/$given.exr" --type half --compression $given
    [ "$(compression "$scratch/$given.exr")" = $given ] || { echo "FAILED: compression $given"; exit 1; }
done
idiff -q "$scratch/none.exr" "$scratch/piz.exr" || { echo "FAILED: pixels by compression"; exit 1; }
if "$bin/ddt" resize "$testimages/scene.png" 200% "$scratch/refused.tif" --compression piz 2>"$scratch/said"; then
    echo "FAILED: a TIFF by piz"
    exit 1
fi
grep -q 'ddt: compression "piz" is not allowed in tiff; allowed are none, lzw' "$scratch/said"
[ ! -e "$scratch/refused.tif" ]
