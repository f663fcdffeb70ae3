# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Shared by demo, check and the tests of these scripts; to be sourced by bash.
#
# Everything that cannot go on ends in `die`, which says in plain words what is missing.

unset CDPATH
ddt_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
ddt_build=$ddt_root/build
ddt_packages=$ddt_root/cmake/packages

say() { printf '%s\n' "$*" >&2; }

die() {
    say "$(basename "$0"): $1"
    shift
    for line in "$@"; do say "  $line"; done
    exit 1
}

# Names in the lists given (demo, check, all: files of cmake/packages) that dpkg does not report as
# installed for this processor, one a line. Those with a "?" only where apt knows them.
missing_packages() {
    local name mark native
    native=$(dpkg --print-architecture)
    (cd "$ddt_packages" && sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "${@/%/.txt}") | while read -r name mark; do
        dpkg-query -W -f '${db:Status-Status} ${Architecture}\n' "$name" 2>/dev/null |
            grep -qxE "installed (all|$native)" ||
            { [ "$mark" = "?" ] && ! apt-cache show "$name" >/dev/null 2>&1; } ||
            printf '%s\n' "$name"
    done
}

# Runs a command as root: directly, or by sudo.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    else
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

# Installs what the lists given name and the machine lacks. Touches nothing when all is there.
install_packages() {
    command -v dpkg-query >/dev/null ||
        die "this is not a Debian system (there is no dpkg-query)." \
            "Build by hand with CMake; what it needs is listed in the files of $ddt_packages"
    local missing
    missing=$(missing_packages "$@" | tr '\n' ' ')
    [ -n "$missing" ] || return 0
    command -v apt-get >/dev/null ||
        die "there is no apt-get, and these packages are missing:" "$missing"
    [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
        die "these packages are missing, and installing them needs root or sudo:" "$missing" \
            "As root: apt-get install --no-install-recommends $missing"
    as_root apt-get update -qq >&2 ||
        say "apt-get update failed; going on with the package lists that are there"
    # Now it knows which there are.
    missing=$(missing_packages "$@" | tr '\n' ' ')
    say "Installing: $missing"
    # shellcheck disable=SC2086 # names are separated by spaces on purpose
    as_root apt-get install -y -qq --no-install-recommends $missing >&2 ||
        die "apt-get could not install these packages (its own messages are above):" "$missing"
    missing=$(missing_packages "$@" | tr '\n' ' ')
    [ -z "$missing" ] || die "still missing after apt-get install:" "$missing"
}

# What was compiled before need not be compiled again, where there is ccache: in another clone neither,
# nor in the builds that tests make of their own. The two that it is lax about are what it asks for
# where headers are precompiled.
use_ccache() {
    command -v ccache >/dev/null || return 0
    export CMAKE_C_COMPILER_LAUNCHER=${CMAKE_C_COMPILER_LAUNCHER-ccache}
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
    export CCACHE_BASEDIR=${CCACHE_BASEDIR-$ddt_root} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR-1}
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros}
}

# Configures build/. Arguments go to cmake and stay in its cache, so a later call without them keeps
# the choice.
configure_build() {
    local generator=()
    [ -e "$ddt_build/CMakeCache.txt" ] || generator=(-G Ninja)
    mkdir -p "$ddt_build" || die "cannot write to $ddt_root"
    local path
    for path in "$ddt_build" "$ddt_build/configure.log"; do
        [ ! -e "$path" ] || [ -w "$path" ] || die "cannot write to $path." \
            "If another user built here, such as root, run this as that user or remove $ddt_build"
    done
    use_ccache
    quietly configure.log cmake -S "$ddt_root" -B "$ddt_build" "${generator[@]}" "$@" ||
        die "cmake could not configure the build (its messages are above)."
}

# Compiles in build/. Arguments are cmake --build's, such as --target NAME.
compile_build() {
    cmake --build "$ddt_build" "$@" >&2 ||
        die "the build failed: the first message with 'error' above names the file and line."
}

# Runs a command with its output in build/FILE; shows it only if the command fails.
quietly() {
    local log=$ddt_build/$1
    shift
    "$@" >"$log" 2>&1 && return 0
    cat "$log" >&2
    return 1
}
