# 64-bit ARM Linux, under emulation: Rust's tests of formulas, optics, lanes and batches, and the ABI tests.
#
# Left out for time, since qemu is some 20 times slower: the Rust tests of whole films and models, which integrate
# and compile by the thousand; and the ABI tests that create a film for every medium, compare films with
# the reference, or keep many threads busy. What differs
# on ARM is tried: every operation of the lanes and registers against scalars, lanes against double precision, batches
# against single calls to the bit, look-ups, the boundary with C.
need_target aarch64-unknown-linux-gnu
need_tool aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
need_tool qemu-aarch64 qemu-user
need_packages cmake ninja-build g++ doctest-dev
emulator="qemu-aarch64 -L /usr/aarch64-linux-gnu"
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER=$emulator
step cargo test --locked --release --target aarch64-unknown-linux-gnu --lib --test header --test optics -- \
    --skip the_table_is_within_its_error --skip a_layer_without_fringes_is_summed_whole
step cargo test --locked --release --target aarch64-unknown-linux-gnu --test laws -- batch
configure_cross aarch64 aarch64-linux-gnu
step cmake --build build/check/aarch64
excluded="film data: cosines*,film values*,catalogue: every medium*,threads*"
step $emulator build/check/aarch64/bin/abi_shared --test-case-exclude="$excluded"
step $emulator build/check/aarch64/bin/abi_static --test-case='batch*,lifetime*,table*'
ABI_TEST_SIMD_LEVEL=scalar step $emulator build/check/aarch64/bin/abi_shared --test-case='batch*'
step ctest --test-dir build/check/aarch64 --output-on-failure --no-tests=error --tests-regex 'exported_symbols|unload'
