#!/usr/bin/env bash
# A program linked to the shared library asks for it by SONAME; one linked statically does not.
# Usage: check_linkage.sh shared|static <program>
set -euo pipefail
linkage=$1 program=$2

needed=$(readelf --dynamic "$program" | grep -c 'NEEDED.*\[libpellicle\.so\.1\]' || true)
case "$linkage:$needed" in
    shared:1 | static:0) ;;
    *) echo "$program: linked $linkage, asks for libpellicle.so.1 $needed times" >&2; exit 1 ;;
esac
