#!/usr/bin/env bash
# Builds and runs the consumers with pkg-config alone, shared and static.
# Usage: with_pkg_config.sh <library directory> <soname> <work>; CC, CXX and PKG_CONFIG from the environment.
set -euo pipefail
libdir=$1 soname=$2 work=$3
here=$(dirname "${BASH_SOURCE[0]}")
export PKG_CONFIG_PATH="$libdir/pkgconfig"

warnings=(-Wall -Wextra -Wpedantic -Werror)
read -ra cflags < <("$PKG_CONFIG" --cflags pellicle)
read -ra shared < <("$PKG_CONFIG" --libs pellicle)
# Both libraries are installed side by side, and -lpellicle would take the shared one.
read -ra static < <("$PKG_CONFIG" --static --libs pellicle | sed 's/-lpellicle/-l:libpellicle.a/')

rm -rf "$work"
mkdir -p "$work"
for linkage in shared static; do
    declare -n libs=$linkage
    "$CC" -std=c99 "${warnings[@]}" "${cflags[@]}" "$here/use.c" "${libs[@]}" -o "$work/use_c_$linkage"
    "$CXX" -std=c++17 "${warnings[@]}" "${cflags[@]}" "$here/use.cpp" "${libs[@]}" -o "$work/use_cpp_$linkage"
    for program in "$work/use_c_$linkage" "$work/use_cpp_$linkage"; do
        "$here/check_linkage.sh" "$linkage" "$program" "$soname"
        LD_LIBRARY_PATH="$libdir" "$program"
    done
done

# Without the libraries that every C compiler adds by itself, the list of Libs.private has to be complete.
"$CC" -std=c99 "${cflags[@]}" "$here/use.c" -nodefaultlibs "${static[@]}" -lgcc_s -lc -o "$work/use_c_listed"
"$work/use_c_listed"

# Programs without any shared library.
read -ra all_static < <("$PKG_CONFIG" --static --libs pellicle)
for option in -static -static-pie; do
    "$CC" -std=c99 "${cflags[@]}" "$here/use.c" $option "${all_static[@]}" -o "$work/use_c$option"
    "$CXX" -std=c++17 "${cflags[@]}" "$here/use.cpp" $option "${all_static[@]}" -o "$work/use_cpp$option"
    for program in "$work/use_c$option" "$work/use_cpp$option"; do
        if readelf --dynamic "$program" | grep -F '(NEEDED)'; then
            echo "$program: linked $option, needs shared libraries" >&2
            exit 1
        fi
        "$program"
    done
done

"$CC" -std=c99 "${warnings[@]}" "${cflags[@]}" "$here/load.c" -ldl -o "$work/load"
"$work/load" "$libdir/$soname"
