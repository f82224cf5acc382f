# macOS: only what this machine can tell. The library type-checks for both processors, and clang compiles both headers
# for it, without Apple's system headers. Nothing is linked and nothing runs.
need_target aarch64-apple-darwin
need_target x86_64-apple-darwin
need_tool clang clang
for target in aarch64-apple-darwin x86_64-apple-darwin; do
    step cargo check --locked --lib --target "$target"
    for language in c c++; do
        step clang --target="${target/aarch64/arm64}" -x "$language" -fsyntax-only -Wall -Wextra -Wconversion -Werror \
            -ffreestanding -nostdinc -isystem "$(clang -print-resource-dir)/include" -Iinclude include/pellicle.h
    done
done
