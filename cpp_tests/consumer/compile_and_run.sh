#!/usr/bin/env bash
# Compiles one C99 file with the flags of pkg-config and runs it.
# Usage: compile_and_run.sh <library directory> <file.c> <program>; CC and PKG_CONFIG from the environment.
set -euo pipefail
libdir=$1 source=$2 program=$3

read -ra flags < <(PKG_CONFIG_PATH="$libdir/pkgconfig" "$PKG_CONFIG" --cflags --libs pellicle)
"$CC" -std=c99 -Wall -Wextra -Wpedantic -Werror "$source" "${flags[@]}" -o "$program"
LD_LIBRARY_PATH="$libdir" "$program"
