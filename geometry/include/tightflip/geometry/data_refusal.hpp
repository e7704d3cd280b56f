/// \file
/// Why a set of points does not allow what is asked of it, as a value.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace tightflip::geometry {

using kernel::Index;

/// What is wrong with the data. The witness of a refusal holds the labels said here; what is not
/// named is -1.
enum class DataFault : std::uint8_t {
    none,
    too_few_points,          ///< no witness
    not_finite,              ///< the point with such a coordinate
    coincident_points,       ///< two points at one place
    collinear_points,        ///< all points lie on one line; no witness
    coplanar_points,         ///< all points lie in one plane; no witness
    interior_point,          ///< a point inside the convex hull, so the data are not convex
    shared_direction,        ///< two points on one ray from the centre
    centre_outside,          ///< the centre is not inside the convex hull; no witness
    too_few_sections,        ///< no witness
    contour_too_short,       ///< the section
    contour_not_horizontal,  ///< the section and a point at another height than its first
    contours_not_ascending,  ///< the section that is not higher than the one before it
    contour_not_simple,      ///< two points at which sides start that meet elsewhere than at ends
};

struct DataRefusal {
    DataFault fault = DataFault::none;
    std::array<Index, 2> witness{-1, -1};

    friend bool operator==(const DataRefusal&, const DataRefusal&) = default;
};

/// One line of plain words with the witness; empty where there is no fault.
[[nodiscard]] std::string message(const DataRefusal& refusal);

/// A result, or why there is none.
template <class T>
class Outcome {
public:
    Outcome(T result) : result_(std::move(result)) {}    // NOLINT(google-explicit-constructor)
    Outcome(DataRefusal refusal) : refusal_(refusal) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] explicit operator bool() const noexcept { return result_.has_value(); }
    [[nodiscard]] const DataRefusal& refusal() const noexcept { return refusal_; }
    /// The result; throws std::invalid_argument with the message where there is none.
    [[nodiscard]] const T& value() const& {
        require();
        return *result_;
    }
    [[nodiscard]] T&& value() && {
        require();
        return *std::move(result_);
    }

private:
    void require() const {
        if (!result_) throw std::invalid_argument(message(refusal_));
    }

    std::optional<T> result_;
    DataRefusal refusal_;
};

}  // namespace tightflip::geometry
