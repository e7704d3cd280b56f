#include <tightflip/properties/kernel_property.hpp>

#include <algorithm>
#include <array>

namespace tightflip::properties {
namespace {

struct CodeName {
    KernelCode code;
    std::string_view name;
};
constexpr std::array code_names{
    CodeName{KernelCode::start_differs, "start_differs"},
    CodeName{KernelCode::sides_unreadable, "sides_unreadable"},
    CodeName{KernelCode::counts_differ, "counts_differ"},
    CodeName{KernelCode::topology_changed, "topology_changed"},
    CodeName{KernelCode::changed_elsewhere, "changed_elsewhere"},
    CodeName{KernelCode::not_the_flip, "not_the_flip"},
    CodeName{KernelCode::flip_back_refused, "flip_back_refused"},
    CodeName{KernelCode::flip_back_differs, "flip_back_differs"},
    CodeName{KernelCode::four_flips_differ, "four_flips_differ"},
    CodeName{KernelCode::side_moved, "side_moved"},
    CodeName{KernelCode::invalid_flip_allowed, "invalid_flip_allowed"},
    CodeName{KernelCode::valid_flip_refused, "valid_flip_refused"},
    CodeName{KernelCode::invalid_accepted, "invalid_accepted"},
    CodeName{KernelCode::valid_rejected, "valid_rejected"},
    CodeName{KernelCode::wrong_origin_accepted, "wrong_origin_accepted"},
    CodeName{KernelCode::wrong_next_accepted, "wrong_next_accepted"},
    CodeName{KernelCode::wrong_across_accepted, "wrong_across_accepted"},
    CodeName{KernelCode::forbidden_edge_accepted, "forbidden_edge_accepted"},
    CodeName{KernelCode::answers_differ_from_ours, "answers_differ_from_ours"},
    CodeName{KernelCode::surface_differs_from_ours, "surface_differs_from_ours"},
    CodeName{KernelCode::threw, "threw"},
    CodeName{KernelCode::crashed_or_hung, "crashed_or_hung"},
    CodeName{KernelCode::crashed_or_hung_on_damage, "crashed_or_hung_on_damage"},
};

struct PropertyName {
    KernelProperty property;
    std::string_view name;
    std::string_view words;
    std::string_view why_not_asked;
};
constexpr std::string_view no_flip = "no flip was done";
constexpr std::array property_names{
    PropertyName{KernelProperty::reading, "reading",
                 "it holds the surface it was given, and counts it right", "no start was made"},
    PropertyName{KernelProperty::topology, "topology",
                 "flips keep counts, Euler characteristic, connectedness and orientability",
                 no_flip},
    PropertyName{KernelProperty::locality, "locality",
                 "nothing outside the two faces at the edge changes", no_flip},
    PropertyName{KernelProperty::definition, "definition", "a flip is the diagonal flip", no_flip},
    PropertyName{KernelProperty::inverse, "inverse",
                 "a second flip of the edge gives the old surface, four flips the old sides",
                 "no flip was taken back"},
    PropertyName{KernelProperty::handles, "handles", "sides of other edges keep their meaning",
                 "that is not promised, or no flip was done"},
    PropertyName{KernelProperty::legality, "legality",
                 "the kernel says yes exactly where the result is valid in its class",
                 "no edge was asked about"},
    PropertyName{KernelProperty::validator, "validator",
                 "the kernel's own validator says what the audit says, of results and of planted "
                 "faults",
                 "it never met an invalid surface"},
    PropertyName{KernelProperty::agreement, "agreement",
                 "step by step the answers and the surface of tightflip's kernel", no_flip},
    PropertyName{KernelProperty::survival, "survival", "no exception, crash or endless loop",
                 no_flip},
};
static_assert(property_names.size() == Questions{}.size());

}  // namespace

std::string_view name(KernelProperty property) noexcept {
    return property_names[static_cast<std::size_t>(property)].name;
}

std::string_view describe(KernelProperty property) noexcept {
    return property_names[static_cast<std::size_t>(property)].words;
}

std::string_view why_not_asked(KernelProperty property) noexcept {
    return property_names[static_cast<std::size_t>(property)].why_not_asked;
}

std::string_view name(KernelCode code) noexcept {
    const auto* const found = std::ranges::find(code_names, code, &CodeName::code);
    return found == code_names.end() ? std::string_view("unknown") : found->name;
}

KernelProperty property_of(KernelCode code) noexcept {
    return static_cast<KernelProperty>(static_cast<int>(code) / 100 - 1);
}

std::span<const KernelProperty> all_kernel_properties() noexcept {
    static constexpr auto all = [] {
        std::array<KernelProperty, property_names.size()> properties{};
        std::ranges::transform(property_names, properties.begin(), &PropertyName::property);
        return properties;
    }();
    return all;
}

}  // namespace tightflip::properties
