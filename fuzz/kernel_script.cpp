#include "kernel_script.hpp"

#include "script_input.hpp"
#include "small_classes.hpp"
#include <tightflip/kernel/audit.hpp>

#include <algorithm>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using properties::KernelFinding;

InputBytes kernel_script_input(const StartBytes& start, bool laws,
                               std::span<const std::uint32_t> picks) {
    InputBytes bytes = script_input(start, picks);
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(script_layout.head), laws ? 1 : 0);
    return bytes;
}

/// The start of a case as findings name it: its kind and size.
std::string start_name(const properties::FlipCase& flip_case, const kernel::Triangulation& start) {
    std::string text =
        std::string(flip_case.kind->name) + " V=" + std::to_string(start.vertex_count());
    if (start.genus() > 0) text += " genus " + std::to_string(start.genus());
    return text;
}

}  // namespace

KernelScript decode_kernel_script(Input input) {
    Bytes bytes = Bytes::after_version(
        input.first(std::min(input.size(), kernel_script_layout.most_bytes())));
    KernelScript script;
    script.flips = decode_start(bytes);
    script.laws = bytes.byte() % 2 == 1;
    while (!bytes.empty())
        script.flips.picks.push_back(bytes.pair());
    return script;
}

std::string kernel_objection(const KernelScript& script, std::span<const JudgedKernel> kernels) {
    const kernel::FlipLog log = script.flips.log();
    const bool is_simple = audit(log.start).is_simple().value();
    for (const auto& [kernel, known] : kernels) {
        if (!kernel.can_start(is_simple)) continue;
        for (KernelFinding& finding :
             run_script(kernel, log.start, log.flips, script.laws).findings) {
            if (std::ranges::find(known, finding.code) != known.end()) continue;
            finding.start = start_name(script.flips, log.start);
            return std::string(name(finding.code)) + ": " + kernel.name + ", judged as " +
                   std::string(name(kernel.allowed)) + ": " + describe(finding);
        }
    }
    return {};
}

void show_kernel_script(std::ostream& out, Input input) {
    const KernelScript script = decode_kernel_script(input);
    out << describe(script.flips) << (script.laws ? "; each flip undone and redone" : "") << '\n';
    properties::write_in_words(out, script.flips.log());
}

std::vector<Seed> kernel_script_seeds() {
    const std::vector<std::uint32_t> picks{0, 3, 7, 4, 12, 5, 9, 1};
    std::vector<Seed> seeds;
    for (const bool laws : {false, true}) {
        const std::string suffix = laws ? "_laws" : "";
        for (const properties::StartKind& kind : properties::start_kinds()) {
            seeds.push_back({std::string(kind.name) + suffix,
                             kernel_script_input({kind.name, 3, 1, 2}, laws, picks)});
        }
        // Of a tetrahedron's scripts of two flips those that begin with edge 3: the others are the
        // same by symmetry.
        for (std::uint32_t second = 0; second < 6; ++second) {
            seeds.push_back({"tetrahedron_3_" + std::to_string(second) + suffix,
                             kernel_script_input({"tetrahedron"}, laws,
                                                 std::vector<std::uint32_t>{3, second})});
        }
        for (const SmallClass& one : small_classes()) {
            seeds.push_back({one.name + suffix, kernel_script_input(one.start, laws, one.flips)});
        }
    }
    return seeds;
}

}  // namespace tightflip::fuzz
