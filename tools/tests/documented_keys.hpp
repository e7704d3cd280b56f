/// \file
/// The keys that docs/formats.md promises, read from the page itself.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace tightflip::tools {

/// What the page says of one verb's object.
struct DocumentedKeys {
    std::set<std::string> always;
    std::set<std::string> sometimes;  ///< "only on ..." or "where they apply"
    /// Of each key the words in code type in its meaning: its own keys where it is an object.
    std::map<std::string, std::set<std::string>> inner;
};

/// The keys of `heading`, e.g. "check" or "info FILE".
[[nodiscard]] DocumentedKeys documented_keys(const std::string& heading);

/// Fails the test where the object lacks a key that is always there, or has one that the page does
/// not know; likewise one level further down.
void expect_as_documented(const std::string& heading, const nlohmann::json& object);

/// The rows of the page's table of violation codes: number, name, meaning.
struct DocumentedCode {
    int code = 0;
    std::string name;
    std::string meaning;

    friend bool operator==(const DocumentedCode&, const DocumentedCode&) = default;
};
[[nodiscard]] std::vector<DocumentedCode> documented_codes();

}  // namespace tightflip::tools
