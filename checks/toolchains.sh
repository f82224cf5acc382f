# Both headers, and programs that use them, with GCC and clang in every edition of C from 99 and of C++ from 17, with
# warnings as errors. `./x test` does so with the C compiler that CMake has found.
need_tool gcc gcc
need_tool g++ g++
need_tool clang clang
for compilers in "gcc g++" "clang clang++"; do
    read -r CC CXX <<<"$compilers"
    CC=$CC CXX=$CXX step cpp_tests/abi/header_editions.sh
done
