#include "certificate.hpp"

#include "reading.hpp"
#include "renumbering.hpp"
#include "script_input.hpp"
#include "targets.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/quick_audit.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::CertificateFault;
using kernel::CertificateVerdict;
using kernel::Edge;
using kernel::Halfedge;
using kernel::Index;
using kernel::RawTable;
using kernel::Triangulation;

// ---- steps ----

/// A step's numbers: a table, a place in it, a value.
struct Step {
    std::uint32_t table, place, value;
};

RawTable& table_of(CertificateCase& certificate, const Step& step) {
    switch (step.table % 3) {
        case 0:
            return certificate.from;
        case 1:
            return certificate.to;
        default:
            return certificate.log.start;
    }
}

/// The record that a step names, or nullptr where the table has none.
kernel::HalfedgeRecord* record_of(CertificateCase& certificate, const Step& step) {
    RawTable& table = table_of(certificate, step);
    return table.records.empty() ? nullptr : &table.records[step.place % table.records.size()];
}

void flip_the_end(CertificateCase& certificate, Edge e) {
    RawTable& to = certificate.to;
    if (kernel::passes_audit(to.records, to.vertex_count)) {
        static_cast<void>(kernel::flip(to.records, e));
    }
}

Edge edge_of(const CertificateCase& certificate, const Step& step) {
    const auto edges = static_cast<std::uint32_t>(certificate.log.start.records.size() / 2);
    return {edges == 0 ? 0 : static_cast<Index>(step.place % edges)};
}

/// The end under other numbers of halfedges: the same labelled surface.
void renumber(CertificateCase& certificate, const Step& step) {
    RawTable& table = table_of(certificate, step);
    const kernel::BuildResult built = build(table.records, table.vertex_count);
    if (!built) return;
    kernel::RandomStream random(step.value);
    const Triangulation again = with_other_halfedges(built.value(), random);
    table.records.assign(again.table().begin(), again.table().end());
}

struct StepKind {
    std::string_view name;
    void (*apply)(CertificateCase&, const Step&);
};

/// In this order for ever: bytes name them by number.
constexpr std::array step_kinds{
    StepKind{"flip, on the end and in the log",
             [](CertificateCase& c, const Step& step) {
                 const Edge e = edge_of(c, step);
                 RawTable& to = c.to;
                 if (!kernel::passes_audit(to.records, to.vertex_count)) return;
                 if (static_cast<std::size_t>(e.id) >= to.records.size() / 2) return;
                 if (kernel::flip(to.records, e)) c.log.flips.push_back(e);
             }},
    StepKind{"flip in the log alone",
             [](CertificateCase& c, const Step& step) { c.log.flips.push_back(edge_of(c, step)); }},
    StepKind{"flip of the end alone",
             [](CertificateCase& c, const Step& step) {
                 const Edge e = edge_of(c, step);
                 if (static_cast<std::size_t>(e.id) < c.to.records.size() / 2) flip_the_end(c, e);
             }},
    StepKind{"flip left out of the log",
             [](CertificateCase& c, const Step& step) {
                 if (c.log.flips.empty()) return;
                 const std::size_t place = step.place % c.log.flips.size();
                 c.log.flips.erase(c.log.flips.begin() + static_cast<std::ptrdiff_t>(place));
             }},
    StepKind{"flip in the log changed to any number",
             [](CertificateCase& c, const Step& step) {
                 constexpr std::array far{Index{-1}, std::numeric_limits<Index>::min(),
                                          std::numeric_limits<Index>::max()};
                 if (c.log.flips.empty()) return;
                 const auto value = static_cast<Index>(step.value);
                 c.log.flips[step.place % c.log.flips.size()] = {
                     step.value < far.size() ? far[step.value] : value - Index{far.size()}};
             }},
    StepKind{"next changed",
             [](CertificateCase& c, const Step& step) {
                 if (auto* const record = record_of(c, step)) {
                     record->next = {static_cast<Index>(step.value) - 1};
                 }
             }},
    StepKind{"origin changed",
             [](CertificateCase& c, const Step& step) {
                 if (auto* const record = record_of(c, step)) {
                     record->origin = {static_cast<Index>(step.value) - 1};
                 }
             }},
    StepKind{"number of vertices changed",
             [](CertificateCase& c, const Step& step) {
                 table_of(c, step).vertex_count = static_cast<Index>(step.value) - 1;
             }},
    StepKind{"record cut off",
             [](CertificateCase& c, const Step& step) {
                 RawTable& table = table_of(c, step);
                 if (!table.records.empty()) table.records.pop_back();
             }},
    StepKind{"halfedges renumbered", renumber},
    StepKind{"two labels exchanged",
             [](CertificateCase& c, const Step& step) {
                 const auto a = static_cast<Index>(step.value % 16);
                 const auto b = static_cast<Index>(step.value / 16);
                 for (auto& record : table_of(c, step).records) {
                     const Index label = record.origin.id;
                     record.origin.id = label == a ? b : (label == b ? a : label);
                 }
             }},
    StepKind{"log begins at another table",
             [](CertificateCase& c, const Step& step) {
                 c.log.start = step.value % 2 == 0 ? c.from : c.to;
             }},
    StepKind{"ends exchanged", [](CertificateCase& c, const Step&) { std::swap(c.from, c.to); }},
    StepKind{"end replaced by a book",
             [](CertificateCase& c, const Step& step) {
                 const Triangulation book =
                     kernel::families::book(3 + static_cast<Index>(step.value % 8));
                 c.to = {.vertex_count = book.vertex_count(),
                         .records = {book.table().begin(), book.table().end()}};
             }},
    StepKind{"surface turned over",
             [](CertificateCase& c, const Step& step) {
                 RawTable& table = table_of(c, step);
                 const kernel::BuildResult built = build(table.records, table.vertex_count);
                 if (!built) return;
                 const Triangulation other = mirrored(built.value());
                 table.records.assign(other.table().begin(), other.table().end());
             }},
};

constexpr std::size_t step_size = 5;
constexpr Layout layout{.head = 5, .record = step_size, .most_records = most_certificate_steps};

struct DecodedStep {
    const StepKind* kind;
    Step step;
};

std::vector<DecodedStep> decode_steps(Bytes& bytes) {
    std::vector<DecodedStep> steps;
    while (!bytes.empty()) {
        const StepKind& kind = step_kinds[bytes.byte() % step_kinds.size()];
        const std::uint32_t table = bytes.byte();
        const std::uint32_t place = bytes.pair();
        steps.push_back({&kind, {table, place, bytes.byte()}});
    }
    return steps;
}

Bytes bytes_of(Input input) {
    return Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
}

// ---- what should be said ----

kernel::CanonicalCode labelled_code(const Triangulation& surface) {
    return canonical_code(surface, {kernel::Labels::kept, kernel::Mirror::distinct});
}

// ---- seeds ----

class SeedMaker {
public:
    explicit SeedMaker(const StartBytes& start) : bytes_(script_input(start)) {}
    SeedMaker& step(std::uint8_t kind, std::uint8_t table, std::uint32_t place,
                    std::uint8_t value) {
        bytes_.push_back(kind);
        bytes_.push_back(table);
        append_pair(bytes_, place);
        bytes_.push_back(value);
        return *this;
    }
    SeedMaker& honest_flips(std::uint32_t count) {
        for (std::uint32_t k = 0; k < count; ++k)
            step(0, 0, 7 * k, 0);
        return *this;
    }
    [[nodiscard]] const InputBytes& bytes() const { return bytes_; }

private:
    InputBytes bytes_;
};

std::vector<Seed> seeds() {
    std::vector<Seed> seeds;
    for (const properties::StartKind& kind : properties::start_kinds()) {
        const StartBytes start{kind.name, 2, 1, 3};
        const std::string name(kind.name);
        seeds.push_back({name + "_honest", SeedMaker(start).honest_flips(12).bytes()});
        seeds.push_back(
            {name + "_honest_renumbered",
             SeedMaker(start).honest_flips(9).step(9, 0, 0, 5).step(9, 1, 0, 6).bytes()});
    }
    const StartBytes start{"random", 3, 1, 2};
    for (std::size_t kind = 0; kind < step_kinds.size(); ++kind) {
        for (std::uint8_t table = 0; table < 3; ++table) {
            seeds.push_back({"tampered_" + std::to_string(kind) + "_table_" + std::to_string(table),
                             SeedMaker(start)
                                 .honest_flips(6)
                                 .step(static_cast<std::uint8_t>(kind), table, 5, 1)
                                 .bytes()});
        }
    }
    seeds.push_back({"refused_flip", SeedMaker({"book"}).step(1, 0, 0, 0).bytes()});
    for (const std::string_view kind : {"torus", "icosphere", "octasphere"}) {
        // All degrees are equal, so that only the faces tell.
        const std::string name = std::string(kind) + "_of_equal_degrees_";
        seeds.push_back(
            {name + "labels_exchanged", SeedMaker({kind}).step(10, 1, 0, 0x21).bytes()});
        seeds.push_back({name + "turned_over", SeedMaker({kind}).step(14, 1, 0, 0).bytes()});
    }
    seeds.push_back(
        {"flip_of_a_huge_edge", SeedMaker(start).honest_flips(3).step(4, 0, 1, 2).bytes()});
    return seeds;
}

}  // namespace

CertificateCase decode_certificate(Input input) {
    Bytes bytes = bytes_of(input);
    const Triangulation start = decode_start(bytes).start();
    const RawTable table{.vertex_count = start.vertex_count(),
                         .records = {start.table().begin(), start.table().end()}};
    CertificateCase certificate{table, table, {.start = table, .flips = {}}};
    for (const auto& [kind, step] : decode_steps(bytes))
        kind->apply(certificate, step);
    return certificate;
}

CertificateVerdict expected_verdict(const CertificateCase& certificate) {
    const auto built = [](const RawTable& table) {
        return build(table.records, table.vertex_count).triangulation;
    };
    const auto says = [](CertificateFault fault, std::size_t flips_done = 0) {
        return CertificateVerdict{fault, flips_done, {}};
    };
    const auto from = built(certificate.from);
    if (!from) return says(CertificateFault::from_is_no_surface);
    const auto to = built(certificate.to);
    if (!to) return says(CertificateFault::to_is_no_surface);
    if (from->vertex_count() != to->vertex_count() || from->genus() != to->genus()) {
        return says(CertificateFault::ends_differ);
    }
    const auto start = built(certificate.log.start);
    if (!start || labelled_code(*start) != labelled_code(*from)) {
        return says(CertificateFault::log_starts_elsewhere);
    }
    // The flips are the model's to judge; the surface they lead to is the replay's, for a model
    // does not say which side of it is outside.
    properties::ReferenceModel model(*start);
    const kernel::FlipLog log{*start, certificate.log.flips};
    const std::size_t all = log.flips.size();
    for (std::size_t k = 0; k < all; ++k) {
        const Edge e = log.flips[k];
        if (e.id < 0 || e.id >= start->edge_count()) return says(CertificateFault::no_such_edge, k);
        if (!model.flip(e)) return says(CertificateFault::flip_not_defined, k);
    }
    const Triangulation end = replay(log).surface;
    if (model.difference(end)) return says(CertificateFault::end_is_no_surface, all);
    return says(labelled_code(end) == labelled_code(*to) ? CertificateFault::none
                                                         : CertificateFault::log_ends_elsewhere,
                all);
}

std::string certificate_objection(const CertificateCase& certificate) {
    const CertificateVerdict expected = expected_verdict(certificate);
    const CertificateVerdict verdict = verify(certificate.from, certificate.to, certificate.log);
    const std::string words = std::string(name(verdict.fault)) + " (" + verdict.reason +
                              ") instead of " + std::string(name(expected.fault));
    if (verdict && !expected) return "false_certificates_are_refused: " + words;
    if (verdict.fault != expected.fault) return "verdicts_name_the_fault: " + words;
    if (verdict.flips_done != expected.flips_done) {
        return "verdicts_count_flips: " + std::to_string(verdict.flips_done) + " instead of " +
               std::to_string(expected.flips_done);
    }
    return verdict.reason.empty() == static_cast<bool>(verdict)
               ? std::string()
               : "refused_certificates_have_a_reason: " + words;
}

const Target certificate_target{
    .name = "certificate",
    .description =
        "two ends and a log, tampered with: the verdict is that of the reference model "
        "and canonical codes",
    .layout = layout,
    .objection = [](Input input) { return certificate_objection(decode_certificate(input)); },
    .show =
        [](std::ostream& out, Input input) {
            Bytes bytes = bytes_of(input);
            out << describe(decode_start(bytes)) << '\n';
            for (const auto& [kind, step] : decode_steps(bytes)) {
                out << kind->name << ": table " << step.table % 3 << ", place " << step.place
                    << ", value " << step.value << '\n';
            }
            const CertificateCase certificate = decode_certificate(input);
            const CertificateVerdict verdict =
                verify(certificate.from, certificate.to, certificate.log);
            out << name(verdict.fault) << ": " << verdict.reason << '\n';
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
