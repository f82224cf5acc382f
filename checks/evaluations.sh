# 1e9 random evaluations of all models and films, or as many as the first argument says.
step cargo run --locked --release --example evaluations -- "$@" | tee out/evaluations.md
