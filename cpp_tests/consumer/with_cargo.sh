#!/usr/bin/env bash
# A program linked to the library in cargo's own folder starts, as after a plain `cargo build --release`.
# Usage: with_cargo.sh <file with the name of cargo's folder> <include directory> <work>; CC from the environment.
set -euo pipefail
libdir=$(<"$1") include=$2 work=$3
here=$(dirname "${BASH_SOURCE[0]}")

mkdir -p "$work"
"$CC" -std=c99 -Wall -Wextra -Wpedantic -Werror -I"$include" "$here/use.c" -L"$libdir" -lpellicle -lm -o "$work/use"
LD_LIBRARY_PATH="$libdir" "$work/use"
