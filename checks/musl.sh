# 64-bit Linux with musl: a program without any shared library, linked by the recipe of docs/linking.md. Rust's target
# for musl offers no shared library, and Debian no C++ compiler for it.
need_target x86_64-unknown-linux-musl
need_tool musl-gcc musl-tools
need_packages cmake ninja-build pkg-config
configure_cross musl x86_64-linux-musl -DPELLICLE_BUILD_TESTS=OFF
step cmake --build build/check/musl
rm -rf build/check/musl-prefix
step cmake --install build/check/musl --prefix build/check/musl-prefix
export PKG_CONFIG_PATH=build/check/musl-prefix/lib/pkgconfig
read -ra flags < <(pkg-config --static --cflags --libs pellicle)
step musl-gcc -std=c99 -static cpp_tests/consumer/use.c "${flags[@]}" -o build/check/musl/use
if readelf --dynamic build/check/musl/use | grep -F '(NEEDED)'; then
    die 1 "the program needs shared libraries"
fi
step build/check/musl/use
# What stops a panic finds its way by this index.
readelf --wide --program-headers build/check/musl/use | grep -F GNU_EH_FRAME || die 1 "the program has no index of its frames"
