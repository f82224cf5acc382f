# Undefined-behaviour sanitizer over the C and C++ side: the ABI tests, and the renderer's scenes.
setup
flags="-fsanitize=undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g1"
step cmake -S . -B build/check/undefined -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags -Wno-maybe-uninitialized"
step cmake --build build/check/undefined --target abi_shared abi_static pellicle_render pellicle_scene_tests
must_refer_to build/check/undefined/bin/pellicle_scene_tests __ubsan_
export UBSAN_OPTIONS=print_stacktrace=1
step ctest --test-dir build/check/undefined --output-on-failure --no-tests=error --parallel "$(nproc)" \
    --tests-regex '^(abi\.(shared|static)|scenes)\.'
