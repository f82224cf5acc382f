# Address and leak sanitizer over the ABI tests, the Rust side instrumented too, at every SIMD level.
need_nightly
setup
build_instrumented check/address address abi_shared
must_refer_to build/check/address/lib/libpellicle.so.1 __asan_
for level in sse2 avx2 widest; do
    PELLICLE_SIMD=$level step build/check/address/bin/abi_shared
done
