# Address and leak sanitizer over the ABI tests, the Rust side instrumented too, at every SIMD level.
need_nightly
setup
build_instrumented check/address address abi_shared
must_refer_to build/check/address/lib/libpellicle.so __asan_
# What a call needs of its stack is not what it needs with the sanitizer's margins around every variable.
for level in sse2 avx2 ""; do # the last is the widest
    ABI_TEST_SIMD_LEVEL=$level step build/check/address/bin/abi_shared --test-case-exclude='stack:*'
done
