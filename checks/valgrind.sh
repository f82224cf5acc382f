# Valgrind over the ABI tests. It has no AVX-512 and hides it, so that dispatch is tested as well; it is
# some 40 times slower, so that tests whose work is many calls of films are left to the sanitizers.
need_tool valgrind valgrind
setup
step cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
step cmake --build build --target abi_shared
step valgrind --quiet --error-exitcode=1 --leak-check=full --show-leak-kinds=definite \
    build/bin/abi_shared --test-case-exclude="float environment*,threads*,references*,film values*,stack:*"
# Batches once more where every look-up is a load of its own.
ABI_TEST_SIMD_LEVEL=sse2 step valgrind --quiet --error-exitcode=1 build/bin/abi_shared --test-case='*batch*'
