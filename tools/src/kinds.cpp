#include "kinds.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace tightflip::tools {

using properties::StartKind;

std::string kinds_in_words() {
    std::string text = "One of:";
    for (const StartKind& kind : properties::start_kinds()) {
        text += fmt::format("\n  {:<13} {}", kind.name, kind.description);
    }
    return text;
}

const StartKind& kind_named(const std::string& name, kernel::Index genus) {
    const StartKind* kind = properties::find_start_kind(name);
    if (kind == nullptr) {
        throw std::invalid_argument("there is no kind '" + name +
                                    "'; 'tightflip make --help' lists them");
    }
    if (genus != 0 && !kind->any_genus) {
        throw std::invalid_argument("the genus of a " + name +
                                    " cannot be chosen; use the kinds 'genus' or 'random'");
    }
    return *kind;
}

}  // namespace tightflip::tools
