# Single precision against double: 1e8 elements by batches at every level of instructions and by single calls.
study f32_vs_f64 "$@"
