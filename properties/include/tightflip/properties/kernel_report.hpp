/// \file
/// What the conformance suite found out about a mesh kernel, and how it is told.
#pragma once

#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/finding.hpp>
#include <tightflip/properties/kernel_property.hpp>
#include <tightflip/properties/mesh_kernel.hpp>

#include <iosfwd>
#include <optional>

namespace tightflip::properties {

/// Something that a kernel does not keep, and how to see it again.
struct KernelFinding {
    KernelCode code{};
    std::string start;     ///< where it was seen: the start's kind and size
    std::size_t step = 0;  ///< flips attempted up to and including the one after which it showed
    std::string words;
    /// The edges asked about, by the numbers that they have in this library's kernel, which goes
    /// beside. Once the script has left its class, a number means the side that it meant last.
    FlipScript script;
    bool laws = false;  ///< each flip was taken back and repeated: four more in every step
    /// The start and all flips in order, the last one that which was asked about or done when it
    /// showed; edges refused before are left out. To replay, to print with `write_in_words`, and to
    /// run once more as a script. It ends early where the script leaves the class of this library's
    /// kernel. (After a planted fault: the start alone.)
    std::optional<kernel::FlipLog> log;
};

/// One line: code, name, start, step, words and script.
[[nodiscard]] std::string describe(const KernelFinding& finding);

/// What was found out about a kernel.
struct KernelReport {
    std::string kernel;
    KernelClass allowed = KernelClass::simple;
    std::vector<KernelFinding> findings;  ///< at most one of each code, by code; scripts shrunk
    Questions asked{};                    ///< by all scripts, without those of shrinking
    std::size_t planted = 0;              ///< faults planted and judged invalid by the audit

    /// Flips done, in all scripts, those of the laws included.
    [[nodiscard]] std::size_t flips() const noexcept;
    /// Whether anything put it to the test.
    [[nodiscard]] bool was_asked(KernelProperty property) const noexcept;
    /// Whether it was put to the test and nothing was found.
    [[nodiscard]] bool holds(KernelProperty property) const noexcept;
    [[nodiscard]] const KernelFinding* find(KernelCode code) const noexcept;
};

/// A Markdown table, kernel by property: holds, the codes of what was found, or not asked.
void write_markdown(std::ostream& out, std::span<const KernelReport> reports);

}  // namespace tightflip::properties
