#include "reading.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using kernel::FileError;

constexpr std::string_view digits = "0123456789abcdef";

void put_hexadecimal(std::ostream& out, std::uint8_t byte) {
    out << digits[byte >> 4U] << digits[byte & 0xfU];
}

bool is_printable(std::uint8_t byte) {
    return byte >= ' ' && byte <= '~';
}

bool is_text(Input input) {
    return std::ranges::all_of(input, [](std::uint8_t byte) {
        return is_printable(byte) || byte == '\n' || byte == '\r' || byte == '\t';
    });
}

void show_lines(std::ostream& out, Input input) {
    for (const std::uint8_t byte : input) {
        if (byte == '\r') {
            out << "\\r";
        } else if (byte == '\t') {
            out << "\\t";
        } else if (byte == '\\') {
            out << "\\\\";
        } else {
            out << static_cast<char>(byte);
        }
    }
    if (!input.empty() && input.back() != '\n') out << "\\ (no line end)\n";
}

}  // namespace

std::string_view as_text(Input input) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): readers take chars
    return {reinterpret_cast<const char*>(input.data()), input.size()};
}

InputBytes as_bytes(std::string_view text) {
    InputBytes bytes;
    std::ranges::transform(text, std::back_inserter(bytes),
                           [](char c) { return static_cast<std::uint8_t>(c); });
    return bytes;
}

std::string objection_to_refusal(const FileError& error, std::string_view bytes,
                                 WholeFileReasons whole_file) {
    const std::string words = std::string(": ") + error.what();
    if (error.reason().empty()) return "refusals_have_a_reason" + words;
    if (error.unit() == FileError::Unit::none) {
        const bool is_about_all = std::ranges::any_of(
            whole_file, [&](std::string_view begin) { return error.reason().starts_with(begin); });
        return is_about_all ? std::string() : "refusals_have_a_place" + words;
    }
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(bytes, '\n')) + 1;
    const bool exists = error.unit() == FileError::Unit::line ? error.position() <= lines
                                                              : error.position() <= bytes.size();
    return exists ? std::string() : "refusals_name_a_place_that_exists" + words;
}

void show_bytes(std::ostream& out, Input input) {
    if (input.empty()) out << "no bytes\n";
    if (is_text(input)) {
        show_lines(out, input);
        return;
    }
    constexpr std::size_t row_size = 16;
    for (std::size_t start = 0; start < input.size(); start += row_size) {
        const Input row = input.subspan(start, std::min(row_size, input.size() - start));
        for (int shift = 24; shift >= 0; shift -= 8)
            put_hexadecimal(out, static_cast<std::uint8_t>(start >> static_cast<unsigned>(shift)));
        out << ' ';
        for (const std::uint8_t byte : row) {
            out << ' ';
            put_hexadecimal(out, byte);
        }
        out << std::string(3 * (row_size - row.size()) + 2, ' ');
        for (const std::uint8_t byte : row)
            out << (is_printable(byte) ? static_cast<char>(byte) : '.');
        out << '\n';
    }
}

}  // namespace tightflip::fuzz
