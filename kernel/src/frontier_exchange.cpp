#include <tightflip/kernel/frontier_exchange.hpp>

#include <numeric>

namespace tightflip::kernel {

LocalExchange::LocalExchange(std::size_t classes, std::size_t words_per_class)
    : words_per_class_(words_per_class),
      classes_(classes),
      level_(classes * words_per_class),
      next_(classes * words_per_class) {
    std::iota(classes_.begin(), classes_.end(), 0U);
}

std::uint64_t LocalExchange::advance(std::uint64_t found) {
    level_.swap(next_);
    return found;
}

}  // namespace tightflip::kernel
