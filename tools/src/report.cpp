#include "report.hpp"

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::AuditReport;
using kernel::Topology;
using kernel::Violation;

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// The definition of the paper that a valid surface satisfies.
std::string_view definition(const AuditReport& report) {
    return report.is_simple().value_or(false) ? "Definition 2.1 (simple graph)"
                                              : "Definition 4.1 (parallel edges)";
}

}  // namespace

Json to_json(const Violation& violation, const PlaceInWords& where) {
    return {{"code", static_cast<int>(violation.code)},
            {"name", name(violation.code)},
            {"where", where(violation)},
            {"message", message(violation)},
            {"witness", violation.witness}};
}

Json to_json(const AuditReport& report, const PlaceInWords& where) {
    const Topology& t = report.topology;
    Json json{{"valid", report.is_valid()},
              {"vertices", t.vertices},
              {"edges", t.edges},
              {"faces", t.faces},
              {"components", t.components},
              {"euler_characteristic", t.euler_characteristic},
              {"orientable", t.orientable},
              {"genus", or_null(t.genus)},
              {"simple", or_null(report.is_simple())},
              {"coherently_stored", report.coherently_stored}};
    for (const char* key : {"degrees", "parallel_edges"})
        json[key] = nullptr;
    if (!report.reached_top) {  // the tables name what does not exist; little can be said
        for (const char* key : {"components", "euler_characteristic", "orientable"}) {
            json[key] = nullptr;
        }
    }
    if (report.degrees) {
        json["degrees"] = {{"min", report.degrees->min},
                           {"max", report.degrees->max},
                           {"degree_two_vertices", report.degrees->degree_two_vertices}};
    }
    if (report.parallels) {
        json["parallel_edges"] = {{"loops", report.parallels->loops},
                                  {"pairs_joined_twice", report.parallels->pairs_joined_twice},
                                  {"max_multiplicity", report.parallels->max_multiplicity}};
    }
    json["violation_count"] = report.violation_count;
    json["violations"] = Json::array();
    for (const Violation& v : report.violations)
        json["violations"].push_back(to_json(v, where));
    return json;
}

std::string surface_in_words(const Topology& topology) {
    if (!topology.genus) return "no closed surface";
    const auto genus = *topology.genus;
    if (!topology.orientable) {
        if (genus == 1) return "a projective plane";
        if (genus == 2) return "a Klein bottle";
        return fmt::format("a non-orientable surface with {} cross-caps", genus);
    }
    if (genus == 0) return "a sphere";
    if (genus == 1) return "a torus";
    return fmt::format("an orientable surface of genus {}", genus);
}

std::string report_in_words(const AuditReport& report, const PlaceInWords& where) {
    const Topology& t = report.topology;
    std::string text;
    if (report.is_valid()) {
        text = fmt::format("valid: {}, {}", surface_in_words(t), definition(report));
    } else {
        text = fmt::format("not valid: {} violation{}", report.violation_count,
                           report.violation_count == 1 ? "" : "s");
    }
    text += fmt::format("\n  {} vertices, {} edges, {} faces", t.vertices, t.edges, t.faces);
    if (report.reached_top) {
        text += fmt::format("\n  {} component{}, Euler characteristic {}, {}", t.components,
                            t.components == 1 ? "" : "s", t.euler_characteristic,
                            t.orientable ? "orientable" : "not orientable");
        if (!report.coherently_stored) text += "\n  the faces are not stored in one orientation";
    }
    if (report.degrees) {
        text += fmt::format("\n  degrees {} to {}", report.degrees->min, report.degrees->max);
    }
    if (report.parallels && report.parallels->pairs_joined_twice > 0) {
        text +=
            fmt::format(", {} pairs of vertices joined by up to {} parallel edges",
                        report.parallels->pairs_joined_twice, report.parallels->max_multiplicity);
    }
    for (const Violation& v : report.violations) {
        text += fmt::format("\n  {} {}\n      {}: {}", static_cast<int>(v.code), name(v.code),
                            where(v), message(v));
    }
    const auto kept = static_cast<std::int64_t>(report.violations.size());
    if (kept < report.violation_count) {
        text += fmt::format("\n  ... and {} more", report.violation_count - kept);
    }
    return text;
}

}  // namespace tightflip::tools
