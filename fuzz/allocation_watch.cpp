#include "allocation_watch.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t largest_allocation = 0;

}  // namespace

// The forms for arrays and for types of great alignment stay those of the library or a sanitizer,
// which belong together; nothing here uses them for much.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    largest_allocation = std::max(largest_allocation, size);
    // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): this is where new comes from
    return std::malloc(size > 0 ? size : 1);
}

void* operator new(std::size_t size) {
    if (void* const memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
    std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

namespace tightflip::fuzz {

AllocationWatch::AllocationWatch() {
    largest_allocation = 0;
}

std::size_t AllocationWatch::largest() const {
    return largest_allocation;
}

std::string AllocationWatch::objection(std::size_t bytes) const {
    if (largest() <= most_in_any_case + most_a_byte * bytes) return {};
    return "memory_is_worth_the_bytes: " + std::to_string(largest()) + " bytes at once for " +
           std::to_string(bytes) + " bytes of input";
}

}  // namespace tightflip::fuzz
