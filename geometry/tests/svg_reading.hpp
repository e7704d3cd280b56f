/// \file
/// Reads the SVG of drawings, so strictly that a text which is not well-formed is an error.
#pragma once

#include <cctype>
#include <charconv>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::geometry {

struct SvgElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;
    std::string group;  ///< the class of the group around it

    [[nodiscard]] std::string attribute(const std::string& key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? "" : found->second;
    }
};

/// Throws std::runtime_error where tags do not balance, an attribute has no quotes or comes twice,
/// or a mark stands by itself.
class SvgReader {
public:
    explicit SvgReader(std::string_view text) : text_(text) {}

    std::vector<SvgElement> read() {
        while (place_ < text_.size()) {
            if (text_[place_] == '<') {
                read_tag();
            } else {
                read_text();
            }
        }
        if (!open_.empty()) fail("an element is not closed");
        return elements_;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(what + " at byte " + std::to_string(place_));
    }
    bool take(std::string_view word) {
        if (!text_.substr(place_).starts_with(word)) return false;
        place_ += word.size();
        return true;
    }
    void skip_blanks() {
        while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])))
            ++place_;
    }
    std::string word() {
        const std::size_t from = place_;
        while (place_ < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[place_])) || text_[place_] == '-'))
            ++place_;
        if (place_ == from) fail("a name is missing");
        return std::string(text_.substr(from, place_ - from));
    }
    std::string up_to(char end) {
        std::string found;
        for (; place_ < text_.size() && text_[place_] != end; ++place_) {
            if (text_[place_] == '<') fail("a '<' by itself");
            if (text_[place_] == '&') check_reference();
            found += text_[place_];
        }
        return found;
    }
    void check_reference() const {
        for (const std::string_view reference : {"&amp;", "&lt;", "&gt;", "&quot;"}) {
            if (text_.substr(place_).starts_with(reference)) return;
        }
        fail("an '&' by itself");
    }
    void read_text() {
        const std::string found = up_to('<');
        const bool is_blank = found.find_first_not_of(" \n") == std::string::npos;
        if (is_blank) return;
        if (open_.empty()) fail("text outside of elements");
        elements_[open_.back()].text += found;
    }
    void read_tag() {
        if (take("</")) {
            if (open_.empty() || elements_[open_.back()].name != word() || !take(">")) {
                fail("an end tag without its start");
            }
            open_.pop_back();
            return;
        }
        place_ += 1;
        if (open_.empty() && !elements_.empty()) fail("a second root");
        SvgElement element;
        element.name = word();
        for (const std::size_t outer : open_) {
            if (elements_[outer].name != "g") continue;
            const std::string name = elements_[outer].attribute("class");
            if (!name.empty()) element.group = name;
        }
        for (skip_blanks(); !take(">"); skip_blanks()) {
            if (take("/>")) {
                elements_.push_back(element);
                return;
            }
            const std::string key = word();
            if (!take("=\"")) fail("an attribute without a value");
            if (!element.attributes.emplace(key, up_to('"')).second) fail("an attribute twice");
            take("\"");
        }
        open_.push_back(elements_.size());
        elements_.push_back(element);
    }

    std::string_view text_;
    std::size_t place_ = 0;
    std::vector<std::size_t> open_;
    std::vector<SvgElement> elements_;
};

/// All numbers in the data of a path or the like; throws where there is anything else but letters
/// of commands, and where a number is not finite.
inline std::vector<double> numbers_in(const std::string& data) {
    std::vector<double> numbers;
    const char* const end = data.data() + data.size();
    for (const char* c = data.data(); c != end;) {
        if (std::string_view(" MLHz").find(*c) != std::string_view::npos) {
            ++c;
            continue;
        }
        double value = 0;
        const auto [stopped, error] = std::from_chars(c, end, value, std::chars_format::fixed);
        if (error != std::errc{} || !(value > -1e9 && value < 1e9)) {
            throw std::runtime_error("no number in " + data);
        }
        numbers.push_back(value);
        c = stopped;
    }
    return numbers;
}

/// The strokes of a path: one for each M, as x, y, x, y, ...
inline std::vector<std::vector<double>> strokes_of(const std::string& data) {
    std::vector<std::vector<double>> strokes;
    for (std::size_t from = data.find('M'); from != std::string::npos;) {
        const std::size_t next = data.find('M', from + 1);
        strokes.push_back(numbers_in(data.substr(from, next - from)));
        from = next;
    }
    return strokes;
}

}  // namespace tightflip::geometry
