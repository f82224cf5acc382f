# Every fuzzer for a bounded time, from the kept corpus on: [--seconds N, 30] [fuzzer ...]. What it finds
# beyond is kept in fuzz/corpus, a failure in fuzz/artifacts.
seconds=30
if [[ "${1:-}" == --seconds ]]; then
    seconds=${2:?"--seconds needs a number"}
    shift 2
fi
if (($# == 0)); then set -- batch create_bsdf create_film evaluate load_film; fi
need_nightly
need_tool c++ g++
command -v cargo-fuzz >/dev/null || step cargo install --locked cargo-fuzz
command -v cargo-fuzz >/dev/null || die 1 "cargo-fuzz is missing and could not be installed: nothing was checked"
for target in "$@"; do
    mkdir -p "fuzz/corpus/$target"
    length=2048
    # The least series is longer.
    if [[ "$target" == load_film ]]; then length=4096; fi
    step cargo +nightly fuzz run "$target" "fuzz/corpus/$target" "studies/corpus/$target" -- \
        -max_total_time="$seconds" -timeout=60 -max_len="$length" -len_control=0 -print_final_stats=1
done
