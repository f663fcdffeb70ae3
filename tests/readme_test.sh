#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs what README.md tells its readers to run: every block marked `sh` and `python`, in a folder
# that looks like the project's own. The first of them makes the images that the others work on.
#
#   readme_test.sh SOURCE_DIR BUILD_DIR [PYTHON]
set -euo pipefail
source_dir=$1 build_dir=$2 python=${3:-/usr/bin/python3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The blocks in a language, each to a file of its own, in their order: $scratch/LANGUAGE-NN.
awk -v folder="$scratch" '
    /^```./ {
        language = substr($0, 4)
        file = sprintf("%s/%s-%02d", folder, language, ++count)
        next
    }
    /^```/ { language = ""; next }
    language != "" { print >file }
' "$source_dir/README.md"

mkdir "$scratch/here"
cd "$scratch/here"
# A copy, not a link: the wrapper cannot preload a plugin from a path with a space in it.
mkdir -p build/bin build/plugins
cp "$build_dir/bin/ddt" "$build_dir/bin/ddt-oiiotool" build/bin/
cp "$build_dir/plugins/ddt.imageio.so" build/plugins/
ln -s "$source_dir/testimages" .

# Where OpenImageIO's own calls cannot be redirected, as README.md and `ddt info` say.
if OIIO_LIBRARY_PATH=$PWD/build/plugins build/bin/ddt info | grep -q 'maketx cannot use'; then
    sed -i '/maketx .*--filter/d' "$scratch"/sh-*
fi

ran=0
run() {
    local block=$1
    shift
    echo "--- $(basename "$block")"
    cat "$block"
    "$@" "$block" >output 2>&1 || { cat output; echo "FAILED: $*"; exit 1; }
    ran=$((ran + 1))
}
unset OIIO_LIBRARY_PATH OPENIMAGEIO_PLUGIN_PATH OCIO
for block in "$scratch"/sh-*; do run "$block" bash -euo pipefail; done
export OIIO_LIBRARY_PATH=$PWD/build/plugins
for block in "$scratch"/python-*; do run "$block" "$python"; done

# Commands that say nothing may have done nothing.
sizes=$(iinfo large.png uhd.exr square.png)
for size in '1000 x  800' '3840 x 2880' '1000 x 1000'; do
    grep -q "$size" <<<"$sizes" || { echo "FAILED: no image of $size in: $sizes"; exit 1; }
done
iinfo layers.2.exr | grep -q '640 x  480.*2 subimages' || {
    echo "FAILED: two images of 640 x 480 in: $(iinfo layers.2.exr)"; exit 1; }
# A block that is not run here fills these.
"$build_dir/bin/ddt" fill holes.exr whole.exr
if oiiotool --stats whole.exr | grep 'NanCount: .*[1-9]'; then
    echo "FAILED: holes.exr was not filled"; exit 1
fi
oiiotool --stats holes.exr | grep -q 'NanCount: .*[1-9]' || {
    echo "FAILED: holes.exr has no holes"; exit 1; }
[ "$ran" -ge 5 ] || { echo "FAILED: only $ran blocks found"; exit 1; }
