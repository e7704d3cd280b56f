/// \file
/// A stream whose locale and flags a writer of files must not heed.
#pragma once

#include <ios>
#include <locale>
#include <sstream>
#include <string>

namespace tightflip::kernel::testing {

/// Groups digits in pairs, as a locale may.
class PairedDigits : public std::numpunct<char> {
protected:
    [[nodiscard]] char do_thousands_sep() const override { return '.'; }
    [[nodiscard]] std::string do_grouping() const override { return "\2"; }
};

/// What `write` writes to a stream that groups digits, counts in hexadecimal with a base and a
/// plus sign, and pads what is written next.
template <class Write>
[[nodiscard]] std::string written_to_hostile_stream(Write&& write) {
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new PairedDigits));
    out << std::hex << std::showbase << std::uppercase << std::showpos;
    out.width(30);
    out.fill('*');
    write(out);
    return out.str();
}

}  // namespace tightflip::kernel::testing
