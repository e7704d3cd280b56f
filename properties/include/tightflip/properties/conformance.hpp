/// \file
/// The conformance suite: whether a mesh kernel does what it promises, found out by flipping it
/// along random scripts beside the definition, the audit and this library's own kernel.
///
/// \code
///     const KernelReport report = test_kernel(kernel_description<MyKernel>());
///     for (const KernelFinding& finding : report.findings) std::cout << describe(finding) << '\n';
/// \endcode
///
/// Needs no test library; `conformance_suite.hpp` makes GoogleTest cases of it.
#pragma once

#include <tightflip/properties/kernel_report.hpp>
#include <tightflip/properties/kernel_under_test.hpp>

#include <cstdint>

namespace tightflip::properties {

/// How much to try.
struct ConformanceOptions {
    std::size_t scripts = 4;  ///< random scripts from each start
    std::size_t flips = 40;   ///< attempted in each
    std::uint64_t seed = 1;
    /// Run every script in a child process, so that crashes and endless loops are findings too.
    bool isolate = true;
    unsigned seconds = 2;        ///< for each script, where isolated
    std::size_t most_hangs = 3;  ///< scripts that run out of time before no more are tried
};

/// Runs one script and watches every property; the first finding of each code. Stops after a flip
/// with an invalid result. With `laws`, every flip is also taken back and repeated.
struct ScriptRun {
    std::vector<KernelFinding> findings;
    bool timed_out = false;
};
[[nodiscard]] ScriptRun run_script(const KernelDescription& kernel, const Triangulation& start,
                                   std::span<const Edge> script, bool laws);

/// The whole suite: small starts first, every script of two flips from the smallest, random scripts
/// from all, planted damage; scripts that show something are shrunk. Deterministic for a seed.
[[nodiscard]] KernelReport test_kernel(const KernelDescription& kernel,
                                       const ConformanceOptions& options = {});

}  // namespace tightflip::properties
