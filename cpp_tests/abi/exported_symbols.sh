#!/usr/bin/env bash
# The shared library exports the functions of the header, all of them and nothing else, under the
# SONAME of this ABI version.
# Usage: exported_symbols.sh <C compiler> <pellicle.h> <libpellicle.so>; NM and READELF from the environment.
set -euo pipefail
compiler=$1 header=$2 library=$3

# The preprocessor takes the comments away.
declared=$("$compiler" -E -P "$header" | grep -oE '\bpellicle_[a-z0-9_]+ *\(' | tr -d ' (' | sort -u)
exported=$("${NM:-nm}" --dynamic --defined-only --extern-only "$library" | awk '{ print $NF }' | sort -u)
abi_version=$(sed -nE 's/^#define PELLICLE_ABI_VERSION ([0-9]+).*/\1/p' "$header")

[[ -n "$declared" ]] || { echo "no function found in $header" >&2; exit 1; }
diff --label header --label exported --unified=0 <(echo "$declared") <(echo "$exported") ||
    { echo "declared and exported functions differ" >&2; exit 1; }
"${READELF:-readelf}" --dynamic "$library" | grep -qF "Library soname: [libpellicle.so.$abi_version]" ||
    { echo "the SONAME is not libpellicle.so.$abi_version" >&2; exit 1; }
