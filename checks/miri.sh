# Miri over what handles memory: SIMD registers and look-ups, the boundary with C, batches. It has the
# instructions of SSE2 and interprets them a thousand times slower, so only small tests are run, none that
# compiles a film.
need_nightly miri rust-src
# Time, and the file that a test compares with, are the host's.
export MIRIFLAGS="${MIRIFLAGS:-} -Zmiri-disable-isolation"
export CARGO_TARGET_DIR="$(target_folder)/miri"
step cargo +nightly miri test --locked --test interface interpreted::
step cargo +nightly miri test --locked --lib -- \
    num::lanes::look_up num::lanes::rgb_lanes num::lanes::f64x4::tests::each num::spline capi::boundary
