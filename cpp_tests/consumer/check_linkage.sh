#!/usr/bin/env bash
# A program linked to the shared library asks for it by SONAME; one linked statically does not.
# Usage: check_linkage.sh shared|static <program> <soname>
set -euo pipefail
linkage=$1 program=$2 soname=$3

needed=$(readelf --dynamic "$program" | grep -cF "[$soname]" || true)
case "$linkage:$needed" in
    shared:1 | static:0) ;;
    *) echo "$program: linked $linkage, asks for $soname $needed times" >&2; exit 1 ;;
esac
