// SPDX-License-Identifier: MIT
#include "renderer/accel/large_pages.hpp"

#include <cstddef>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cobble::renderer {
namespace {

/// Of x86-64, and of ARM's pages of 4 KiB.
constexpr std::size_t kLargePage = std::size_t{2} << 20;

#ifdef MADV_HUGEPAGE
/// Advice: where it is not taken nothing is lost but time.
void ask_for_large_pages(void* memory, std::size_t bytes) { madvise(memory, bytes, MADV_HUGEPAGE); }
bool is_large(std::size_t bytes) { return bytes >= kLargePage / 2; }
#else
/// Elsewhere nobody takes advice, and whole pages would only be memory lost.
void ask_for_large_pages(void* /*memory*/, std::size_t /*bytes*/) {}
bool is_large(std::size_t /*bytes*/) { return false; }
#endif

}  // namespace

void* allocate_large(std::size_t bytes, std::size_t alignment) {
    // Rounded up, it would be next to nothing.
    if (bytes > std::numeric_limits<std::size_t>::max() - kLargePage) throw std::bad_alloc();
    if (!is_large(bytes)) return ::operator new (bytes, std::align_val_t{alignment});
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* const memory = ::operator new (whole, std::align_val_t{kLargePage});
    ask_for_large_pages(memory, whole);
    return memory;
}

void free_large(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
    ::operator delete (memory, std::align_val_t{is_large(bytes) ? kLargePage : alignment});
}

}  // namespace cobble::renderer
