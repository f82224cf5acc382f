# Films keep their tolerance: 1,000 random stacks against the reference, or as the arguments say. Long.
step cargo run --locked --release --example promise -- "$@" | tee out/promise.md
