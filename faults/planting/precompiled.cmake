# What the libraries' sources include most, parsed once: a fault in a header compiles many of them.
# (Not <filesystem>, which would bring std::quoted in beside the kernel's own.)
set(standard <algorithm> <array> <cstdint> <fstream> <functional> <map> <memory>
    <numeric> <optional> <ostream> <span> <stdexcept> <string> <string_view> <utility> <variant>
    <vector>)
cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${CMAKE_SOURCE_DIR}]] CALL
    target_precompile_headers tightflip_kernel PRIVATE ${standard})")
cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${CMAKE_SOURCE_DIR}]] CALL
    target_precompile_headers tightflip_geometry PRIVATE ${standard} <Eigen/Geometry>)")
cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${CMAKE_SOURCE_DIR}]] CALL
    target_precompile_headers tightflip_properties PRIVATE ${standard} <sstream>
    <Eigen/Geometry>)")
