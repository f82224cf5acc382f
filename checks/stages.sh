# The stages of `./x check`. Each is a script of its own beside this one, run with the functions of x at
# hand; it fails if a tool is missing that cannot be installed.

# The quick ones first.
STAGES=(symbols toolchains i686 macos wasm musl abi windows package aarch64 undefined address threads valgrind miri fuzz f32_vs_f64 random_bounds soak film_cliffs film_tolerance)

check() {
    case "${1:-}" in
        "") all_stages ;;
        list) printf '%s\n' "${STAGES[@]}" ;;
        *)
            [[ " ${STAGES[*]} " == *" $1 "* ]] || die 2 "unknown stage '$1'; there are: ${STAGES[*]}"
            one_stage "$@"
            ;;
    esac
}

# one_stage name [arguments]
one_stage() {
    local script="checks/$1.sh"
    shift
    source "$script" "$@"
}

# Every stage in a process of its own, so that one that fails stops nothing but itself.
all_stages() {
    local stage start failed=0 outcome
    echo -e '| stage | outcome | seconds |\n|---|---|---:|' >out/check.md
    for stage in "${STAGES[@]}"; do
        start=$SECONDS
        outcome=passed
        ./x check "$stage" || outcome=FAILED failed=1
        echo "| $stage | $outcome | $((SECONDS - start)) |" >>out/check.md
    done
    note "summary"
    cat out/check.md
    return "$failed"
}

# need_tool command package
need_tool() {
    command -v "$1" >/dev/null || need_packages "$2"
    command -v "$1" >/dev/null || die 1 "$1 is missing and could not be installed: nothing was checked"
}

# The nightly compiler with further components: sanitizers, Miri and the fuzzers need it.
need_nightly() {
    local component
    command -v rustup >/dev/null || die 1 "rustup is missing, which installs nightly Rust: nothing was checked"
    cargo +nightly --version &>/dev/null || step rustup toolchain install nightly --profile minimal
    for component in "$@"; do
        rustup component list --toolchain nightly --installed | grep -q "^$component" ||
            step rustup component add --toolchain nightly "$component"
    done
}

# need_target triple: Rust's standard library for it.
need_target() {
    local libraries
    libraries=$(rustc --print target-libdir --target "$1")
    compgen -G "$libraries/libstd-*.rlib" >/dev/null && return
    command -v rustup >/dev/null || die 1 "rustup is missing, which installs Rust for $1: nothing was checked"
    step rustup target add "$1"
}

# Wine with a folder of its own, and MinGW, which makes the one library that older wines lack.
need_wine() {
    need_tool x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
    need_tool wine wine
    need_packages wine64
    # Outside this folder, because wine links to the whole file system from its own, and cargo follows links.
    export WINEDEBUG=-all WINEPREFIX="${XDG_CACHE_HOME:-$HOME/.cache}/pellicle/wine"
    mkdir -p "${WINEPREFIX%/*}"
    local system="$WINEPREFIX/drive_c/windows/system32"
    [[ -d "$system" ]] || step wineboot --init
    x86_64-w64-mingw32-gcc-posix -shared -static-libgcc checks/wine_bcryptprimitives.c -ladvapi32 \
        -o "$system/bcryptprimitives.dll"
}

# configure_cross folder toolchain [options]: the project for another platform, into build/check/<folder>.
configure_cross() {
    local folder="build/check/$1" toolchain=$2
    shift 2
    step cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release --toolchain "toolchains/$toolchain.cmake" "$@"
}

# study name [arguments]: one of the long checks of studies/, with its report in out/.
study() {
    step cargo run --locked --release -p pellicle-studies --bin check -- "$@" | tee "out/$1.md"
}

target_folder() {
    echo "${CARGO_TARGET_DIR:-$PWD/target}"
}

# run_ctest name target: one of the tests that `./x test` runs too.
run_ctest() {
    setup
    step cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
    step cmake --build build --target "$2"
    step ctest --test-dir build --output-on-failure --no-tests=error --tests-regex "^$1$"
}

host_triple() {
    rustc --version --verbose | sed -n 's/^host: //p'
}

# build_instrumented folder sanitizer target...: C, C++ and Rust with one sanitizer, into build/<folder>.
# Which symbols the Rust side must then refer to is for the caller to look at.
build_instrumented() {
    local folder="build/$1" sanitizer=$2
    shift 2
    # The compiler takes what a sanitizer adds for uses of what was never set.
    local flags="-fsanitize=$sanitizer -fno-omit-frame-pointer -g1 -Wno-maybe-uninitialized"
    export RUSTUP_TOOLCHAIN=nightly RUSTFLAGS="-Zsanitizer=$sanitizer"
    step cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" \
        -DPELLICLE_CARGO_TARGET="$(host_triple)" -DPELLICLE_CARGO_TARGET_DIR="$(target_folder)/$sanitizer"
    step cmake --build "$folder" --target "$@"
}

# must_refer_to library prefix: proof that a sanitizer is on.
must_refer_to() {
    local count
    count=$(nm "$1" | grep -cE " [UuTtWw] $2") || die 1 "$1 refers to no $2*: it is not instrumented"
    note "$1 refers to $count symbols $2*"
}
