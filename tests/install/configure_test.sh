#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What configuring makes of this project where it is not as usual: with headers in folders of their own.
# Nothing is compiled; the commands that would are looked at.
#
#   configure_test.sh SOURCE_DIR CMAKE_ARGUMENT...
set -euo pipefail
source_dir=$1
shift
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

# Libraries elsewhere than in /usr/include, as far as headers tell.
mkdir -p "$scratch/pc" "$scratch"/elsewhere/{highway,geos,gl,egl}
pc() { printf '%s\n' "Name: $1" 'Description: a stand-in' "Version: $2" "Cflags: -I$3" >"$scratch/pc/$1.pc"; }
pc libhwy 1.0.3 "$scratch/elsewhere/highway"
pc geos 3.11.1 "$scratch/elsewhere/geos"
export PKG_CONFIG_PATH=$scratch/pc${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
quietly cmake -S "$source_dir" -B "$scratch/build" "${arguments[@]}" -DDDT_TESTS=OFF \
    -DDDT_GL_HEADERS="$scratch/elsewhere/gl" -DDDT_EGL_HEADERS="$scratch/elsewhere/egl"
while read -r file folder; do
    with "$scratch/build" "$file" "$scratch/elsewhere/$folder " || failed "$file does not see the headers of $folder"
done <<END
core/triangulate/gain_simd.cpp highway
plugin/host/targets.cpp highway
plugin/colour/codetable.cpp highway
core/tin/delaunay_geos.cpp geos
core/gl/context/functions.cpp gl
core/gl/context/context_egl.cpp egl
END
