#include "kinds.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace tightflip::tools {

using properties::StartKind;

namespace {

[[noreturn]] void refuse_genus(const std::string& name) {
    throw std::invalid_argument("the genus of a " + name +
                                " cannot be chosen; use the kinds 'genus' or 'random'");
}

}  // namespace

std::string kinds_in_words() {
    std::string text = "One of:";
    for (const StartKind& kind : properties::start_kinds()) {
        text += fmt::format("\n  {:<17} {}", kind.name, kind.description);
    }
    text += "\nor, with points:";
    for (const geometry::DataSet& set : geometry::all_data_sets()) {
        text += fmt::format("\n  {:<17} {}", set.name, set.description);
    }
    return text;
}

const StartKind& kind_named(const std::string& name, kernel::Index genus) {
    const StartKind* kind = properties::find_start_kind(name);
    if (kind == nullptr) {
        throw std::invalid_argument("there is no kind '" + name +
                                    "'; 'tightflip make --help' lists them");
    }
    if (genus != 0 && !kind->any_genus) refuse_genus(name);
    return *kind;
}

const geometry::DataSet* data_set_named(const std::string& name, kernel::Index genus) {
    const geometry::DataSet* set = geometry::find_data_set(name);
    if (set != nullptr && genus != 0) refuse_genus(name);
    return set;
}

}  // namespace tightflip::tools
