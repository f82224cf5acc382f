#!/usr/bin/env bash
# Compiles and runs the first ```c block of the README as it is printed.
# Usage: readme_example.sh <README.md> <library directory> <work>; CC and PKG_CONFIG from the environment.
set -euo pipefail
readme=$1 libdir=$2 work=$3

rm -rf "$work"
mkdir -p "$work"
awk '/^```c$/ { inside = 1; next } /^```/ && inside { exit } inside' "$readme" >"$work/example.c"
[[ -s "$work/example.c" ]] || { echo "$readme has no block of C" >&2; exit 1; }
"$(dirname "${BASH_SOURCE[0]}")/compile_and_run.sh" "$libdir" "$work/example.c" "$work/example"
