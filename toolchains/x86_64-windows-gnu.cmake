# 64-bit Windows with MinGW-w64; programs run under wine. Debian's "posix" variant has std::thread.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# Programs carry MinGW's own libraries, whose DLLs no Windows has.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
set(PELLICLE_CARGO_TARGET x86_64-pc-windows-gnu CACHE STRING "")
