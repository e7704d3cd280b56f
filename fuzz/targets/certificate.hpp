/// \file
/// The target certificate: two ends and a log, honest or tampered with, and what is said of them.
#pragma once

#include "target.hpp"
#include <tightflip/kernel/certificate.hpp>

namespace tightflip::fuzz {

inline constexpr std::size_t most_certificate_steps = 24;

struct CertificateCase {
    kernel::RawTable from;
    kernel::RawTable to;
    kernel::RawFlipLog log;
};

/// The case that the bytes say: fuzz/README.md gives the layout.
[[nodiscard]] CertificateCase decode_certificate(Input input);

/// What `verify` should say, found out with the reference model and canonical codes.
[[nodiscard]] kernel::CertificateVerdict expected_verdict(const CertificateCase& certificate);

/// What does not hold of a case.
[[nodiscard]] std::string certificate_objection(const CertificateCase& certificate);

}  // namespace tightflip::fuzz
