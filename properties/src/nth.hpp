/// \file
/// Items by the kernel's signed numbers.
#pragma once

#include <tightflip/kernel/handles.hpp>

#include <cstddef>

namespace tightflip::properties {

template <class Items>
[[nodiscard]] auto& nth(Items& items, kernel::Index i) {
    return items[static_cast<std::size_t>(i)];
}

}  // namespace tightflip::properties
