# 64-bit Windows, under wine: DLL, import library and static library, and the ABI tests with both. `./x package` tries
# the CMake package and the C example there.
need_target x86_64-pc-windows-gnu
need_packages cmake ninja-build doctest-dev
need_wine
configure_cross windows x86_64-windows-gnu
step cmake --build build/check/windows
# In one process each: a start of wine takes longer than most tests.
cp build/check/windows/lib/pellicle.dll build/check/windows/bin
step wine build/check/windows/bin/abi_shared.exe
step wine build/check/windows/bin/abi_static.exe
