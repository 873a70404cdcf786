// SPDX-License-Identifier: MIT
#include "renderer/accel/large_pages.hpp"

#include <cstddef>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cobble::renderer {
namespace {

/// Of x86-64, and of ARM's pages of 4 KiB.
constexpr std::size_t kLargePage = std::size_t{2} << 20;

bool is_large(std::size_t bytes) { return bytes >= kLargePage / 2; }

}  // namespace

void* allocate_large(std::size_t bytes, std::size_t alignment) {
    if (!is_large(bytes)) return ::operator new (bytes, std::align_val_t{alignment});
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* const memory = ::operator new (whole, std::align_val_t{kLargePage});
#ifdef __linux__
    // Advice: where it is not taken nothing is lost but time.
    madvise(memory, whole, MADV_HUGEPAGE);
#endif
    return memory;
}

void free_large(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
    ::operator delete (memory, std::align_val_t{is_large(bytes) ? kLargePage : alignment});
}

}  // namespace cobble::renderer
