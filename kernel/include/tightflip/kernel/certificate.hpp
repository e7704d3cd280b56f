/// \file
/// Certificates: a flip log and the two labelled surfaces it is said to join.
///
/// A log that is to count as one is read with `parse_flip_log_as_written`. Verification trusts the
/// two ends, the log and the audit, and nothing else: it shares no code with the flip, with replay,
/// with the comparison of surface_equality.hpp or with whoever found the path.
#pragma once

#include <tightflip/kernel/flip_log.hpp>

#include <string>
#include <string_view>

namespace tightflip::kernel {

/// Why a certificate does not hold. Values are stable.
enum class CertificateFault : std::uint8_t {
    none = 0,
    from_is_no_surface = 1,    ///< the end it starts at does not pass the audit
    to_is_no_surface = 2,      ///< the end it should lead to does not
    ends_differ = 3,           ///< in vertices or genus, which no flip changes
    log_starts_elsewhere = 4,  ///< the log's start is another labelled surface
    no_such_edge = 5,          ///< a flip names an edge that the surface does not have
    flip_not_defined = 6,      ///< the corners opposite an edge coincide
    end_is_no_surface = 7,     ///< what the flips lead to does not pass the audit
    log_ends_elsewhere = 8,    ///< the flips lead to another labelled surface
};

/// The fault as one word, say "log_ends_elsewhere"; "none" where there is none.
[[nodiscard]] std::string_view name(CertificateFault fault) noexcept;

/// The answer of a verification.
struct CertificateVerdict {
    CertificateFault fault = CertificateFault::none;
    std::size_t flips_done = 0;  ///< flips that could be followed
    /// Empty where the certificate holds; else one line in plain words, which names the first bad
    /// flip (counted from 1) and its edge where there is one.
    std::string reason;

    [[nodiscard]] explicit operator bool() const noexcept {
        return fault == CertificateFault::none;
    }
};

/// Whether the log leads from one end to the other as oriented labelled surfaces, whatever the
/// numbers of their halfedges. All three tables are raw data and may say anything.
///
/// Linear time; where surfaces differ though the degrees of their vertices agree, at worst times
/// the least degree. Memory: about 45 bytes a halfedge.
[[nodiscard]] CertificateVerdict verify(const TableView& from, const TableView& to,
                                        const FlipLogView& log);

}  // namespace tightflip::kernel
