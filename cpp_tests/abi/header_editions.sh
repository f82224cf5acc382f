#!/usr/bin/env bash
# Both headers compile without a warning in every edition of C from 99 and of C++ from 17 that the compiler has.
# Usage: header_editions.sh; CC and CXX from the environment.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror)
# compile <compiler> <edition or its older name> <file>...
compile() {
    local compiler=$1 editions=$2 edition file tried
    shift 2
    for edition in ${editions//=/ }; do
        tried=$edition
        "$compiler" -std="$edition" -x "${edition%%[0-9]*}" -fsyntax-only /dev/null 2>/dev/null && break
    done
    for file in "$@"; do
        "$compiler" -std="$tried" "${warnings[@]}" -fsyntax-only -I../../include "$file" ||
            { echo "$compiler -std=$tried: $file has warnings or errors" >&2; exit 1; }
    done
    echo "$compiler -std=$tried: $*"
}

for edition in c99 c11 c17 c23=c2x; do
    compile "$CC" "$edition" layout.c host_macros.c ../consumer/use.c
done
for edition in c++17 c++20 c++23=c++2b; do
    compile "$CXX" "$edition" layout.cpp host_macros.cpp headers_without_exceptions.cpp ../consumer/use.cpp
done
