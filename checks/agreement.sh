# Batches of 100 million elements at every SIMD level, against single calls and double precision.
step cargo run --locked --release --example agreement -- "$@" | tee out/agreement.md
