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
    /// Random scripts from each start; and as many again in which every flip is taken back and
    /// repeated.
    std::size_t scripts = 4;
    std::size_t flips = 40;  ///< attempted in each, without those repeated
    std::uint64_t seed = 1;
    /// Run every script in a child process, so that crashes, endless loops and calls of exit() are
    /// findings too. Without, they are the test's own; for debuggers.
    bool isolate = true;
    unsigned seconds = 2;  ///< for each script and each damage, where isolated
    /// Scripts that run out of time before no more are tried; and so with kinds of damage.
    std::size_t most_hangs = 3;
};

/// How far a script came, and what showed.
struct ScriptRun {
    std::vector<KernelFinding> findings;  ///< the first of each code
    Questions asked{};
    std::size_t step = 0;  ///< edges of the script asked about
    FlipScript flips;      ///< as in the log of a finding
    bool timed_out = false;
};
/// Runs one script, in this process, and watches every property. Stops after a flip with an invalid
/// result. With `laws`, every flip is also taken back and repeated: it is done five times.
[[nodiscard]] ScriptRun run_script(const KernelDescription& kernel, const Triangulation& start,
                                   std::span<const Edge> script, bool laws);

/// The whole suite: small starts first, every script of two flips from the smallest, random scripts
/// from all, planted damage; scripts that show something are shrunk. Deterministic for a seed.
/// Throws std::system_error where child processes are wanted and there can be none.
[[nodiscard]] KernelReport test_kernel(const KernelDescription& kernel,
                                       const ConformanceOptions& options = {});

}  // namespace tightflip::properties
