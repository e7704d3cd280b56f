/// \file
/// How a search over labelled surfaces passes its frontier from level to level, and between the
/// processes that share it: the one place that a distributed engine has to replace.
#pragma once

#include <tightflip/kernel/label_words.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// The labellings met at one level, by class: a block of words each. A process reads any class's
/// block of the level that stands, and writes the blocks of the next level of its own classes.
///
/// Reading and writing blocks happens on several threads at once, never two on one written block.
class FrontierExchange {
public:
    FrontierExchange() = default;
    FrontierExchange(const FrontierExchange&) = delete;
    FrontierExchange& operator=(const FrontierExchange&) = delete;
    virtual ~FrontierExchange() = default;

    /// The classes whose blocks this process computes, in ascending order.
    [[nodiscard]] virtual std::span<const std::uint32_t> own_classes() const = 0;
    /// The block of a class in the level that stands, whoever owns it.
    [[nodiscard]] virtual std::span<const LabelWord> block(std::uint32_t state) const = 0;
    /// Where the next level's block of an own class is to be written; its content is arbitrary.
    [[nodiscard]] virtual std::span<LabelWord> next_block(std::uint32_t state) = 0;
    /// Makes the next level the one that stands, once every process has written its blocks; returns
    /// the sum of `found` over the processes.
    virtual std::uint64_t advance(std::uint64_t found) = 0;
};

/// One process that owns everything: two arrays that change places.
class LocalExchange final : public FrontierExchange {
public:
    LocalExchange(std::size_t classes, std::size_t words_per_class);

    [[nodiscard]] std::span<const std::uint32_t> own_classes() const override { return classes_; }
    [[nodiscard]] std::span<const LabelWord> block(std::uint32_t state) const override {
        return std::span(level_).subspan(state * words_per_class_, words_per_class_);
    }
    [[nodiscard]] std::span<LabelWord> next_block(std::uint32_t state) override {
        return std::span(next_).subspan(state * words_per_class_, words_per_class_);
    }
    std::uint64_t advance(std::uint64_t found) override;

private:
    std::size_t words_per_class_;
    std::vector<std::uint32_t> classes_;
    std::vector<LabelWord> level_;
    std::vector<LabelWord> next_;
};

}  // namespace tightflip::kernel
