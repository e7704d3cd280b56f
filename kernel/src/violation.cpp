#include <tightflip/kernel/violation.hpp>

#include <algorithm>
#include <array>

namespace tightflip::kernel {
namespace {

struct Entry {
    ViolationCode code;
    std::string_view name;
    std::string_view description;
    std::string_view instance;  ///< {place} {found} {expected} {witness} are filled in
};

using enum ViolationCode;

constexpr std::array entries{
    Entry{no_faces, "no_faces", "the surface has no face", "there is no face"},
    Entry{corner_out_of_range, "corner_out_of_range", "a corner names a vertex that does not exist",
          "its corner is vertex {found}, but vertices run from 0 to {expected} - 1"},
    Entry{gluing_out_of_range, "gluing_out_of_range",
          "a side is glued to a side that does not exist",
          "it is glued to side {found}, but sides run from 0 to {expected} - 1"},
    Entry{more_vertices_than_corners, "more_vertices_than_corners",
          "more vertices are declared than there are corners of faces",
          "{found} vertices are declared, but the faces have only {expected} corners"},
    Entry{halfedge_count_odd, "halfedge_count_odd", "halfedges do not come in pairs",
          "there are {found} halfedges, an odd number"},
    Entry{next_out_of_range, "next_out_of_range", "next names a halfedge that does not exist",
          "its next is {found}, but halfedges run from 0 to {expected} - 1"},
    Entry{next_cycle_not_triangle, "next_cycle_not_triangle",
          "following next three times does not come back: the face is no triangle",
          "following next three times leads to halfedge {found}"},
    Entry{origin_out_of_range, "origin_out_of_range",
          "a halfedge leaves a vertex that does not exist",
          "its origin is vertex {found}, but vertices run from 0 to {expected} - 1"},
    Entry{side_glued_to_itself, "side_glued_to_itself", "a side is glued to itself",
          "it is glued to itself"},
    Entry{gluing_not_involution, "gluing_not_involution",
          "a side is glued to one that is not glued back to it",
          "it is glued to side {found}, which does not point back"},
    Entry{side_unglued, "side_unglued", "a side has no neighbour: the surface has a boundary",
          "no face lies behind it"},
    Entry{edge_in_more_than_two_faces, "edge_in_more_than_two_faces",
          "more than two sides join the same two vertices, so a face list cannot say which are "
          "glued (witness: the faces)",
          "{found} sides join the same two vertices (faces {witness}): the face list does not say "
          "which are glued; give the gluing"},
    Entry{directed_edge_repeats, "directed_edge_repeats",
          "two faces of a list run along the same two vertices in the same direction (witness: the "
          "vertices)",
          "face {found} too runs from vertex to vertex {witness}: their orientations differ, or "
          "there are parallel edges"},
    Entry{labels_disagree, "labels_disagree", "two glued sides join different vertices",
          "it is glued to side {found}, which joins other vertices"},
    Entry{coherence_bit_contradicts_labels, "coherence_bit_contradicts_labels",
          "the stored direction of a glued side contradicts its corner labels",
          "its stored direction against side {found} contradicts the corner labels"},
    Entry{corners_not_distinct, "corners_not_distinct",
          "a face meets a vertex twice: an edge is a loop (witness: the corners)",
          "its corners {witness} are not distinct"},
    Entry{three_neighbour_rule_broken, "three_neighbour_rule_broken",
          "the three neighbours of a face coincide, or it is its own neighbour (Definition 4.1; "
          "witness: the neighbours)",
          "its three neighbours are the faces {witness}"},
    Entry{vertex_unused, "vertex_unused", "a vertex belongs to no face", "no face uses it"},
    Entry{vertex_with_several_fans, "vertex_with_several_fans",
          "the faces about a vertex form several fans: the surface is not a manifold there",
          "its faces form {found} separate fans"},
    Entry{vertices_not_connected, "vertices_not_connected",
          "the surface falls into parts that share no vertex (witness: faces in each part)",
          "it falls into {found} parts that share no vertex, with {witness} faces"},
    Entry{faces_not_strongly_connected, "faces_not_strongly_connected",
          "not all faces are joined by chains across sides (witness: faces in each component)",
          "chains of faces across sides reach {found} separate components, with {witness} faces"},
    Entry{not_orientable, "not_orientable",
          "the faces cannot be oriented coherently (witness: a cycle of faces that reverses "
          "orientation)",
          "going once round the faces {witness} reverses the orientation"},
    Entry{vertex_count_changed, "vertex_count_changed", "the number of vertices is not the start's",
          "there are {found} vertices, at the start {expected}"},
    Entry{edge_count_changed, "edge_count_changed", "the number of edges is not the start's",
          "there are {found} edges, at the start {expected}"},
    Entry{face_count_changed, "face_count_changed", "the number of faces is not the start's",
          "there are {found} faces, at the start {expected}"},
    Entry{component_count_changed, "component_count_changed",
          "the number of components is not the start's",
          "there are {found} components, at the start {expected}"},
    Entry{euler_characteristic_changed, "euler_characteristic_changed",
          "the Euler characteristic is not the start's",
          "the Euler characteristic is {found}, at the start {expected}"},
    Entry{orientability_changed, "orientability_changed",
          "an orientable surface became non-orientable or the reverse",
          "orientable is {found}, at the start {expected}"},
    Entry{genus_changed, "genus_changed", "the genus is not the start's",
          "the genus is {found}, at the start {expected}"},
    Entry{refusal_unjustified, "refusal_unjustified",
          "a flip was refused although the two opposite corners differ",
          "its flip was refused although the opposite corners {found} and {expected} differ"},
    Entry{flip_not_as_defined, "flip_not_as_defined",
          "after a flip the two faces at the edge are not the ones that its definition names "
          "(witness: their six corners)",
          "after its flip the two faces there have the corners {witness}"},
    Entry{reference_model_disagrees, "reference_model_disagrees",
          "the reference model, flipped alike, is another surface",
          "the reference model, flipped alike, differs there"},
    Entry{
        flip_law_broken, "flip_law_broken",
        "unflip does not undo flip, or four flips of one edge are not the identity, or two do not "
        "exchange its halves",
        "flips and unflips there do not compose as they must"},
    Entry{log_not_reproduced, "log_not_reproduced",
          "a log or surface written down and read back is not the one that was written",
          "what was written and read back is not the same"},
    Entry{path_does_not_connect, "path_does_not_connect",
          "a flip path between two surfaces is missing, does not end in the second, or is longer "
          "than its bound",
          "its path of {found} flips, {expected} at most, does not lead to the other end"},
};

const Entry& entry(ViolationCode code) noexcept {
    const auto* const found = std::ranges::find(entries, code, &Entry::code);
    return found != entries.end() ? *found : entries.front();
}

std::string listed(const std::vector<Index>& witness) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(witness.size(), most); ++i) {
        text += (i == 0 ? "" : ", ") + std::to_string(witness[i]);
    }
    if (witness.size() > most) text += ", ... (" + std::to_string(witness.size()) + " in all)";
    return text;
}

void fill_in(std::string& text, std::string_view field, const std::string& value) {
    if (const auto at = text.find(field); at != std::string::npos) {
        text.replace(at, field.size(), value);
    }
}

}  // namespace

std::string_view name(ViolationCode code) noexcept {
    return entry(code).name;
}

std::string_view describe(ViolationCode code) noexcept {
    return entry(code).description;
}

std::vector<ViolationCode> all_violation_codes() {
    std::vector<ViolationCode> codes;
    codes.reserve(entries.size());
    for (const Entry& e : entries)
        codes.push_back(e.code);
    return codes;
}

std::string where(const Violation& violation) {
    const std::string place = std::to_string(violation.place);
    switch (violation.kind) {
        case PlaceKind::surface:
            return "surface";
        case PlaceKind::face:
            return "face " + place;
        case PlaceKind::side:
            return "face " + std::to_string(violation.place / 3) + ", side " +
                   std::to_string(violation.place % 3);
        case PlaceKind::vertex:
            return "vertex " + place;
        case PlaceKind::halfedge:
            return "halfedge " + place;
        case PlaceKind::edge:
            return "edge " + place;
    }
    return "surface";
}

std::string message(const Violation& violation) {
    std::string text(entry(violation.code).instance);
    fill_in(text, "{found}", std::to_string(violation.found));
    fill_in(text, "{expected}", std::to_string(violation.expected));
    fill_in(text, "{witness}", listed(violation.witness));
    return text;
}

}  // namespace tightflip::kernel
