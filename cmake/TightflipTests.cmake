# tightflip_add_tests(LAYER SOURCES ... [DEPENDS ...] [PRECOMPILE ...]): one GoogleTest binary for a
# room's tests, one CTest entry a test case. Headers that most of the tests include are parsed once.
find_package(GTest REQUIRED)
include(GoogleTest)

function(tightflip_add_tests layer)
    cmake_parse_arguments(PARSE_ARGV 1 tests "" "" "SOURCES;DEPENDS;PRECOMPILE")
    set(target ${layer}_tests)
    add_executable(${target} ${tests_SOURCES})
    target_link_libraries(${target} PRIVATE ${tests_DEPENDS} GTest::gtest GTest::gmock
                                            GTest::gtest_main)
    target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_precompile_headers(${target} PRIVATE <gmock/gmock.h> <gtest/gtest.h> ${tests_PRECOMPILE})
    # Compiled fast rather than for speed: what takes time in a test is in the libraries.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    tightflip_warnings(${target})
    gtest_discover_tests(${target} TEST_PREFIX "${layer}." DISCOVERY_TIMEOUT 60
                         PROPERTIES TIMEOUT 600)
endfunction()
