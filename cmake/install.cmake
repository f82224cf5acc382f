# `cmake --install`: headers, both libraries, a CMake package and a pkg-config file. Both packages
# find everything relative to themselves, so that the prefix can be moved.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(FILES include/pellicle.h include/pellicle.hpp DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(FILES LICENSE-MIT LICENSE-APACHE packaging/copyright DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES "${pellicle_static_library}" DESTINATION "${CMAKE_INSTALL_LIBDIR}")
set(pellicle_runtime_dir "${CMAKE_INSTALL_LIBDIR}")
if(WIN32)
    set(pellicle_runtime_dir "${CMAKE_INSTALL_BINDIR}")
endif()
if(PELLICLE_SHARED)
    install(FILES "${pellicle_shared_library}" DESTINATION "${pellicle_runtime_dir}")
    if(NOT pellicle_link_library STREQUAL pellicle_shared_library)
        install(FILES "${pellicle_link_library}" DESTINATION "${CMAKE_INSTALL_LIBDIR}")
    endif()
endif()

# CMake package. Below 1.0 a new minor version may break the API, hence SameMinorVersion.
set(pellicle_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/pellicle")
configure_package_config_file(
    cmake/pellicle-config.cmake.in "${PROJECT_BINARY_DIR}/package/pellicle-config.cmake"
    INSTALL_DESTINATION "${pellicle_cmake_dir}"
    PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR pellicle_runtime_dir
    NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/pellicle-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/package/pellicle-config.cmake"
    "${PROJECT_BINARY_DIR}/package/pellicle-config-version.cmake"
    DESTINATION "${pellicle_cmake_dir}")

# pkg-config. How many directories lie between the .pc file and the prefix depends on the
# distribution (lib, lib64, lib/x86_64-linux-gnu), so the way is computed, not written.
set(pellicle_pkgconfig_dir "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH pellicle_pc_to_prefix "${pellicle_pkgconfig_dir}" "${CMAKE_INSTALL_PREFIX}")
file(RELATIVE_PATH pellicle_pc_to_include "${pellicle_pkgconfig_dir}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
list(TRANSFORM pellicle_static_dependencies PREPEND "-l" OUTPUT_VARIABLE pellicle_pc_libs_private)
list(APPEND pellicle_pc_libs_private ${pellicle_static_link_options})
list(JOIN pellicle_pc_libs_private " " pellicle_pc_libs_private)
set(pellicle_pc_libs "-L\${libdir} -lpellicle")
if(NOT PELLICLE_SHARED)
    string(APPEND pellicle_pc_libs " ${pellicle_pc_libs_private}")
endif()
configure_file(cmake/pellicle.pc.in "${PROJECT_BINARY_DIR}/package/pellicle.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/package/pellicle.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
