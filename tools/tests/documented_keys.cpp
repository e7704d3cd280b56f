#include "documented_keys.hpp"

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::tools {
namespace {

using Json = nlohmann::json;

std::string page() {
    std::ifstream in(TIGHTFLIP_FORMATS_PAGE);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// The words in code type: `file`, but not `holds or violated`.
std::set<std::string> code_words(const std::string& text) {
    static const std::regex word("`([a-z_0-9]+)`");
    std::set<std::string> words;
    for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
        words.insert((*it)[1]);
    }
    return words;
}

/// The cells of "| a | b |"; empty for any other line.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    if (!line.starts_with("| ")) return cells;
    for (std::size_t begin = 2, end = 0; (end = line.find(" |", begin)) != std::string::npos;
         begin = end + 3) {
        cells.push_back(line.substr(begin, end - begin));
    }
    return cells;
}

/// "`check`:", a blank line and a table of keys and meanings.
void read_table(std::vector<std::string>::const_iterator line,
                std::vector<std::string>::const_iterator end, DocumentedKeys& keys) {
    for (; line != end && line->starts_with('|'); ++line) {
        const auto cells = cells_of(*line);
        if (cells.size() != 2) continue;
        const bool only = cells[1].find("only on") != std::string::npos;
        for (const std::string& key : code_words(cells[0])) {
            (only ? keys.sometimes : keys.always).insert(key);
            keys.inner[key] = code_words(cells[1]);
        }
    }
}

/// "`flip`: `file`, `flips`, and `reason`, `output` where they apply." or the keys of another verb.
void read_sentence(const std::string& sentence, DocumentedKeys& keys) {
    static const std::regex others("the keys of `([a-z]+)` with");
    static const std::regex parenthesis("\\([^)]*\\)");
    std::smatch other;
    std::string text = std::regex_replace(sentence, parenthesis, "");
    if (std::regex_search(text, other, others)) {
        keys = documented_keys(other[1]);
        text = other.suffix();
    }
    const bool has_sometimes = text.find("where they apply") != std::string::npos;
    const std::size_t split = has_sometimes ? text.find(" and ") : text.size();
    keys.always.merge(code_words(text.substr(0, split)));
    keys.sometimes.merge(code_words(text.substr(split)));
}

std::set<std::string> keys_of(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items())
        keys.insert(key);
    return keys;
}

/// Objects directly under a key: the value itself, or the elements of an array.
std::vector<Json> objects_in(const Json& value) {
    std::vector<Json> objects;
    if (value.is_object()) objects.push_back(value);
    for (const Json& element : value.is_array() ? value : Json::array()) {
        if (element.is_object()) objects.push_back(element);
    }
    return objects;
}

}  // namespace

DocumentedKeys documented_keys(const std::string& heading) {
    const std::vector<std::string> lines = lines_of(page());
    const std::string mark = "`" + heading + "`:";
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        if (!line->starts_with(mark)) continue;
        DocumentedKeys keys;
        if (*line == mark) {
            read_table(line + 2, lines.end(), keys);
        } else {
            std::string sentence = line->substr(mark.size());
            while (!sentence.ends_with('.'))
                sentence += " " + *++line;
            read_sentence(sentence, keys);
        }
        return keys;
    }
    throw std::runtime_error("the page has no keys of " + heading);
}

void expect_as_documented(const std::string& heading, const Json& object) {
    const DocumentedKeys documented = documented_keys(heading);
    const std::set<std::string> present = keys_of(object);
    for (const std::string& key : documented.always) {
        EXPECT_TRUE(present.contains(key)) << key << " is missing in " << object;
    }
    for (const std::string& key : present) {
        EXPECT_TRUE(documented.always.contains(key) || documented.sometimes.contains(key))
            << "the page does not know " << key << " of " << heading;
        const auto inner = documented.inner.find(key);
        if (inner == documented.inner.end()) continue;
        for (const Json& part : objects_in(object[key])) {
            EXPECT_EQ(keys_of(part), inner->second) << key << " of " << heading;
        }
    }
}

std::vector<DocumentedCode> documented_codes() {
    std::vector<DocumentedCode> codes;
    for (const std::string& line : lines_of(page())) {
        const auto cells = cells_of(line);
        if (cells.size() != 3 || !std::isdigit(static_cast<unsigned char>(cells[0].front()))) {
            continue;
        }
        codes.push_back({std::stoi(cells[0]), cells[1].substr(1, cells[1].size() - 2), cells[2]});
    }
    return codes;
}

}  // namespace tightflip::tools
