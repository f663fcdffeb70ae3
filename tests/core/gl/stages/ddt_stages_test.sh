#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# HACKING.md's lines of ddt_stages do what it says: where a constant is changed that shows, else
# nothing differs. Skipped (status 77) where no software renderer is installed.
#
#   ddt_stages_test.sh SOURCE_DIR DDT_STAGES
set -euo pipefail
source_dir=$1 stages=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export LIBGL_ALWAYS_SOFTWARE=1

# expect STATUS LINE ARGUMENTS...: of the program, and a line that it prints.
expect() {
    local wanted=$1 line=$2 status=0
    shift 2
    "$stages" "$@" >"$scratch/out" 2>&1 || status=$?
    if grep -q '^ddt_stages: no device' "$scratch/out"; then
        echo "skipped: $(cat "$scratch/out") (./check installs what it needs)"
        exit 77
    fi
    if [ $status != "$wanted" ] || ! grep -qE "^$line" "$scratch/out"; then
        echo "FAILED: ended with $status, not $wanted and \"$line\": ddt_stages $*"
        cat "$scratch/out"
        exit 1
    fi
}

lines=$(sed -nE 's|^(\$ )?build/bin/ddt_stages ||p' "$source_dir/HACKING.md")
[ "$(grep -c -e --change <<<"$lines")" -ge 1 ] || { echo "FAILED: HACKING.md shows no fault"; exit 1; }
while read -r line; do
    eval "arguments=($line)"
    case $line in
    *--change*) expect 2 'first: surface after 1 corrections, vertices,' "${arguments[@]}" ;;
    *) expect 0 'no bit differs$' "${arguments[@]}" ;;
    esac
done <<<"$lines"

unknown='correct.comp STORED_EDGES'
expect 1 "ddt_stages: no program \"$unknown\" was compiled; compiled were .*correct.comp" \
    --filter ddt-sharp --change "$unknown" across_beside 0.2501
echo "All as expected."
