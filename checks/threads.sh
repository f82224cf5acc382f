# Thread sanitizer over handles that threads share, the Rust side instrumented with its standard library.
# The renderer is left out: it reports OpenImageIO's own pool of threads.
need_nightly rust-src
setup
mkdir -p build/check
step "${CC:-cc}" -c -O1 -fno-builtin checks/tsan_memory.c -o build/check/tsan_memory.o
export LDFLAGS="$PWD/build/check/tsan_memory.o"
export CARGO_UNSTABLE_BUILD_STD=std,panic_unwind
build_instrumented check/thread thread abi_shared
must_refer_to build/check/thread/lib/libpellicle.so __tsan_
TSAN_OPTIONS=halt_on_error=1 step build/check/thread/bin/abi_shared \
    --test-case="threads*,references*,last error*,batch: eval*,batch: sample*"
