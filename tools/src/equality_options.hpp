/// \file
/// The options by which a person says when two surfaces are the same.
#pragma once

#include <tightflip/kernel/canonical_search.hpp>

#include <CLI/CLI.hpp>

namespace tightflip::tools {

struct EqualityOptions {
    bool labelled = false;
    bool mirror = false;

    void add(CLI::App& verb) {
        verb.add_flag("--labelled", labelled, "Vertices must keep their labels");
        verb.add_flag("--mirror", mirror, "A surface and its mirror image are the same");
    }

    [[nodiscard]] kernel::Equality equality() const noexcept {
        return {labelled ? kernel::Labels::kept : kernel::Labels::ignored,
                mirror ? kernel::Mirror::identified : kernel::Mirror::distinct};
    }
};

}  // namespace tightflip::tools
