# cmake -D OUTPUT=FILE.cpp -D LIBRARIES=FILE;... -P assemble.cmake
# Puts the page of a report together, without its data, and writes it as C++ source. Without
# libraries the text is empty.
set(page "")
if(LIBRARIES)
    set(libraries "")
    foreach(library IN LISTS LIBRARIES)
        file(READ "${library}" text)
        string(APPEND libraries "${text}\n")
    endforeach()
    file(READ "${CMAKE_CURRENT_LIST_DIR}/page.css" style)
    file(READ "${CMAKE_CURRENT_LIST_DIR}/page.js" script)
    file(READ "${CMAKE_CURRENT_LIST_DIR}/page.html" page)
    # What is inlined must neither end its element nor hold a place that is filled in later.
    foreach(part IN ITEMS libraries style script)
        if("${${part}}" MATCHES
           "</(script|style)|<!--|{{(title|data|style|libraries|script)}}|\\)_page_\"")
            message(FATAL_ERROR "the ${part} of the report cannot be inlined: ${CMAKE_MATCH_0}")
        endif()
        string(REPLACE "{{${part}}}" "${${part}}" page "${page}")
    endforeach()
endif()
file(WRITE "${OUTPUT}" "#include \"report_page_text.hpp\"

namespace tightflip::tools {

std::string_view report_page_text() noexcept {
    return R\"_page_(${page})_page_\";
}

}  // namespace tightflip::tools
")
