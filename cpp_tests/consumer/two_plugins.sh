#!/usr/bin/env bash
# Two plug-ins in one process, each with a static pellicle of another version, run their own code, and export nothing
# of it. The other version is the same library with another text in place of its version.
# Usage: two_plugins.sh <library directory> <version> <work>; CC and PKG_CONFIG from the environment.
set -euo pipefail
libdir=$1 version=$2 work=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
other_version=$(tr 0-9 9 <<<"$version") # as long as the text that it replaces

rm -rf "$work"
mkdir -p "$work"
read -ra cflags < <(PKG_CONFIG_PATH="$libdir/pkgconfig" "$PKG_CONFIG" --cflags pellicle)
read -ra libs < <(PKG_CONFIG_PATH="$libdir/pkgconfig" "$PKG_CONFIG" --static --libs pellicle)
cp "$libdir/libpellicle.a" "$work/libfirst.a"
LC_ALL=C sed "s/${version//./\\.}\x00/$other_version\x00/g" "$libdir/libpellicle.a" >"$work/libsecond.a"
if cmp --quiet "$work/libfirst.a" "$work/libsecond.a"; then
    echo "the version $version is not in libpellicle.a" >&2
    exit 1
fi

for plugin in first second; do
    "$CC" -std=c99 -shared -fPIC -DPLUGIN=$plugin "${cflags[@]}" "$here/plugin.c" \
        -L"$work" "${libs[@]/-lpellicle/-l$plugin}" -o "$work/$plugin.so"
    exported=$(nm --dynamic --defined-only --extern-only "$work/$plugin.so" | awk '{ print $NF }')
    [[ "$exported" == "$plugin" ]] ||
        { echo "$plugin.so exports $(wc -l <<<"$exported") symbols and not $plugin() alone" >&2; failed=1; }
done
"$CC" -std=c99 "${cflags[@]}" "$here/plugin_host.c" -ldl -o "$work/host"
"$work/host" "$work/first.so" first "$version" "$work/second.so" second "$other_version"
exit "${failed:-0}"
