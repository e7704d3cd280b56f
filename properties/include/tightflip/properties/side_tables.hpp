/// \file
/// What a mesh kernel says of its sides, as plain tables: read, judged and flipped by definition
/// without asking the kernel again.
#pragma once

#include <tightflip/properties/finding.hpp>
#include <tightflip/properties/mesh_kernel.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tightflip::properties {

/// Sides by number: the next of the same face, the one across, the vertex where it begins. An entry
/// is -1 where the kernel named a side that it never listed.
struct SideTables {
    Index vertex_count = 0;
    std::vector<Index> next;
    std::vector<Index> across;
    std::vector<Index> origin;

    [[nodiscard]] Index size() const noexcept { return static_cast<Index>(next.size()); }
    friend bool operator==(const SideTables&, const SideTables&) = default;
};

/// The tables of a surface; its halfedges are the sides.
[[nodiscard]] SideTables side_tables(const Triangulation& surface);

/// Tables as a gluing. Linear time.
struct SideReading {
    Gluing gluing;
    std::vector<Index> sides;  ///< the table's side at each side of the gluing
    std::string fault;         ///< why the tables are not even that; empty where they are
};
[[nodiscard]] SideReading read_as_gluing(const SideTables& tables);

/// What the audit says of tables, in the class that a kernel promises.
struct Judgement {
    std::string fault;  ///< the first thing wrong, in words; empty where all is well
    kernel::Topology topology;

    [[nodiscard]] bool is_valid() const noexcept { return fault.empty(); }
};
[[nodiscard]] Judgement judge(const SideTables& tables, KernelClass allowed);

/// The six sides of the two faces at an edge, those of the edge itself first: s, s1, s2, t, t1, t2.
/// Empty where both belong to one face, and a flip is not defined.
[[nodiscard]] std::optional<std::array<Index, 6>> sides_around(const SideTables& tables,
                                                               Index side);

/// The flip by its definition, whatever class the result belongs to. False and unchanged where both
/// sides of the edge belong to one face.
bool flip_by_definition(SideTables& tables, Index side);

/// The side of `b` for each side of `a`, when an isomorphism that keeps labels takes `from` to
/// `to`; it is found by walking. Linear time.
[[nodiscard]] std::optional<std::vector<Index>> isomorphism(const SideTables& a, Index from,
                                                            const SideTables& b, Index to);

}  // namespace tightflip::properties
