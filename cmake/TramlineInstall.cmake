# What `cmake --install` leaves: the program, the public headers, static libraries, and the package that find_package(tramline) finds.

include(CMakePackageConfigHelpers)

# tramline::tramline is all rooms; tramline::planner and so on are there one by one.
get_property(modules GLOBAL PROPERTY TRAMLINE_MODULES)
add_library(tramline_all INTERFACE)
add_library(tramline::tramline ALIAS tramline_all)
target_link_libraries(tramline_all INTERFACE ${modules})
target_compile_features(tramline_all INTERFACE cxx_std_20)
set_target_properties(tramline_all PROPERTIES EXPORT_NAME tramline)
install(TARGETS tramline_all EXPORT tramlineTargets)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/tramline" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        FILES_MATCHING PATTERN "*.h")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/tramline")
install(EXPORT tramlineTargets NAMESPACE tramline:: DESTINATION "${package_dir}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/tramlineConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/tramlineConfig.cmake" INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may change what is public.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tramlineConfigVersion.cmake"
                                 VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/tramlineConfig.cmake" "${PROJECT_BINARY_DIR}/tramlineConfigVersion.cmake"
        DESTINATION "${package_dir}")
