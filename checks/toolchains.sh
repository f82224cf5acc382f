# Both headers, and programs that use them, with GCC and clang in every edition of C from 99 and of C++ from 17, with
# warnings as errors. `./x test` does so with the C compiler that CMake has found.
need_tool gcc gcc
need_tool g++ g++
need_tool clang clang
need_packages cmake ninja-build
for compilers in "gcc g++" "clang clang++"; do
    read -r CC CXX <<<"$compilers"
    CC=$CC CXX=$CXX step cpp_tests/abi/header_editions.sh
done
# The project itself with clang and its binutils, installed and used with find_package.
folder=build/check/clang
step cmake -S . -B $folder -G Ninja -DPELLICLE_BUILD_TESTS=OFF -DCMAKE_C_COMPILER=clang -DCMAKE_INSTALL_LIBDIR=lib
step cmake --build $folder
rm -rf $folder-prefix $folder-consumer
step cmake --install $folder --prefix $folder-prefix
step ctest --build-and-test cpp_tests/consumer $folder-consumer --build-generator Ninja --build-options \
    "-Dpellicle_ROOT=$PWD/$folder-prefix" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    --test-command ctest --output-on-failure
