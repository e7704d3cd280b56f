#include <tightflip/properties/shrink.hpp>

#include <algorithm>

namespace tightflip::properties {

FlipScript shrink(FlipScript script, const std::function<bool(std::span<const Edge>)>& fails,
                  std::size_t most_calls) {
    std::size_t calls = 0;
    const auto still_fails = [&](std::span<const Edge> candidate) {
        return calls++ < most_calls && fails(candidate);
    };

    std::size_t passing = 0;  // the longest prefix known not to fail, where failing persists
    std::size_t failing = script.size();
    while (failing - passing > 1) {
        const std::size_t middle = passing + (failing - passing) / 2;
        (still_fails(std::span(script).first(middle)) ? failing : passing) = middle;
    }
    script.resize(failing);

    for (std::size_t block = std::max<std::size_t>(script.size() / 2, 1); !script.empty();) {
        bool removed = false;
        for (std::size_t end = script.size(); end > 0;) {
            const std::size_t begin = end - std::min(block, end);
            FlipScript candidate(script.begin(),
                                 script.begin() + static_cast<std::ptrdiff_t>(begin));
            candidate.insert(candidate.end(), script.begin() + static_cast<std::ptrdiff_t>(end),
                             script.end());
            if (still_fails(candidate)) {
                script = std::move(candidate);
                removed = true;
            }
            end = begin;
        }
        if (block > 1) {
            block /= 2;
        } else if (!removed) {
            break;
        }
    }
    return script;
}

}  // namespace tightflip::properties
