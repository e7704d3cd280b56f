#include "script_input.hpp"

#include <map>
#include <stdexcept>
#include <tuple>

namespace tightflip::fuzz {

using properties::start_kinds;

properties::FlipCase decode_start(Bytes& bytes) {
    const auto kinds = start_kinds();
    properties::FlipCase flip_case;
    flip_case.kind = &kinds[bytes.byte() % kinds.size()];
    const kernel::Index spare = bytes.below(most_spare_vertices + 1);
    const kernel::Index genus = bytes.below(most_genus + 1);
    if (flip_case.kind->any_genus) flip_case.request.genus = genus;
    flip_case.request.vertices = flip_case.kind->least_vertices(flip_case.request.genus) + spare;
    flip_case.request.seed = bytes.byte() % start_seeds;
    return flip_case;
}

properties::FlipCase decode_script(Input input) {
    Bytes bytes = Bytes::after_version(input);
    properties::FlipCase flip_case = decode_start(bytes);
    flip_case.picks.reserve(most_flips);
    while (!bytes.empty() && flip_case.picks.size() < most_flips) {
        flip_case.picks.push_back(bytes.pair());
    }
    return flip_case;
}

const properties::Triangulation& start_of(const properties::FlipCase& flip_case) {
    const auto& [vertices, genus, seed] = flip_case.request;
    using Key = std::tuple<std::string_view, kernel::Index, kernel::Index, std::uint64_t>;
    static std::map<Key, properties::Triangulation> made;
    const Key key{flip_case.kind->name, vertices, genus, seed};
    const auto found = made.find(key);
    return found != made.end() ? found->second : made.emplace(key, flip_case.start()).first->second;
}

properties::FlipScript script_of(const properties::FlipCase& flip_case) {
    const auto edges = static_cast<std::uint32_t>(start_of(flip_case).edge_count());
    properties::FlipScript script;
    script.reserve(flip_case.picks.size());
    for (const std::uint32_t pick : flip_case.picks)
        script.push_back({static_cast<kernel::Index>(pick % edges)});
    return script;
}

InputBytes script_input(const StartBytes& start, std::span<const std::uint32_t> picks) {
    const properties::StartKind* kind = properties::find_start_kind(start.kind);
    if (kind == nullptr) {
        throw std::invalid_argument("no kind of start is called '" + std::string(start.kind) + "'");
    }
    const auto number = static_cast<std::uint8_t>(kind - start_kinds().data());
    InputBytes input{format_version, number, start.spare, start.genus, start.seed};
    for (const std::uint32_t pick : picks)
        append_pair(input, pick);
    return input;
}

InputBytes script_input(const StartBytes& start, std::initializer_list<std::uint32_t> picks) {
    return script_input(start, std::span(picks.begin(), picks.size()));
}

}  // namespace tightflip::fuzz
