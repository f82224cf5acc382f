# 64-bit x86 Linux with musl, as a C library that programs are linked to statically: Debian's musl-tools have a C
# compiler and no C++ compiler. Programs run as they are.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER musl-gcc)
set(PELLICLE_CARGO_TARGET x86_64-unknown-linux-musl CACHE STRING "")
