#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ddt resize makes the windows and pixels that oiiotool makes with the plugin.
#
#   resize_test.sh BIN_DIR PLUGIN_DIR TESTIMAGES
set -euo pipefail
bin=$1 testimages=$3
export OIIO_LIBRARY_PATH=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

windows() { iinfo -v "$1" | grep -E '^ +(full/display|pixel data)'; }

compare() {
    local image=$1 size
    shift
    for size in "$@"; do
        ours=$scratch/ours.exr theirs=$scratch/theirs.exr
        "$bin/ddt" resize "$testimages/$image" "$size" "$ours" --type half
        oiiotool "$testimages/$image" --resize:filter=ddt "$size" -d half -o "$theirs"
        diff <(windows "$ours") <(windows "$theirs") ||
            { echo "FAILED: windows of $image at $size"; exit 1; }
        idiff -q "$ours" "$theirs" || { echo "FAILED: pixels of $image at $size"; exit 1; }
    done
}
compare window.exr 50% 333% 33.3%x120% 1.7 0x77 100x0 64x48+10-20 130x99+10-20
compare scene.png 333% 64x48+10-20

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
