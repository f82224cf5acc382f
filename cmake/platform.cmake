# What the libraries are called on the platform of the C compiler, and what they need from its system.

# Rust's targets for musl link statically and offer no shared library.
if(PELLICLE_CARGO_TARGET MATCHES "musl")
    set(pellicle_shared_default OFF)
else()
    set(pellicle_shared_default ON)
endif()
option(PELLICLE_SHARED "Build and install the shared library" ${pellicle_shared_default})

# The number of the binary interface, which the name of an ELF library carries (build.rs sets the same SONAME).
file(STRINGS include/pellicle.h pellicle_abi_version REGEX "^#define PELLICLE_ABI_VERSION " LIMIT_COUNT 1)
string(REGEX REPLACE ".* " "" pellicle_abi_version "${pellicle_abi_version}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS include/pellicle.h)

# pellicle_shared_name   the file that a program loads
# pellicle_link_name     the file that a program is linked with: a link to the former, or an import library
# pellicle_static_name
# pellicle_static_dependencies: what Rust's standard library needs, without what every C compiler adds by itself
# (libgcc_s or, under -static, libgcc_eh; libc). To be compared with
# `cargo rustc --release --lib --crate-type staticlib --target ... -- --print native-static-libs`.
# pellicle_static_link_options: what a program with the static library needs besides libraries
set(pellicle_static_name libpellicle.a)
set(pellicle_static_link_options "")
set(pellicle_localise_symbols OFF)
if(WIN32)
    set(pellicle_shared_name pellicle.dll)
    set(pellicle_static_dependencies kernel32 ntdll userenv ws2_32 dbghelp)
    if(MSVC)
        set(pellicle_link_name pellicle.dll.lib)
        set(pellicle_static_name pellicle.lib)
    else()
        set(pellicle_link_name libpellicle.dll.a)
    endif()
elseif(APPLE)
    set(pellicle_shared_name libpellicle.dylib)
    set(pellicle_link_name libpellicle.dylib)
    set(pellicle_static_dependencies iconv m)
else()
    set(pellicle_shared_name libpellicle.so.${pellicle_abi_version})
    set(pellicle_link_name libpellicle.so)
    set(pellicle_static_dependencies util rt pthread m dl)
    set(pellicle_localise_symbols ON)
    if(PELLICLE_CARGO_TARGET MATCHES "musl")
        # The compiler for musl leaves out the index by which Rust's unwinder finds its way when it stops a panic.
        set(pellicle_static_link_options -Wl,--eh-frame-hdr)
    endif()
endif()
