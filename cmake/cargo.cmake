# pellicle::shared and pellicle::static, built by cargo.

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

# The files in toolchains/ name their target. A sanitizer instruments what is built for a target that is named, and
# leaves build scripts alone.
set(PELLICLE_CARGO_TARGET "" CACHE STRING "Target triple that cargo builds for; empty: cargo's own choice")

include(cmake/platform.cmake)
set(pellicle_library_dir "${PROJECT_BINARY_DIR}/lib")
set(pellicle_shared_library "${pellicle_library_dir}/${pellicle_shared_name}")
set(pellicle_link_library "${pellicle_library_dir}/${pellicle_link_name}")
set(pellicle_static_library "${pellicle_library_dir}/${pellicle_static_name}")
set(pellicle_cargo_static_library "${PROJECT_BINARY_DIR}/cargo/${pellicle_static_name}")

# What is copied from where cargo puts it: the name that it has there, and the copy. The shared ELF library gets its
# run-time name, which programs ask for.
set(pellicle_copies "${pellicle_static_name}=${pellicle_cargo_static_library}")
set(pellicle_built_libraries "${pellicle_cargo_static_library}")
set(pellicle_link_command "")
if(PELLICLE_SHARED)
    list(APPEND pellicle_built_libraries "${pellicle_shared_library}")
    if(pellicle_shared_name MATCHES "\\.so")
        list(APPEND pellicle_copies "${pellicle_link_name}=${pellicle_shared_library}")
        set(pellicle_link_command
            COMMAND "${CMAKE_COMMAND}" -E create_symlink ${pellicle_shared_name} "${pellicle_link_library}")
        list(APPEND pellicle_built_libraries "${pellicle_link_library}")
    else()
        list(APPEND pellicle_copies "${pellicle_shared_name}=${pellicle_shared_library}")
        if(WIN32)
            list(APPEND pellicle_copies "${pellicle_link_name}=${pellicle_link_library}")
            list(APPEND pellicle_built_libraries "${pellicle_link_library}")
        endif()
    endif()
endif()

set(pellicle_cross_linker "")
if(CMAKE_CROSSCOMPILING)
    set(pellicle_cross_linker "-Dlinker=${CMAKE_C_COMPILER}")
endif()

# Always run: only cargo knows whether its inputs changed. Copies keep their time stamps when
# nothing did, so that an idle build relinks nothing.
file(MAKE_DIRECTORY "${pellicle_library_dir}" "${PROJECT_BINARY_DIR}/cargo")
add_custom_target(pellicle_cargo ALL
    COMMAND "${CMAKE_COMMAND}"
        "-Dcargo=${PELLICLE_CARGO}" "-Dtarget_dir=${PELLICLE_CARGO_TARGET_DIR}" "-Dtarget=${PELLICLE_CARGO_TARGET}"
        ${pellicle_cross_linker} "-Dcopies=${pellicle_copies}" "-Dplace=${PROJECT_BINARY_DIR}/cargo/place.txt"
        -P "${CMAKE_CURRENT_LIST_DIR}/run_cargo.cmake"
    ${pellicle_link_command}
    BYPRODUCTS ${pellicle_built_libraries}
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    COMMENT "cargo build --release --locked"
    USES_TERMINAL
    VERBATIM)

include(cmake/static_library.cmake)

if(PELLICLE_SHARED)
    add_library(pellicle::shared SHARED IMPORTED GLOBAL)
    set_target_properties(pellicle::shared PROPERTIES
        IMPORTED_LOCATION "${pellicle_shared_library}"
        INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include")
    if(WIN32)
        set_target_properties(pellicle::shared PROPERTIES IMPORTED_IMPLIB "${pellicle_link_library}")
    elseif(NOT APPLE)
        set_target_properties(pellicle::shared PROPERTIES IMPORTED_SONAME ${pellicle_shared_name})
    endif()
    add_dependencies(pellicle::shared pellicle_cargo)
endif()

add_library(pellicle::static STATIC IMPORTED GLOBAL)
set_target_properties(pellicle::static PROPERTIES
    IMPORTED_LOCATION "${pellicle_static_library}"
    INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include"
    INTERFACE_LINK_LIBRARIES "${pellicle_static_dependencies}"
    INTERFACE_LINK_OPTIONS "${pellicle_static_link_options}")
add_dependencies(pellicle::static pellicle_static_library)
