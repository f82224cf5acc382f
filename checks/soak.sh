# The renderer on two threads and in little memory, scenes with everything made anew each time: three minutes, or
# as the arguments say (--minutes 10).
if (($# == 0)); then set -- --minutes 3 --pictures 2; fi
setup
step cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
step cmake --build build --target pellicle_soak
step build/bin/pellicle_soak "$@" | tee out/soak.md
