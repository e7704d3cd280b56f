# tightflip_add_layer(NAME SOURCES ... [DEPENDS ...]): the library tightflip::NAME of one room.
function(tightflip_add_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 layer "" "" "SOURCES;DEPENDS")
    set(target tightflip_${name})
    add_library(${target} STATIC ${layer_SOURCES})
    add_library(tightflip::${name} ALIAS ${target})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} PUBLIC
        "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>"
        "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
    target_link_libraries(${target} PUBLIC ${layer_DEPENDS})
    set_target_properties(${target} PROPERTIES
        EXPORT_NAME ${name} OUTPUT_NAME tightflip_${name} POSITION_INDEPENDENT_CODE ON
        CXX_EXTENSIONS OFF)
    tightflip_warnings(${target})
    set_property(GLOBAL APPEND PROPERTY TIGHTFLIP_LAYERS ${name})
    if(TIGHTFLIP_INSTALL)
        install(TARGETS ${target} EXPORT tightflip-${name}
                ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
        install(EXPORT tightflip-${name} NAMESPACE tightflip::
                DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/tightflip")
        install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    endif()
endfunction()

# The warnings every target of the project is built with. GCC 12's -Wrestrict is wrong about
# concatenated strings (GCC bug 105651).
function(tightflip_warnings target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        $<$<BOOL:${TIGHTFLIP_WERROR}>:-Werror>)
endfunction()
