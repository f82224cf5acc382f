# `./x package [platform ...]`: archives for those who have no Rust, into out/packages, and each of them tried: a
# program is built from what was unpacked, on a PATH without cargo, and runs. Read by x, with its functions at hand.

PLATFORMS=(linux aarch64 windows musl)
debian=(-DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_DOCDIR=share/doc/libpellicle-dev)

package() {
    (($#)) || set -- "${PLATFORMS[@]}"
    local platform
    for platform in "$@"; do
        [[ " ${PLATFORMS[*]} " == *" $platform "* ]] || die 2 "unknown platform '$platform'; there are: ${PLATFORMS[*]}"
    done
    need_packages cmake ninja-build g++ pkg-config dpkg-dev
    mkdir -p out/packages
    for platform in "$@"; do
        "package_$platform"
    done
    note "$(cd out/packages && sha256sum -- *)"
}

package_linux() {
    local architecture
    architecture=$(dpkg-architecture --query DEB_HOST_MULTIARCH)
    make_package linux TGZ "" -DCMAKE_INSTALL_LIBDIR=lib
    try_with_cmake linux lib ""
    try_with_pkg_config linux lib cc "" shared
    make_package linux DEB "" "${debian[@]}" -DCMAKE_INSTALL_LIBDIR="lib/$architecture"
    try_with_cmake linux "usr/lib/$architecture" ""
    try_with_pkg_config linux "usr/lib/$architecture" cc "" shared
    if ((EUID == 0)); then try_installing; fi
}

package_aarch64() {
    need_target aarch64-unknown-linux-gnu
    need_tool aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
    need_tool qemu-aarch64 qemu-user
    local toolchain=aarch64-linux-gnu
    make_package aarch64 TGZ $toolchain -DCMAKE_INSTALL_LIBDIR=lib
    try_with_cmake aarch64 lib $toolchain
    try_with_pkg_config aarch64 lib aarch64-linux-gnu-gcc "qemu-aarch64 -L /usr/aarch64-linux-gnu" shared
    make_package aarch64 DEB $toolchain "${debian[@]}" -DCMAKE_INSTALL_LIBDIR=lib/$toolchain
    try_with_cmake aarch64 usr/lib/$toolchain $toolchain
}

package_windows() {
    need_target x86_64-pc-windows-gnu
    need_wine
    make_package windows ZIP x86_64-windows-gnu -DCMAKE_INSTALL_LIBDIR=lib
    try_with_cmake windows lib x86_64-windows-gnu
    cp "$unpacked/bin/pellicle.dll" "$unpacked/lib"
    try_with_pkg_config windows lib x86_64-w64-mingw32-gcc-posix wine shared
}

# Rust's target for musl offers no shared library.
package_musl() {
    need_target x86_64-unknown-linux-musl
    need_tool musl-gcc musl-tools
    make_package musl TGZ x86_64-linux-musl -DCMAKE_INSTALL_LIBDIR=lib
    try_with_pkg_config musl lib musl-gcc "" static
}

# make_package platform generator toolchain [options]: makes the archive in out/packages and unpacks it into $unpacked.
make_package() {
    local folder="$PWD/build/package/$1-$2" generator=$2 toolchain=$3 archive options=()
    shift 3
    [[ -z "$toolchain" ]] || options=(--toolchain "toolchains/$toolchain.cmake")
    step cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPELLICLE_BUILD_TESTS=OFF "${options[@]}" "$@"
    step cmake --build "$folder"
    rm -rf "$folder/archives" "$folder/unpacked"
    step cpack --config "$folder/CPackConfig.cmake" -G "$generator" -B "$folder/archives"
    archive=$(find "$folder/archives" -maxdepth 1 -name '*.deb' -o -maxdepth 1 -name '*.tar.gz' -o -maxdepth 1 -name '*.zip')
    [[ -f "$archive" ]] || die 1 "one archive was to be made, and there are: $archive"
    cp "$archive" out/packages
    made="out/packages/${archive##*/}"
    mkdir "$folder/unpacked"
    unpacked="$folder/unpacked"
    if [[ "$generator" == DEB ]]; then
        dpkg-deb --info "$made"
        dpkg-deb --extract "$made" "$unpacked"
    else
        # One folder inside, which is named as the archive is.
        (cd "$unpacked" && cmake -E tar xf "$archive")
        unpacked=$(find "$unpacked" -mindepth 1 -maxdepth 1)
    fi
}

# try_with_cmake platform libdir toolchain: the consumer project and its tests, with the CMake package.
try_with_cmake() {
    local options=("-Dpellicle_DIR=$unpacked/$2/cmake/pellicle")
    [[ -z "$3" ]] || options+=("-DCMAKE_TOOLCHAIN_FILE=$PWD/toolchains/$3.cmake")
    rm -rf "build/package/try-$1"
    PATH=$(path_without_cargo) step ctest --build-and-test cpp_tests/consumer "build/package/try-$1" \
        --build-generator Ninja --build-options "${options[@]}" --test-command ctest --output-on-failure
}

# try_with_pkg_config platform libdir compiler emulator shared|static: the C example, with pkg-config.
try_with_pkg_config() {
    local libdir="$unpacked/$2" compiler=$3 program="build/package/try-$1-minimal" emulator flags options=()
    read -ra emulator <<<"$4"
    if [[ $5 == static ]]; then options=(-static); fi
    read -ra flags < <(PKG_CONFIG_PATH="$libdir/pkgconfig" pkg-config ${options:+--static} --cflags --libs pellicle)
    [[ $1 != windows ]] || { program="$libdir/minimal.exe" && flags+=(-static-libgcc); }
    PATH=$(path_without_cargo) step "$compiler" -std=c99 "${options[@]}" examples/c/minimal.c "${flags[@]}" -o "$program"
    PATH=$(path_without_cargo) LD_LIBRARY_PATH="$libdir" step "${emulator[@]}" "$program"
}

# Installs the .deb for good, builds and runs the C example without any path, and removes it.
try_installing() {
    step dpkg --install "$made"
    PATH=$(path_without_cargo) step sh -c '
        cc -std=c99 examples/c/minimal.c $(pkg-config --cflags --libs pellicle) -o build/package/try-installed &&
        build/package/try-installed' || { dpkg --remove libpellicle-dev && die 1 "the installed package does not work"; }
    step dpkg --remove libpellicle-dev
}

# PATH without cargo and rustc: of folders that have them, links to everything else.
path_without_cargo() {
    local folder farm result="" tool
    local folders
    IFS=: read -ra folders <<<"$PATH"
    for folder in "${folders[@]}"; do
        if [[ -e "$folder/cargo" || -e "$folder/rustc" ]]; then
            farm="$PWD/build/package/path$folder"
            mkdir -p "$farm"
            for tool in "$folder"/*; do
                case "${tool##*/}" in
                    cargo* | rust*) ;;
                    *) ln -sf "$tool" "$farm" ;;
                esac
            done
            folder=$farm
        fi
        result+="${result:+:}$folder"
    done
    if PATH=$result command -v cargo >/dev/null; then die 1 "cargo is still on the PATH: $result"; fi
    echo "$result"
}
