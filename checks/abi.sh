# The binary interface, compared by abidiff with the description that is kept: functions, and the layouts of
# all structs. After a change on purpose `./x check abi --renew` writes it anew. While PELLICLE_ABI_VERSION is 0
# the interface may change, so nothing older is compared with: no program of an earlier header has to run.
#
# What is described is a library of the header's own functions, without contents: it is small and built in a
# second. tests/header.rs tests that the header is what the Rust sources generate, the stage `symbols` that the
# library exports its functions.
need_tool abidw abigail-tools
need_tool abidiff abigail-tools
need_tool cc gcc
description=cpp_tests/abi/interface.abi
work=build/check/abi
mkdir -p "$work"

{
    echo '#include <pellicle.h>'
    cc -E -P include/pellicle.h | tr '\n' ' ' |
        grep -oE '[A-Za-z_][A-Za-z0-9_ ]*[ *]+pellicle_[a-z_]+\([^;]*\);' |
        sed 's/;$/ { __builtin_trap(); }/'
} >"$work/interface.c"
defined=$(grep -c __builtin_trap "$work/interface.c")
declared=$(grep -cE '^[A-Za-z][A-Za-z0-9_ *]*[ *]pellicle_[a-z_]+\(' include/pellicle.h)
[[ "$defined" == "$declared" ]] ||
    die 1 "$defined functions were found in the header, which declares $declared"
step cc -std=c99 -g -shared -fPIC -Iinclude "$work/interface.c" -o "$work/libinterface.so"

if [[ "${1:-}" == --renew ]]; then
    step abidw --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed --no-parameter-names --no-write-default-sizes --type-id-style hash \
        --out-file "$description" "$work/libinterface.so"
else
    step abidiff --no-show-locs "$description" "$work/libinterface.so"
fi
