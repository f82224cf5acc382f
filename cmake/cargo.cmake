# pellicle::shared and pellicle::static, built by cargo for the host.

find_program(PELLICLE_CARGO cargo HINTS "$ENV{CARGO_HOME}/bin" "$ENV{HOME}/.cargo/bin" REQUIRED)

# One target directory for cargo, CMake and ./x, so that nothing is compiled twice. Like cargo, a
# set CARGO_TARGET_DIR wins. A subproject leaves its sources alone and builds in its parent's build folder.
if(DEFINED ENV{CARGO_TARGET_DIR})
    set(pellicle_default_target_dir "$ENV{CARGO_TARGET_DIR}")
elseif(PROJECT_IS_TOP_LEVEL)
    set(pellicle_default_target_dir target)
else()
    set(pellicle_default_target_dir "${PROJECT_BINARY_DIR}/target")
endif()
cmake_path(ABSOLUTE_PATH pellicle_default_target_dir BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" NORMALIZE)
set(PELLICLE_CARGO_TARGET_DIR "${pellicle_default_target_dir}" CACHE PATH "Where cargo builds")

# A sanitizer instruments what is built for a target that is named, and leaves build scripts alone.
set(PELLICLE_CARGO_TARGET "" CACHE STRING "Target triple that cargo builds for; empty: the host's, not named")
set(pellicle_cargo_output "${PELLICLE_CARGO_TARGET_DIR}/release")
set(pellicle_cargo_target_option "")
if(PELLICLE_CARGO_TARGET)
    set(pellicle_cargo_output "${PELLICLE_CARGO_TARGET_DIR}/${PELLICLE_CARGO_TARGET}/release")
    set(pellicle_cargo_target_option --target "${PELLICLE_CARGO_TARGET}")
endif()

# The shared library is copied to its run-time name: the dynamic linker asks for the SONAME, which
# changes only with the ABI (PELLICLE_ABI_VERSION; build.rs sets the same name).
file(STRINGS include/pellicle.h pellicle_abi_version REGEX "^#define PELLICLE_ABI_VERSION " LIMIT_COUNT 1)
string(REGEX REPLACE ".* " "" pellicle_abi_version "${pellicle_abi_version}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS include/pellicle.h)
set(pellicle_soname libpellicle.so.${pellicle_abi_version})
set(pellicle_library_dir "${PROJECT_BINARY_DIR}/lib")
set(pellicle_shared_library "${pellicle_library_dir}/${pellicle_soname}")
set(pellicle_shared_link "${pellicle_library_dir}/libpellicle.so")
set(pellicle_static_library "${pellicle_library_dir}/libpellicle.a")

# What Rust's standard library needs from the system, in the order of
# `cargo rustc --release --lib --crate-type staticlib -- --print native-static-libs`.
set(pellicle_static_dependencies gcc_s util rt pthread m dl c)

# Always run: only cargo knows whether its inputs changed. Copies keep their time stamps when
# nothing did, so that an idle build relinks nothing.
file(MAKE_DIRECTORY "${pellicle_library_dir}")
add_custom_target(pellicle_cargo ALL
    COMMAND "${PELLICLE_CARGO}" build --release --locked --target-dir "${PELLICLE_CARGO_TARGET_DIR}"
        ${pellicle_cargo_target_option}
    COMMAND "${CMAKE_COMMAND}" -E copy_if_different
        "${pellicle_cargo_output}/libpellicle.so" "${pellicle_shared_library}"
    COMMAND "${CMAKE_COMMAND}" -E create_symlink ${pellicle_soname} "${pellicle_shared_link}"
    COMMAND "${CMAKE_COMMAND}" -E copy_if_different
        "${pellicle_cargo_output}/libpellicle.a" "${pellicle_static_library}"
    BYPRODUCTS "${pellicle_shared_library}" "${pellicle_shared_link}" "${pellicle_static_library}"
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    COMMENT "cargo build --release --locked"
    USES_TERMINAL
    VERBATIM)

add_library(pellicle::shared SHARED IMPORTED GLOBAL)
set_target_properties(pellicle::shared PROPERTIES
    IMPORTED_LOCATION "${pellicle_shared_library}"
    IMPORTED_SONAME ${pellicle_soname}
    INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include")

add_library(pellicle::static STATIC IMPORTED GLOBAL)
set_target_properties(pellicle::static PROPERTIES
    IMPORTED_LOCATION "${pellicle_static_library}"
    INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include"
    INTERFACE_LINK_LIBRARIES "${pellicle_static_dependencies}")

add_dependencies(pellicle::shared pellicle_cargo)
add_dependencies(pellicle::static pellicle_cargo)
