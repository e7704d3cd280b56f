#include <tightflip/properties/finding.hpp>

namespace tightflip::properties {

std::string describe(const Finding& finding) {
    const Violation& v = finding.violation;
    return "after flip " + std::to_string(finding.step) + ": " +
           std::to_string(static_cast<int>(v.code)) + " " + std::string(name(v.code)) + ", " +
           where(v) + ": " + message(v);
}

}  // namespace tightflip::properties
