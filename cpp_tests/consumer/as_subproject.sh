#!/usr/bin/env bash
# A parent project adds pellicle with add_subdirectory() or FetchContent: everything is built in the parent's build
# folder, and pellicle is installed only if PELLICLE_INSTALL is set.
# Usage: as_subproject.sh <cmake> <source> <cargo target directory> add_subdirectory|FetchContent <work>
set -euo pipefail
cmake=$1 source=$2 target=$3 way=$4 work=$5
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

case "$way" in
    add_subdirectory) add="add_subdirectory($source pellicle)" ;;
    FetchContent)
        add="include(FetchContent)
FetchContent_Declare(pellicle SOURCE_DIR $source)
FetchContent_MakeAvailable(pellicle)"
        ;;
esac

rm -rf "$work"
mkdir -p "$work/parent"
cp "$here/use.c" "$work/parent"
cat >"$work/parent/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(parent LANGUAGES C)
$add
add_executable(use use.c)
target_link_libraries(use PRIVATE pellicle::shared m)
install(TARGETS use)
END
configure() {
    env --unset=CARGO_TARGET_DIR "$cmake" -S "$work/parent" -B "$work/build" -G Ninja "$@"
}
cached() {
    sed -n "s/^$1:[A-Z]*=//p" "$work/build/CMakeCache.txt"
}

configure
[[ "$(cached PELLICLE_CARGO_TARGET_DIR)" == "$work/build/"* ]] ||
    { echo "cargo builds outside the parent's build folder" >&2; exit 1; }
[[ "$(cached PELLICLE_INSTALL)" == OFF ]] || { echo "a subproject installs unasked" >&2; exit 1; }

# What is built already is used here: only where it lies by default was the question.
configure -DPELLICLE_CARGO_TARGET_DIR="$target"
"$cmake" --build "$work/build"
"$work/build/use"
"$cmake" --install "$work/build" --prefix "$work/without"
[[ -x "$work/without/bin/use" ]] || { echo "the parent's program is not installed" >&2; exit 1; }
[[ ! -e "$work/without/include" && ! -e "$work/without/lib" ]] || { echo "pellicle is installed unasked" >&2; exit 1; }

configure -DPELLICLE_INSTALL=ON
"$cmake" --install "$work/build" --prefix "$work/with"
[[ -f "$work/with/include/pellicle.h" ]] || { echo "pellicle is not installed though asked" >&2; exit 1; }

# The functions of the static library are hidden, unless the parent asks for them.
visibility() {
    readelf --symbols --wide "$work/build/"*/lib/libpellicle.a "$work/build/"_deps/*/lib/libpellicle.a 2>/dev/null |
        awk '$NF == "pellicle_get_api" { print $6 }'
}
[[ "$(visibility)" == HIDDEN ]] || { echo "the static library's functions are $(visibility)" >&2; exit 1; }
configure -DPELLICLE_STATIC_EXPORT=ON
"$cmake" --build "$work/build"
[[ "$(visibility)" == DEFAULT ]] || { echo "asked to export, the functions are $(visibility)" >&2; exit 1; }
