# `cpack` makes a .tar.gz, a .zip for Windows, and a .deb. `./x package` does so for every platform.

set(CPACK_PACKAGE_NAME pellicle)
set(CPACK_PACKAGE_VENDOR "The pellicle developers")
set(CPACK_PACKAGE_CONTACT "The pellicle developers")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE-MIT")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Layered and thin-film reflectance for renderers (library and headers)")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES OFF)
if(PELLICLE_CARGO_TARGET)
    set(CPACK_SYSTEM_NAME "${PELLICLE_CARGO_TARGET}")
else()
    set(CPACK_SYSTEM_NAME "${CMAKE_SYSTEM_PROCESSOR}-${CMAKE_SYSTEM_NAME}")
endif()
set(CPACK_GENERATOR TGZ)
if(WIN32)
    set(CPACK_GENERATOR ZIP)
endif()

set(CPACK_DEBIAN_PACKAGE_NAME libpellicle-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Reflectance models and thin films as eval, sample and pdf for renderers
 written in C and C++: the shared and the static library, headers, and files
 for CMake and pkg-config.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/packaging/triggers")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE amd64)
endif()
# What the package depends on is read from the library once it is built.
configure_file(cmake/package_config.cmake.in "${PROJECT_BINARY_DIR}/package/package_config.cmake" @ONLY)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_BINARY_DIR}/package/package_config.cmake")

include(CPack)
