# The static library without symbols of its own, but for the functions of the header, which are hidden: a program or
# plug-in that is linked with it exports none of them. Two plug-ins in one process, each with another version of
# pellicle, would otherwise both run the code of the one that was loaded first; and two static libraries written in
# Rust would define the standard library twice.
#
# A link option (--exclude-libs) would do less: every program would have to be given it, by whatever build system,
# and Rust's standard library would stay global in the archive. On Windows and macOS a library's functions are bound
# to the file that they were linked into, and cargo's archive is offered as it is.

option(PELLICLE_STATIC_EXPORT "Let programs export pellicle's functions out of the static library" OFF)

if(NOT pellicle_localise_symbols)
    add_custom_command(OUTPUT "${pellicle_static_library}"
        COMMAND "${CMAKE_COMMAND}" -E copy "${pellicle_cargo_static_library}" "${pellicle_static_library}"
        DEPENDS "${pellicle_cargo_static_library}"
        VERBATIM)
else()
    # GNU's linker is asked for, because LLVM's does not collect unused sections in a relocatable link.
    set(pellicle_gnu_ld "${CMAKE_LINKER}")
    if(CMAKE_LINKER MATCHES "lld|gold|mold")
        find_program(PELLICLE_GNU_LD NAMES ld.bfd ld REQUIRED)
        set(pellicle_gnu_ld "${PELLICLE_GNU_LD}")
    endif()
    if(NOT pellicle_gnu_ld OR NOT CMAKE_OBJCOPY OR NOT CMAKE_AR)
        message(FATAL_ERROR "ld, objcopy and ar make the static library: install binutils")
    endif()

    # An object that names each function as a hidden one: in a relocatable link the strictest visibility wins.
    file(STRINGS include/pellicle.h pellicle_functions REGEX "^[A-Za-z].* \\*?pellicle_[a-z_]+\\(")
    list(TRANSFORM pellicle_functions REPLACE "^.*[ *](pellicle_[a-z_]+)\\(.*$" "\\1")
    list(TRANSFORM pellicle_functions REPLACE "^(.+)$" "    (Function)\\1," OUTPUT_VARIABLE pellicle_references)
    list(TRANSFORM pellicle_functions PREPEND "--undefined=" OUTPUT_VARIABLE pellicle_roots)
    list(JOIN pellicle_references "\n" pellicle_references)
    set(pellicle_visibility hidden)
    if(PELLICLE_STATIC_EXPORT)
        set(pellicle_visibility default)
    endif()
    configure_file(cmake/visibility.c.in "${PROJECT_BINARY_DIR}/cargo/visibility.c" @ONLY)
    add_library(pellicle_visibility OBJECT "${PROJECT_BINARY_DIR}/cargo/visibility.c")
    target_include_directories(pellicle_visibility PRIVATE "${PROJECT_SOURCE_DIR}/include")
    # What a whole build may ask for is not for this object: it has no code, and the linker below takes no plug-ins.
    target_compile_options(pellicle_visibility PRIVATE -fPIC -fno-lto -fno-sanitize=all)

    # Debian's libgcc_eh needs glibc: for musl Rust brings an unwinder of its own.
    set(pellicle_unwinder "")
    if(PELLICLE_CARGO_TARGET MATCHES "musl")
        cmake_path(GET PELLICLE_CARGO PARENT_PATH pellicle_rust_dir)
        find_program(PELLICLE_RUSTC rustc HINTS "${pellicle_rust_dir}" REQUIRED)
        execute_process(COMMAND "${PELLICLE_RUSTC}" --print target-libdir --target "${PELLICLE_CARGO_TARGET}"
            OUTPUT_VARIABLE pellicle_rust_libraries OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
        find_library(PELLICLE_UNWINDER unwind NO_DEFAULT_PATH REQUIRED
            PATHS "${pellicle_rust_libraries}/self-contained")
        set(pellicle_unwinder "${PELLICLE_UNWINDER}")
    endif()

    set(pellicle_object "${PROJECT_BINARY_DIR}/cargo/pellicle.o")
    add_custom_command(OUTPUT "${pellicle_static_library}"
        COMMAND "${pellicle_gnu_ld}" --relocatable --force-group-allocation --gc-sections ${pellicle_roots}
            -o "${pellicle_object}" $<TARGET_OBJECTS:pellicle_visibility> "${pellicle_cargo_static_library}" ${pellicle_unwinder}
        # The compiler's intermediate code in the sections .llvm* confuses other versions of its tools.
        COMMAND "${CMAKE_OBJCOPY}" --strip-debug --remove-section=.pellicle.visibility "--remove-section=.llvm*"
            --wildcard "--keep-global-symbol=pellicle_*" "${pellicle_object}"
        COMMAND "${CMAKE_COMMAND}" -E rm -f "${pellicle_static_library}"
        COMMAND "${CMAKE_AR}" rcs "${pellicle_static_library}" "${pellicle_object}"
        DEPENDS "${pellicle_cargo_static_library}" $<TARGET_OBJECTS:pellicle_visibility>
        COMMENT "Hiding the symbols of ${pellicle_static_name}"
        VERBATIM
        COMMAND_EXPAND_LISTS)
endif()
add_custom_target(pellicle_static_library ALL DEPENDS "${pellicle_static_library}")
add_dependencies(pellicle_static_library pellicle_cargo)
