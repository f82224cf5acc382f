# 32-bit targets are refused with the reason; WebAssembly is not among them.
need_target i686-unknown-linux-gnu
mkdir -p build/check
if step cargo check --locked --lib --target i686-unknown-linux-gnu 2>build/check/i686.txt; then
    die 1 "the library compiles for 32-bit x86"
fi
grep -F 'pellicle needs a 64-bit target' build/check/i686.txt ||
    die 1 "the compiler does not say why: $(<build/check/i686.txt)"
