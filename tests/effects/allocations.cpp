// SPDX-License-Identifier: MIT
#include "tests/effects/allocations.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> asked_for{0};

void* allocate(std::size_t bytes, std::size_t alignment) {
    asked_for.fetch_add(bytes, std::memory_order_relaxed);
    // The size is to be a multiple of the alignment.
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    void* const place = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
    if (place == nullptr) throw std::bad_alloc();
    return place;
}

}  // namespace

namespace cobble::test {

std::uint64_t bytes_asked_for() { return asked_for.load(std::memory_order_relaxed); }

}  // namespace cobble::test

void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new[](std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
