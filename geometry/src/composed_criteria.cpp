#include <tightflip/geometry/composed_criteria.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace tightflip::geometry {
namespace {

template <class Parts>
void append_affected_of(const Parts& parts, Edge e, std::vector<Edge>& edges) {
    for (const auto& part : parts)
        part.criterion->append_affected(e, edges);
}

class WeightedSum final : public Criterion {
public:
    explicit WeightedSum(std::vector<WeightedCriterion> terms) : terms_(std::move(terms)) {}

    [[nodiscard]] std::size_t level_count() const override {
        std::size_t count = 1;
        for (const auto& term : terms_)
            count = std::max(count, term.criterion->level_count());
        return count;
    }
    [[nodiscard]] Energy value() const override {
        Energy sum;
        for (const auto& [weight, criterion] : terms_)
            sum += weight * criterion->value();
        return sum;
    }
    [[nodiscard]] Energy change(Edge e) override {
        Energy sum;
        for (const auto& [weight, criterion] : terms_) {
            const Energy change = criterion->change(e);
            if (change.is_forbidden()) return change;
            sum += weight * change;
        }
        return sum;
    }
    void flipped(Edge e) override {
        for (const auto& term : terms_)
            term.criterion->flipped(e);
    }
    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        append_affected_of(terms_, e, edges);
    }

private:
    std::vector<WeightedCriterion> terms_;
};

class Lexicographic final : public Criterion {
public:
    explicit Lexicographic(std::vector<RankedCriterion> ranks) : ranks_(std::move(ranks)) {
        if (ranks_.empty() || level_count() > Energy::max_levels) {
            throw std::invalid_argument("an order of criteria has 1 to " +
                                        std::to_string(Energy::max_levels) + " levels, not " +
                                        std::to_string(level_count()));
        }
    }

    [[nodiscard]] std::size_t level_count() const override {
        std::size_t count = 0;
        for (const RankedCriterion& rank : ranks_)
            count += rank.criterion->level_count();
        return count;
    }
    [[nodiscard]] Energy value() const override {
        Energy energy;
        std::size_t level = 0;
        for (const RankedCriterion& rank : ranks_) {
            const Energy value = rank.criterion->value();
            for (std::size_t i = 0; i < rank.criterion->level_count(); ++i)
                energy.levels[level++] = value.levels[i];
        }
        return energy;
    }
    [[nodiscard]] Energy change(Edge e) override {
        Energy energy;
        std::size_t level = 0;
        for (const RankedCriterion& rank : ranks_) {
            const Energy change = rank.criterion->change(e);
            if (change.is_forbidden()) return change;
            for (std::size_t i = 0; i < rank.criterion->level_count(); ++i) {
                const bool counts = std::abs(change.levels[i]) > rank.tolerance;
                energy.levels[level++] = counts ? change.levels[i] : 0;
            }
        }
        return energy;
    }
    void flipped(Edge e) override {
        for (const RankedCriterion& rank : ranks_)
            rank.criterion->flipped(e);
    }
    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        append_affected_of(ranks_, e, edges);
    }

private:
    std::vector<RankedCriterion> ranks_;
};

/// The text of an expression, from the front on.
class Expression {
public:
    explicit Expression(std::string_view text) : text_(text) {}

    bool take(char symbol) {
        skip_blanks();
        if (at_ == text_.size() || text_[at_] != symbol) return false;
        ++at_;
        return true;
    }
    [[nodiscard]] bool is_at_end() {
        skip_blanks();
        return at_ == text_.size();
    }
    /// A number, if one stands here.
    std::optional<double> number() {
        skip_blanks();
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc{}) return std::nullopt;
        if (!std::isfinite(value)) fail("a weight is a finite number");
        at_ += static_cast<std::size_t>(end - begin);
        return value;
    }
    CriterionKind criterion() {
        skip_blanks();
        const std::size_t end =
            std::min(text_.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at_), text_.size());
        const auto kind = criterion_by_name(text_.substr(at_, end - at_));
        if (!kind) {
            std::string names;
            for (const CriterionInfo& info : all_criteria())
                names += (names.empty() ? "" : ", ") + std::string(info.name);
            fail("a criterion is expected: one of " + names);
        }
        at_ = end;
        return *kind;
    }
    [[noreturn]] void fail(const std::string& reason) const {
        throw std::invalid_argument("criterion '" + std::string(text_) + "', character " +
                                    std::to_string(at_ + 1) + ": " + reason);
    }

private:
    void skip_blanks() { at_ = std::min(text_.find_first_not_of(' ', at_), text_.size()); }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<Criterion> weighted_sum(std::vector<WeightedCriterion> terms) {
    return std::make_unique<WeightedSum>(std::move(terms));
}

std::unique_ptr<Criterion> lexicographic(std::vector<RankedCriterion> ranks) {
    return std::make_unique<Lexicographic>(std::move(ranks));
}

std::unique_ptr<Criterion> parse_criterion(std::string_view text, const SurfaceView& surface,
                                           Vertex marked, double tolerance) {
    Expression expression(text);
    const auto parse_sum = [&] {
        std::vector<WeightedCriterion> terms;
        do {
            const auto weight = expression.number();
            if (weight && !expression.take('*')) expression.fail("'*' is expected after a weight");
            terms.push_back({weight.value_or(1), nullptr});
            terms.back().criterion = make_criterion(expression.criterion(), surface, marked);
        } while (expression.take('+'));
        if (terms.size() == 1 && terms.front().weight == 1) {
            return std::move(terms.front().criterion);
        }
        return weighted_sum(std::move(terms));
    };
    std::vector<RankedCriterion> ranks;
    do {
        ranks.push_back({parse_sum(), tolerance});
    } while (expression.take(','));
    if (!expression.is_at_end()) expression.fail("'+', ',' or the end is expected");
    if (ranks.size() == 1) return std::move(ranks.front().criterion);
    ranks.back().tolerance = 0;
    return lexicographic(std::move(ranks));
}

}  // namespace tightflip::geometry
