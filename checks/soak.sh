# The renderer on two threads and in little memory, scenes with everything made anew each time: three minutes, or
# as the arguments say (--minutes 10). Pellicle may hold no byte more after a round than after the first; the
# process's memory, most of which is OpenImageIO's, TBB's and the allocator's, is judged from 100 rounds on.
if (($# == 0)); then set -- --minutes 3 --pictures 2; fi
setup
step cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
step cmake --build build --target pellicle_soak
note "a leak of 100 bytes in each round must be found"
if build/bin/pellicle_soak --minutes 0 --pictures 1 --size 16 --samples 1 --leak 100 2>out/soak-leak.txt >&2; then
    die 1 "a leak of 100 bytes in each round was not found"
fi
grep "pellicle leaks" out/soak-leak.txt || die 1 "the soak failed otherwise: $(cat out/soak-leak.txt)"
step build/bin/pellicle_soak "$@" | tee out/soak.md
