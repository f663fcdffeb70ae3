#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What demo and check do about missing packages, with dpkg, apt-get and sudo played by functions.
# shellcheck disable=SC2016 # scripts are kept in single quotes until their own bash runs them
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# The packages "installed" on the machine of a test are the lines of $scratch/installed; those of
# another processor as NAME:foreign.
prelude='
. "$here/../cmake/setup.sh"
ddt_packages=$scratch/packages
dpkg() { echo native; }
dpkg-query() {
    sed -n -e "s/^${!#}\$/installed native/p" -e "s/^${!#}:/installed /p" "$scratch/installed" | grep .
}
apt-get() { echo "apt-get $*" >>"$scratch/log"; [ "$1" != install ] || install_fake; }
install_fake() { cp "$scratch/available" "$scratch/installed"; }
as_root() { "$@"; }
id() { echo 0; }
'

# A PATH without apt-get, dpkg or sudo.
mkdir "$scratch/bin" "$scratch/packages"
for tool in basename dirname grep sed tr; do ln -s "$(command -v $tool)" "$scratch/bin/"; done

# expect NAME STATUS TEXT SCRIPT: runs SCRIPT after the prelude; its exit status and a piece of what
# it printed must be as given.
expect() {
    local name=$1 status=$2 text=$3 script=$4 got=0
    printf '# a comment\nalpha\n\nbeta # why\n' >"$scratch/packages/demo.txt"
    printf 'gamma\n' >"$scratch/packages/all.txt"
    : >"$scratch/log"
    here=$here scratch=$scratch bash -euc "$prelude$script" >"$scratch/out" 2>&1 || got=$?
    if [ "$got" != "$status" ] || ! grep -qF -- "$text" "$scratch/out"; then
        echo "FAILED: $name: status $got (expected $status), expected text: $text; output:"
        cat "$scratch/out"
        failures=$((failures + 1))
    fi
}

printf 'alpha\nbeta\n' >"$scratch/available"

cp "$scratch/available" "$scratch/installed"
expect "nothing is missing: apt-get is not called" 0 "went on" \
    'install_packages demo; [ ! -s "$scratch/log" ]; echo went on'

echo alpha >"$scratch/installed"
expect "only what is missing is installed" 0 "Installing: beta" \
    'install_packages demo; grep -q "install .*no-install-recommends beta" "$scratch/log"'

printf 'alpha\nbeta:foreign\n' >"$scratch/installed"
expect "what is there for another processor is missing" 0 "Installing: beta" \
    'install_packages demo'

echo alpha >"$scratch/installed"
cp "$scratch/available" "$scratch/installed"
expect "a list that is not asked for is not installed" 0 "went on" \
    'install_packages demo; [ ! -s "$scratch/log" ]; echo went on'
expect "every list that is asked for is installed" 1 "Installing: gamma" \
    'install_packages demo all'

echo alpha >"$scratch/installed"
expect "a package that does not arrive is named" 1 "still missing after apt-get install:" \
    'install_fake() { :; }; install_packages demo'

expect "a failing apt-get is reported" 1 "apt-get could not install" \
    'install_fake() { return 100; }; install_packages demo'

expect "neither root nor sudo" 1 "needs root or sudo" \
    'id() { echo 1000; }; PATH=$scratch/bin; install_packages demo'

expect "no apt-get" 1 "there is no apt-get" \
    'unset -f apt-get; PATH=$scratch/bin; install_packages demo'

expect "not Debian" 1 "not a Debian system" \
    'unset -f dpkg-query; PATH=$scratch/bin; install_packages demo'

exit "$failures"
