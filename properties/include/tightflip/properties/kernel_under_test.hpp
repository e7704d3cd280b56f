/// \file
/// Any mesh kernel behind one interface, its sides numbered as it first listed them: the checks are
/// compiled once, and an adaptor costs its users a few seconds.
#pragma once

#include <tightflip/properties/side_tables.hpp>

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>

namespace tightflip::properties {

/// A small damage, done on purpose.
enum class PlantedFault : std::uint8_t { wrong_origin, wrong_next, wrong_across };

/// What the checks see of a kernel. Anything may throw.
class KernelUnderTest {
public:
    KernelUnderTest() = default;
    KernelUnderTest(const KernelUnderTest&) = delete;
    KernelUnderTest& operator=(const KernelUnderTest&) = delete;
    virtual ~KernelUnderTest() = default;

    [[nodiscard]] virtual std::array<Index, 3> counts() const = 0;
    /// How many sides it lists now.
    [[nodiscard]] virtual std::size_t side_count() const = 0;
    [[nodiscard]] virtual SideTables tables() const = 0;
    [[nodiscard]] virtual bool can_flip(Index side) const = 0;
    virtual void flip(Index side) = 0;
    [[nodiscard]] virtual bool is_valid() const = 0;
    /// Damages a side: its origin becomes the vertex, or its next or across the side, `wrong`.
    /// False where the kernel does not let itself be damaged so.
    virtual bool plant(PlantedFault fault, Index side, Index wrong) = 0;
};

/// A kernel's name and promises, and how to make one.
struct KernelDescription {
    std::string name;
    KernelClass allowed = KernelClass::simple;
    bool keeps_sides = true;
    bool takes_gluings = false;
    std::function<std::unique_ptr<KernelUnderTest>(const Gluing&)> make;

    /// Whether the kernel is asked for a surface: face lists are ambiguous where the graph is not
    /// simple.
    [[nodiscard]] bool can_start(bool graph_is_simple) const noexcept {
        return graph_is_simple || (takes_gluings && allowed != KernelClass::simple);
    }
};

namespace detail {

template <MeshKernel K>
class AdaptedKernel final : public KernelUnderTest {
public:
    explicit AdaptedKernel(const Gluing& gluing)
        : kernel_(made_from(gluing)), vertex_count_(gluing.vertex_count), sides_(kernel_.sides()) {
        for (std::size_t i = 0; i < sides_.size(); ++i)
            numbers_.emplace(sides_[i], static_cast<Index>(i));
        if (numbers_.size() != sides_.size()) throw std::logic_error("sides() lists a side twice");
    }

    [[nodiscard]] std::array<Index, 3> counts() const override { return kernel_.counts(); }
    [[nodiscard]] std::size_t side_count() const override {
        return std::vector<Side>(kernel_.sides()).size();
    }
    [[nodiscard]] SideTables tables() const override {
        SideTables tables{.vertex_count = vertex_count_, .next = {}, .across = {}, .origin = {}};
        for (const Side& side : sides_) {
            tables.next.push_back(number_of(kernel_.next(side)));
            tables.across.push_back(number_of(kernel_.across(side)));
            tables.origin.push_back(static_cast<Index>(kernel_.origin(side)));
        }
        return tables;
    }
    [[nodiscard]] bool can_flip(Index side) const override {
        return static_cast<bool>(kernel_.can_flip(at(side)));
    }
    void flip(Index side) override { kernel_.flip(at(side)); }
    [[nodiscard]] bool is_valid() const override { return kernel_.is_valid(); }
    bool plant(PlantedFault fault, Index side, Index wrong) override {
        const Side damaged = at(side);
        const auto takes = [&](PlantedFault offered, auto&& damage) {
            if (fault != offered) return false;
            damage();
            return true;
        };
        bool done = false;
        if constexpr (TakesWrongOrigins<K>) {
            done = done ||
                   takes(PlantedFault::wrong_origin, [&] { kernel_.set_origin(damaged, wrong); });
        }
        if constexpr (TakesWrongNexts<K>) {
            done = done ||
                   takes(PlantedFault::wrong_next, [&] { kernel_.set_next(damaged, at(wrong)); });
        }
        if constexpr (TakesWrongNeighbours<K>) {
            done = done || takes(PlantedFault::wrong_across,
                                 [&] { kernel_.set_across(damaged, at(wrong)); });
        }
        static_cast<void>(takes);
        return done;
    }

private:
    using Side = typename K::Side;

    static K made_from(const Gluing& gluing) {
        if constexpr (StartsFromGluings<K>) {
            return K(gluing);
        } else {
            std::vector<std::array<Index, 3>> faces;
            for (const kernel::GluedFace& face : gluing.faces)
                faces.push_back(face.corners);
            return K(gluing.vertex_count, std::span<const std::array<Index, 3>>(faces));
        }
    }
    [[nodiscard]] const Side& at(Index side) const {
        return sides_.at(static_cast<std::size_t>(side));
    }
    [[nodiscard]] Index number_of(const Side& side) const {
        const auto found = numbers_.find(side);
        return found == numbers_.end() ? -1 : found->second;
    }

    K kernel_;
    Index vertex_count_;
    std::vector<Side> sides_;
    std::map<Side, Index> numbers_;
};

}  // namespace detail

/// The description of an adaptor.
template <MeshKernel K>
[[nodiscard]] KernelDescription kernel_description() {
    return {.name = std::string(std::string_view(K::name)),
            .allowed = K::allowed,
            .keeps_sides = keeps_sides<K>(),
            .takes_gluings = StartsFromGluings<K>,
            .make = [](const Gluing& gluing) -> std::unique_ptr<KernelUnderTest> {
                return std::make_unique<detail::AdaptedKernel<K>>(gluing);
            }};
}

}  // namespace tightflip::properties
