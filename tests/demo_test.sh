#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ./demo, but for what it installs and builds: names of all kinds, the extension of the result, and
# which oiiotool it runs.
#
#   demo_test.sh SOURCE_DIR BUILD_DIR OIIOTOOL
set -euo pipefail
source_dir=$1 build_dir=$2 oiiotool=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
unset OIIO_LIBRARY_PATH OPENIMAGEIO_PLUGIN_PATH OCIO
export DDT_DEVICE=cpu

# A tree that has been built, for an OpenImageIO in a folder of its own.
tree=$scratch/tree package=$scratch/oiio/lib/native/cmake/OpenImageIO
mkdir -p "$tree/cmake" "$tree/build" "$tree/testimages" "$scratch/oiio/bin" "$package"
cp "$source_dir/demo" "$tree/"
cp "$source_dir/testimages/scene.png" "$tree/testimages/"
ln -s "$build_dir/plugins" "$tree/build/plugins"
ln -s "$oiiotool" "$scratch/oiio/bin/oiiotool"
echo "OpenImageIO_DIR:PATH=$package" >"$tree/build/CMakeCache.txt"
cat >"$tree/cmake/setup.sh" <<END
. "$source_dir/cmake/setup.sh"
ddt_root=$tree ddt_build=$tree/build
install_packages() { :; }
configure_build() { :; }
compile_build() { :; }
END

# expect STATUS TEXT ARGUMENT...: what ./demo ends with, and a part of what it prints.
expect() {
    local status=$1 text=$2 got=0
    shift 2
    "$demo" "$@" >"$scratch/out" 2>&1 || got=$?
    if [ $got != "$status" ] || ! grep -qF -- "$text" "$scratch/out"; then
        echo "FAILED: ./demo $*: status $got (expected $status), expected text: $text; output:"
        cat "$scratch/out"
        failures=$((failures + 1))
    fi
}

mkdir "$scratch/in"
cd "$scratch/in"
"$oiiotool" "$tree/testimages/scene.png" --resize 16x12 -o scene.png
"$oiiotool" "$source_dir/testimages/light.exr" --resize 16x12 -o light.exr
demo=$tree/demo results=$tree/demo-output

expect 0 "$results/scene-ddt.png"
expect 0 "$results/light-ddt.exr" light.exr
expect 0 out.tif scene.png 200% out.tif
# OpenImageIO reads what a file is, whatever its name.
cp scene.png photo
cp scene.png photo.psd
cp light.exr light.dds
expect 0 "$results/photo-ddt.png" photo
rm -f "$results/photo-ddt.png"
expect 0 "$results/photo-ddt.png" photo.psd
expect 0 "$results/light-ddt.exr" light.dds
for name in 'a{1+1} #.png' -x.png; do
    cp -- scene.png "./$name"
    expect 0 "$results/${name%.png}-ddt.png" "$name"
done
expect 0 ./-out.png scene.png 200% -out.png

expect 1 "cannot read the image none.png" none.png
expect 1 "cannot write to the folder none" scene.png 400% none/out.png
rm -rf "$results"
: >"$results"
expect 1 "cannot make the folder $results" scene.png
rm -f "$results"

ln -s "$tree/demo" "$scratch/link"
demo=$scratch/link
expect 0 "$results/scene-ddt.png" scene.png
demo=$tree/demo

# The oiiotool of another OpenImageIO has no use for the plugin.
rm "$scratch/oiio/bin/oiiotool"
expect 1 "for the OpenImageIO in $package, beside which there is no oiiotool" scene.png
exit "$failures"
