#include "conformance.hpp"

#include "kernels.hpp"
#include "script_input.hpp"
#include "small_classes.hpp"
#include "targets.hpp"
#include <tightflip/kernel/audit.hpp>

#include <algorithm>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using properties::KernelClass;
using properties::KernelCode;
using properties::KernelFinding;

constexpr std::size_t most_conformance_flips = 24;
constexpr Layout layout{.head = 6, .record = 2, .most_records = most_conformance_flips};

/// Kernels made of face lists start where these are not ambiguous.
bool can_start(const properties::KernelDescription& kernel, bool is_simple) {
    return is_simple || (kernel.takes_gluings && kernel.allowed != KernelClass::simple);
}

InputBytes conformance_input(const StartBytes& start, bool laws,
                             std::span<const std::uint32_t> picks) {
    InputBytes bytes = script_input(start, picks);
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(script_layout.head), laws ? 1 : 0);
    return bytes;
}

std::vector<Seed> seeds() {
    const std::vector<std::uint32_t> picks{0, 3, 7, 4, 12, 5, 9, 1};
    std::vector<Seed> seeds;
    for (const bool laws : {false, true}) {
        const std::string suffix = laws ? "_laws" : "";
        for (const properties::StartKind& kind : properties::start_kinds()) {
            seeds.push_back({std::string(kind.name) + suffix,
                             conformance_input({kind.name, 3, 1, 2}, laws, picks)});
        }
        // Of a tetrahedron's scripts of two flips those that begin with edge 3: the others are the
        // same by symmetry.
        for (std::uint32_t second = 0; second < 6; ++second) {
            seeds.push_back(
                {"tetrahedron_3_" + std::to_string(second) + suffix,
                 conformance_input({"tetrahedron"}, laws, std::vector<std::uint32_t>{3, second})});
        }
        for (const SmallClass& one : small_classes()) {
            seeds.push_back({one.name + suffix, conformance_input(one.start, laws, one.flips)});
        }
    }
    return seeds;
}

}  // namespace

std::span<const JudgedKernel> judged_kernels() {
    using enum KernelCode;
    using namespace properties;
    static const std::vector<JudgedKernel> kernels{
        {our_kernel(), {}},
        {boost_graph_kernel(), {}},
        {cgal_surface_mesh(KernelClass::simple), {invalid_flip_allowed, invalid_accepted}},
        {cgal_surface_mesh(KernelClass::loopless),
         {invalid_flip_allowed, invalid_accepted, answers_differ_from_ours}},
        {cgal_surface_mesh(KernelClass::delta_complex), {invalid_flip_allowed}},
        {open_mesh(KernelClass::simple), {}},
        {open_mesh(KernelClass::loopless), {valid_flip_refused, answers_differ_from_ours}},
        {open_mesh(KernelClass::delta_complex), {valid_flip_refused}},
    };
    return kernels;
}

ConformanceCase decode_conformance(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    ConformanceCase script;
    script.flips = decode_start(bytes);
    script.laws = bytes.byte() % 2 == 1;
    while (!bytes.empty())
        script.flips.picks.push_back(bytes.pair());
    return script;
}

std::string conformance_objection(const ConformanceCase& script,
                                  std::span<const JudgedKernel> kernels) {
    const kernel::FlipLog log = script.flips.log();
    const bool is_simple = audit(log.start).is_simple().value();
    for (const auto& [kernel, known] : kernels) {
        if (!can_start(kernel, is_simple)) continue;
        for (const KernelFinding& finding :
             run_script(kernel, log.start, log.flips, script.laws).findings) {
            if (std::ranges::find(known, finding.code) != known.end()) continue;
            return std::string(name(finding.code)) + ": " + kernel.name + ", judged as " +
                   std::string(name(kernel.allowed)) + ": " + describe(finding);
        }
    }
    return {};
}

const Target conformance_target{
    .name = "conformance",
    .description =
        "a flip script on this kernel, CGAL's and OpenMesh's: nothing breaks that "
        "docs/conformance.md does not list",
    .layout = layout,
    .objection =
        [](Input input) {
            return conformance_objection(decode_conformance(input), judged_kernels());
        },
    .show =
        [](std::ostream& out, Input input) {
            const ConformanceCase script = decode_conformance(input);
            out << describe(script.flips) << (script.laws ? "; each flip undone and redone" : "")
                << '\n';
            properties::write_in_words(out, script.flips.log());
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
