# Films keep their tolerance: random stacks against the reference. All of the series, an hour or two: --stacks 1000.
if (($# == 0)); then set -- --stacks 100; fi
step cargo run --locked --release --example promise -- "$@" | tee out/promise.md
