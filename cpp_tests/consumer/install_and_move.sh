#!/usr/bin/env bash
# Configures the project as a distribution would, installs it and moves the prefix to <work>/moved.
# Usage: install_and_move.sh <cmake> <source> <cargo target directory> <libdir> <soname> <work>
set -euo pipefail
cmake=$1 source=$2 target=$3 libdir=$4 soname=$5 work=$6

rm -rf "$work"
"$cmake" -S "$source" -B "$work/build" -G Ninja -DPELLICLE_BUILD_TESTS=OFF \
    -DCMAKE_INSTALL_LIBDIR="$libdir" -DPELLICLE_CARGO_TARGET_DIR="$target"
"$cmake" --build "$work/build"
"$cmake" --install "$work/build" --prefix "$work/prefix"
mv "$work/prefix" "$work/moved"

for file in include/pellicle.h include/pellicle.hpp "$libdir/libpellicle.a" "$libdir/$soname" \
    "$libdir/pkgconfig/pellicle.pc" "$libdir/cmake/pellicle/pellicle-config.cmake"; do
    [[ -f "$work/moved/$file" ]] || { echo "not installed: $file" >&2; exit 1; }
done
[[ "$(readlink "$work/moved/$libdir/libpellicle.so")" == "$soname" ]] ||
    { echo "libpellicle.so is not a link to $soname" >&2; exit 1; }

# A path of this machine in a package file would work here and nowhere else.
if grep -rnF -e "$work" -e "$source" "$work/moved/$libdir/pkgconfig" "$work/moved/$libdir/cmake"; then
    echo "absolute path in a package file" >&2
    exit 1
fi
