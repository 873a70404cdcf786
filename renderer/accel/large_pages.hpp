// SPDX-License-Identifier: MIT
// Memory for what rays read in no order: a tree of some size in the system's large pages, if it has
// any for who asks. Every step of a walk reads another page; those of 4 KiB are more than the
// processor remembers where to find.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace cobble::renderer {

/// `bytes` at a multiple of `alignment`; from half a large page on in large pages, and then in
/// whole ones, where the system can be asked for them (Linux). Throws std::bad_alloc.
void* allocate_large(std::size_t bytes, std::size_t alignment);
/// With the values it was allocated with.
void free_large(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// An allocator for std::vector.
template <typename T>
class LargePages {
  public:
    using value_type = T;

    LargePages() = default;
    template <typename U>
    explicit(false) LargePages(const LargePages<U>&) {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_large(count * sizeof(T), alignof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        free_large(memory, count * sizeof(T), alignof(T));
    }
    template <typename U>
    bool operator==(const LargePages<U>&) const {
        return true;
    }
};

template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace cobble::renderer
