#include "target.hpp"

#include <exception>

namespace tightflip::fuzz {

bool is_of_this_version(const Layout& layout, Input input) {
    return layout.is_text() || (!input.empty() && input.front() == format_version);
}

std::string objection(const Target& target, Input input) {
    try {
        return target.objection(input);
    } catch (const std::exception& error) {
        return std::string("exception: ") + error.what();
    }
}

std::string_view claim_of(std::string_view objection) {
    return objection.substr(0, objection.find(':'));
}

}  // namespace tightflip::fuzz
