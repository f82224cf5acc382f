#!/usr/bin/env bash
# The libraries are found wherever cargo puts them: for a target that CARGO_BUILD_TARGET or one of cargo's
# configuration files names, and in another target directory. The project is pellicle's own, with a crate of functions
# that return 7 in place of its sources, which is built in a second.
# Usage: cargo_elsewhere.sh <cmake> <source> <shared library's name> <work>; needs cargo and rustc.
set -euo pipefail
cmake=$1 source=$2 shared=$3 work=$4
triple=$(rustc --version --verbose | sed -n 's/^host: //p')
unset CARGO_TARGET_DIR CARGO_BUILD_TARGET

rm -rf "$work"
mkdir -p "$work/project/src" "$work/configured"
for name in CMakeLists.txt LICENSE-APACHE LICENSE-MIT cmake include packaging; do
    ln -s "$source/$name" "$work/project/$name"
done
cat >"$work/project/Cargo.toml" <<'TOML'
[package]
name = "pellicle"
version = "0.1.0"
edition = "2024"
description = "Functions that return 7"

[lib]
crate-type = ["lib", "cdylib", "staticlib"]

[workspace]
TOML
grep -oE '^[A-Za-z].* \*?pellicle_[a-z_]+\(' "$source/include/pellicle.h" | grep -oE 'pellicle_[a-z_]+' |
    sed 's/.*/#[unsafe(no_mangle)] pub extern "C" fn &() -> u32 { 7 }/' >"$work/project/src/lib.rs"
cat >"$work/main.c" <<'C'
#include <pellicle.h>
int main(void) { return pellicle_abi_version() != 7; }
C
(cd "$work/project" && cargo generate-lockfile --offline)

# try <name> <folder where cargo puts the libraries>
try() {
    local build="$work/$1/build" folder=$2
    "$cmake" -S "$work/project" -B "$build" -G Ninja -DPELLICLE_BUILD_TESTS=OFF >"$work/$1.log"
    "$cmake" --build "$build" >>"$work/$1.log" 2>&1 || { cat "$work/$1.log" >&2; exit 1; }
    [[ -f "$folder/libpellicle.a" ]] || { echo "$1: cargo did not build in $folder" >&2; exit 1; }
    "$CC" -I"$source/include" "$work/main.c" "$build/lib/$shared" -Wl,-rpath,"$build/lib" -o "$work/$1/shared"
    "$CC" -I"$source/include" "$work/main.c" "$build/lib/libpellicle.a" -lutil -lrt -lpthread -lm -ldl -o "$work/$1/static"
    "$work/$1/shared"
    "$work/$1/static"
}

CARGO_BUILD_TARGET=$triple try environment "$work/project/target/$triple/release"
CARGO_BUILD_TARGET=$triple CARGO_TARGET_DIR="$work/elsewhere" try both "$work/elsewhere/$triple/release"
mkdir "$work/project/.cargo"
printf '[build]\ntarget = "%s"\n' "$triple" >"$work/project/.cargo/config.toml"
rm -rf "$work/project/target"
try configured "$work/project/target/$triple/release"
