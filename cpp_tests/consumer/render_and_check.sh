#!/usr/bin/env bash
# Runs a program that renders a picture into the file it is given: the picture shows something, and
# a file that cannot be written is an error.
# Usage: render_and_check.sh <program> <picture> [arguments of the program]; needs oiiotool.
set -euo pipefail
program=$1 picture=$2
shift 2

rm -f "$picture"
"$program" "$picture" "$@"
[[ -s "$picture" ]] || { echo "$program did not write $picture" >&2; exit 1; }

# Mean and standard deviation of red, green and blue, of 255.
stats=$(oiiotool --stats "$picture")
awk '
    /Stats (Avg|StdDev):/ { for (i = 3; i <= 5; i++) { numbers++; if ($i < 10 || $i > 200) wrong++ } }
    END { exit !(numbers == 6 && !wrong) }' <<<"$stats" ||
    { printf 'black, white or of one colour: %s\n%s\n' "$picture" "$stats" >&2; exit 1; }

if "$program" "$picture/inside-a-file.png" "$@"; then
    echo "$program: no error for a file that cannot be written" >&2
    exit 1
fi
