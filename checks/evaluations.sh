# 1e8 random evaluations of all models and films, or as many as the first argument says; 1e9 take half an hour.
if (($# == 0)); then set -- 1e8; fi
step cargo run --locked --release --example evaluations -- "$@" | tee out/evaluations.md
