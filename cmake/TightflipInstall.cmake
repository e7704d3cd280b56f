# What makes the installed tree usable: find_package(tightflip CONFIG) and pkg-config.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/tightflip")
configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/tightflipConfig.cmake.in" tightflipConfig.cmake
    INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(tightflipConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/tightflipConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/tightflipConfigVersion.cmake"
        DESTINATION "${package_dir}")

# The way from the pkg-config folder back to the prefix, so that an installed tree can be moved.
file(RELATIVE_PATH TIGHTFLIP_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")

# One pkg-config file a layer: what it stands on, and what that needs from elsewhere.
function(tightflip_install_pkgconfig layer description requires)
    set(TIGHTFLIP_LAYER ${layer})
    set(TIGHTFLIP_LAYER_DESCRIPTION "${description}")
    set(TIGHTFLIP_LAYER_REQUIRES "${requires}")
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/tightflip-layer.pc.in"
                   "tightflip-${layer}.pc" @ONLY)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/tightflip-${layer}.pc"
            DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

tightflip_install_pkgconfig(kernel "combinatorial triangulated surfaces and their flips" "")
tightflip_install_pkgconfig(geometry "mesh files and coordinates" "tightflip-kernel, eigen3")
tightflip_install_pkgconfig(properties "generators, invariants and claims as checks"
                            "tightflip-geometry")
