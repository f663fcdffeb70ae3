#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What demo and check do about missing packages, with dpkg, apt-get and sudo played by functions; how
# check takes its arguments; what is said of a build that belongs to somebody else.
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
apt-cache() { grep -qx "$2" "$scratch/known"; }
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
    printf 'delta ? # not everywhere\n' >"$scratch/packages/check.txt"
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
expect "a list that is not asked for is not installed" 0 "went on" \
    'install_packages demo; ! grep -q gamma "$scratch/log"; grep -q beta "$scratch/log"; echo went on'
expect "every list that is asked for is installed" 1 "Installing: gamma" \
    'install_packages demo all'

printf 'alpha\nbeta\n' >"$scratch/installed"
: >"$scratch/known"
expect "what the system may lack, and lacks, is not missing" 0 "went on" \
    'install_packages demo check; [ ! -s "$scratch/log" ]; echo went on'
echo delta >"$scratch/known"
expect "what the system may lack, and has, is installed" 1 "Installing: delta" \
    'install_packages demo check'
: >"$scratch/known"
echo alpha >"$scratch/installed"
expect "what apt knows only after its update is installed too" 1 "Installing: beta delta" \
    'apt-get() { echo delta >"$scratch/known"; }; install_packages demo check'

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

# check, with everything played that it would do.
mkdir -p "$scratch/tree/cmake" "$scratch/tree/bin"
cp "$here/../check" "$scratch/tree/"
ln -s "$scratch/tree/check" "$scratch/link"
cat >"$scratch/tree/cmake/setup.sh" <<END
. "$here/../cmake/setup.sh"
install_packages() { echo "install \$*"; }
configure_build() { echo "configure \$*"; }
compile_build() { echo "compile \$*"; }
PATH=$scratch/tree/bin:\$PATH
END
printf '#!/bin/sh\necho "ctest $*"\n' >"$scratch/tree/bin/ctest"
chmod +x "$scratch/tree/bin/ctest"
expect "check" 0 "configure -DDDT_TESTS=ON" 'bash $scratch/tree/check; bash $scratch/tree/check | grep "ctest .*--label-exclude"'
expect "check --all comes before CMake's arguments" 0 "configure -DDDT_TESTS=ON -DX=1" \
    'bash $scratch/tree/check --all -DX=1; bash $scratch/tree/check --all | grep -x "compile --target all check_all"'
expect "check --all comes after CMake's arguments" 0 "configure -DDDT_TESTS=ON -DX=1" \
    'bash $scratch/tree/check -DX=1 --all; bash $scratch/tree/check -DX=1 --all | grep -x "install demo check all"'
expect "the value of a CMake argument is one of its own" 0 "configure -DDDT_TESTS=ON -D X=1 -G Ninja" \
    'bash $scratch/tree/check -D X=1 -G Ninja'
expect "check refuses a word" 1 "and not: Lattice" 'bash $scratch/tree/check Lattice'
expect "check refuses an empty word" 1 "takes --all and CMake's arguments" 'bash $scratch/tree/check ""'
expect "check --help" 0 "every test: also sanitizers" 'bash $scratch/tree/check --help'
expect "check by way of a link" 0 "compile" 'bash $scratch/link'

# Another user's build/. What root may do in any folder is dropped; where that cannot be, root is not asked.
mkdir "$scratch/build"
chmod a-w "$scratch/build"
as_owner=()
[ "$(id -u)" != 0 ] || as_owner=(setpriv --bounding-set -dac_override)
if "${as_owner[@]}" bash -c '[ ! -w "$0" ]' "$scratch/build" 2>/dev/null; then
    expect "a build that another user made" 1 "cannot write to $scratch/build." \
        "${as_owner[*]}"' bash -c ". $here/../cmake/setup.sh; ddt_build=$scratch/build; configure_build"'
fi

exit "$failures"
