# 64-bit ARM Linux, under emulation: the Rust tests, and the ABI tests in every width of instructions.
#
# Left out for time, since qemu is about 20 times slower: the tests of whole films and models, and the laws that
# integrate every model. What they share with ARM's own code is here: every operation in lanes and registers against
# scalars and double precision, batches against single calls, look-ups, the boundary with C.
need_target aarch64-unknown-linux-gnu
need_tool aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu
need_tool aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
need_tool qemu-aarch64 qemu-user
need_packages cmake ninja-build g++ doctest-dev
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu"
step cargo test --locked --release --target aarch64-unknown-linux-gnu --lib --test header --test interface --test optics
step cargo test --locked --release --target aarch64-unknown-linux-gnu --test laws -- batch
cross_ctest aarch64 aarch64-linux-gnu
