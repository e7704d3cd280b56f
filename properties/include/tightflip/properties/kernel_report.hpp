/// \file
/// What the conformance suite found out about a mesh kernel, and how it is told.
#pragma once

#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/finding.hpp>
#include <tightflip/properties/kernel_property.hpp>
#include <tightflip/properties/mesh_kernel.hpp>

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace tightflip::properties {

/// Something that a kernel does not keep, and how to see it again.
struct KernelFinding {
    KernelCode code{};
    std::string start;     ///< where it was seen: the start's kind and size
    std::size_t step = 0;  ///< flips attempted up to and including the one after which it showed
    std::string words;
    /// The script. Edge e stands for the kernel's side at which edge e of the start was listed
    /// first; where a kernel keeps its sides that is edge e for ever.
    FlipScript script;
    /// The start and the script as flips of this library's kernel, to replay and to print with
    /// `write_in_words`; it ends early where the script leaves the allowed class. (After a
    /// planted fault: the start alone.)
    std::optional<kernel::FlipLog> log;
};

/// One line: code, name, start, step and words.
[[nodiscard]] std::string describe(const KernelFinding& finding);

/// What was found out about a kernel.
struct KernelReport {
    std::string kernel;
    KernelClass allowed = KernelClass::simple;
    std::vector<KernelFinding> findings;  ///< at most one of each code, by code; scripts shrunk
    std::vector<KernelProperty> asked;    ///< properties that could be asked of this kernel
    std::size_t flips = 0;                ///< in all scripts, without those of shrinking
    std::size_t planted = 0;              ///< faults planted and judged invalid by the audit

    [[nodiscard]] bool was_asked(KernelProperty property) const noexcept;
    [[nodiscard]] bool holds(KernelProperty property) const noexcept;
    [[nodiscard]] const KernelFinding* find(KernelCode code) const noexcept;
};

/// Writes the log of a finding to a file named after the kernel and the code, and returns where.
/// Throws FileError where it cannot be written.
std::filesystem::path write_log(const std::filesystem::path& directory, const std::string& kernel,
                                const KernelFinding& finding);

/// A Markdown table, kernel by property: holds, the codes of what was found, or not asked.
void write_markdown(std::ostream& out, std::span<const KernelReport> reports);

}  // namespace tightflip::properties
