/// \file
/// A sum of angles as a product of complex numbers, for one arc tangent instead of one each.
#pragma once

#include <cmath>
#include <numbers>

namespace tightflip::geometry {

/// Adds up angles in 0 .. pi that are given by multiples of their sines and cosines.
class AngleSum {
public:
    void add(double sine, double cosine) noexcept {
        // What is that small is no angle that counts; zero keeps roundings off the half turn.
        if (sine < 1e-100 * std::abs(cosine)) sine = 0;
        const bool was_lower = is_lower();
        const double x = x_ * cosine - y_ * sine;
        const double y = x_ * sine + y_ * cosine;
        x_ = x;
        y_ = y;
        // The sum so far lies in [0, 2 pi) and grows by pi at most.
        if (was_lower && !is_lower()) full_turns_ += 1;
    }
    /// Not after numbers so large or small that their product left the range of doubles.
    [[nodiscard]] bool is_reliable() const noexcept {
        const double size = std::abs(x_) + std::abs(y_);
        return size > 1e-200 && size < 1e200;
    }
    [[nodiscard]] double total() const noexcept {
        const double angle = std::atan2(y_, x_);
        return angle +
               (is_lower() && angle < 0 ? full_turns_ + 1 : full_turns_) * 2 * std::numbers::pi;
    }

private:
    /// Whether the sum is in [pi, 2 pi), up to full turns.
    [[nodiscard]] bool is_lower() const noexcept { return y_ < 0 || (y_ == 0 && x_ < 0); }

    double x_ = 1;
    double y_ = 0;
    double full_turns_ = 0;
};

}  // namespace tightflip::geometry
