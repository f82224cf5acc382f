# Installs the library as a distribution would, moves the prefix elsewhere, and builds separate
# projects from it: with the CMake package and with pkg-config, shared and static, in C and C++.

find_program(PKG_CONFIG_EXECUTABLE NAMES pkg-config pkgconf REQUIRED)

set(consumer_dir "${CMAKE_CURRENT_LIST_DIR}")
set(consumer_environment
    "CC=${CMAKE_C_COMPILER}" "CXX=${CMAKE_CXX_COMPILER}" "PKG_CONFIG=${PKG_CONFIG_EXECUTABLE}")

# add_consumer_test(name layout command...): a test that needs the prefix of this layout.
function(add_consumer_test name layout)
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES
        FIXTURES_REQUIRED prefix.${layout}
        ENVIRONMENT "${consumer_environment}")
endfunction()

# Two depths of library directory: a path such as ${pcfiledir}/../.. fits only one of them.
set(consumer_layouts "plain=lib")
if(CMAKE_LIBRARY_ARCHITECTURE)
    list(APPEND consumer_layouts "multiarch=lib/${CMAKE_LIBRARY_ARCHITECTURE}")
endif()
foreach(layout_and_libdir IN LISTS consumer_layouts)
    string(REPLACE "=" ";" layout_and_libdir "${layout_and_libdir}")
    list(GET layout_and_libdir 0 layout)
    list(GET layout_and_libdir 1 libdir)
    set(work "${CMAKE_CURRENT_BINARY_DIR}/consumer/${layout}")
    set(prefix "${work}/moved")

    add_test(NAME package.install.${layout}
        COMMAND "${consumer_dir}/install_and_move.sh" "${CMAKE_COMMAND}" "${PROJECT_SOURCE_DIR}"
            "${PELLICLE_CARGO_TARGET_DIR}" ${libdir} ${pellicle_shared_name} "${work}")
    set_tests_properties(package.install.${layout} PROPERTIES FIXTURES_SETUP prefix.${layout})

    add_consumer_test(package.cmake.${layout} ${layout}
        "${CMAKE_CTEST_COMMAND}" --build-and-test "${consumer_dir}" "${work}/cmake"
            --build-generator "${CMAKE_GENERATOR}"
            --build-options "-Dpellicle_ROOT=${prefix}"
            --test-command "${CMAKE_CTEST_COMMAND}" --output-on-failure)
    add_consumer_test(package.pkg-config.${layout} ${layout}
        "${consumer_dir}/with_pkg_config.sh" "${prefix}/${libdir}" ${pellicle_shared_name}
            "${work}/pkg-config")
    add_consumer_test(example.c.cmake.${layout} ${layout}
        "${CMAKE_CTEST_COMMAND}" --build-and-test "${PROJECT_SOURCE_DIR}/examples/c" "${work}/example"
            --build-generator "${CMAKE_GENERATOR}"
            --build-options "-Dpellicle_ROOT=${prefix}"
            --test-command minimal)
    add_consumer_test(example.c.pkg-config.${layout} ${layout}
        "${consumer_dir}/compile_and_run.sh" "${prefix}/${libdir}"
            "${PROJECT_SOURCE_DIR}/examples/c/minimal.c" "${work}/minimal")
endforeach()

# A program linked to the library where cargo puts it starts: the library has its run-time name beside it.
add_test(NAME package.cargo
    COMMAND "${consumer_dir}/with_cargo.sh" "${PROJECT_BINARY_DIR}/cargo/place.txt" "${PROJECT_SOURCE_DIR}/include"
        "${CMAKE_CURRENT_BINARY_DIR}/consumer/with-cargo")
add_test(NAME package.cargo.elsewhere
    COMMAND "${consumer_dir}/cargo_elsewhere.sh" "${CMAKE_COMMAND}" "${PROJECT_SOURCE_DIR}" ${pellicle_shared_name}
        "${CMAKE_CURRENT_BINARY_DIR}/consumer/cargo-elsewhere")
set_tests_properties(package.cargo package.cargo.elsewhere PROPERTIES ENVIRONMENT "${consumer_environment}")
# A parent that adds pellicle as a subproject: it builds in the parent's folder and installs if asked.
foreach(way IN ITEMS add_subdirectory FetchContent)
    add_test(NAME package.subproject.${way}
        COMMAND "${consumer_dir}/as_subproject.sh" "${CMAKE_COMMAND}" "${PROJECT_SOURCE_DIR}"
            "${PELLICLE_CARGO_TARGET_DIR}" ${way} "${CMAKE_CURRENT_BINARY_DIR}/consumer/${way}")
    set_tests_properties(package.subproject.${way} PROPERTIES ENVIRONMENT "${consumer_environment}")
endforeach()
# Programs and plug-ins with the static library keep it to themselves.
add_consumer_test(package.plugins plain
    "${consumer_dir}/two_plugins.sh" "${CMAKE_CURRENT_BINARY_DIR}/consumer/plain/moved/lib" ${PROJECT_VERSION}
        "${CMAKE_CURRENT_BINARY_DIR}/consumer/plugins")

# The C++ example renders: one layout is enough, it takes some seconds.
add_consumer_test(example.cpp.cmake plain
    "${CMAKE_CTEST_COMMAND}" --build-and-test "${PROJECT_SOURCE_DIR}/examples/cpp"
            "${CMAKE_CURRENT_BINARY_DIR}/consumer/plain/example-cpp"
        --build-generator "${CMAKE_GENERATOR}"
        --build-options "-Dpellicle_ROOT=${CMAKE_CURRENT_BINARY_DIR}/consumer/plain/moved"
        --test-command "${consumer_dir}/render_and_check.sh" ./spheres spheres.png 8)

# The first C block of the README is what people paste: it compiles and runs as printed.
add_consumer_test(example.readme plain
    "${consumer_dir}/readme_example.sh" "${PROJECT_SOURCE_DIR}/README.md"
        "${CMAKE_CURRENT_BINARY_DIR}/consumer/plain/moved/lib" "${CMAKE_CURRENT_BINARY_DIR}/consumer/readme")
