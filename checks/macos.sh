# macOS: only what this machine can tell. The library type-checks for both processors, and clang compiles both headers
# for it, with another system's standard headers in place of Apple's. Nothing is linked and nothing runs.
need_target aarch64-apple-darwin
need_target x86_64-apple-darwin
need_tool clang clang
need_tool aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
standard=$(aarch64-linux-gnu-g++ -x c++ -E -v /dev/null 2>&1 | sed -n 's/^ \(.*include\/c++\/[0-9]*\)$/\1/p')
# Apple's compilers have a __nonnull of their own, and the standard headers of GNU need its extensions.
includes=(-nostdinc -isystem "$(clang -print-resource-dir)/include" -isystem "$standard"
    -isystem "$standard/aarch64-linux-gnu" -isystem /usr/aarch64-linux-gnu/include -U__nonnull -D_GNU_SOURCE)
for processor in aarch64 x86_64; do
    step cargo check --locked --lib --target "$processor-apple-darwin"
    for file in layout.c layout.cpp host_macros.cpp headers_without_exceptions.cpp; do
        compiler=(clang -std=c99)
        [[ $file == *.c ]] || compiler=(clang++ -std=c++17 -nostdinc++)
        step "${compiler[@]}" --target="${processor/aarch64/arm64}-apple-darwin" -fsyntax-only -Wall -Wextra -Wconversion -Werror \
            "${includes[@]}" -Iinclude "cpp_tests/abi/$file"
    done
done
