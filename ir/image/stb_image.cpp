// SPDX-License-Identifier: MIT
// The one place that contains stb_image. Without SIMD, so that a JPEG has the same bits everywhere.
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "ir/image/stb_budget.hpp"

namespace cobble::image {
namespace {

thread_local std::size_t budget_left = 0;

// Each block is preceded by its size.
constexpr std::size_t kHeader = alignof(std::max_align_t);

void release(void* pointer) {
    if (pointer == nullptr) return;
    char* const block = static_cast<char*>(pointer) - kHeader;
    std::size_t size = 0;
    std::memcpy(&size, block, sizeof size);
    budget_left += size;
    std::free(block);
}

// Zeroed, so that what a damaged stream leaves out has one value.
void* allocate(std::size_t size) {
    if (size > budget_left) return nullptr;
    char* const block = static_cast<char*>(std::calloc(1, size + kHeader));
    if (block == nullptr) return nullptr;
    budget_left -= size;
    std::memcpy(block, &size, sizeof size);
    return block + kHeader;
}

void* reallocate(void* pointer, std::size_t size) {
    if (pointer == nullptr) return allocate(size);
    void* const moved = allocate(size);
    if (moved == nullptr) return nullptr;
    std::size_t old_size = 0;
    std::memcpy(&old_size, static_cast<char*>(pointer) - kHeader, sizeof old_size);
    std::memcpy(moved, pointer, old_size < size ? old_size : size);
    release(pointer);
    return moved;
}

}  // namespace

StbBudget::StbBudget(std::size_t bytes) { budget_left = bytes; }
StbBudget::~StbBudget() { budget_left = 0; }

}  // namespace cobble::image

#define STBI_ONLY_BMP
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_LINEAR
#define STBI_NO_SIMD
#define STBI_NO_STDIO
#define STBI_ASSERT(x) ((void)0)
#define STBI_MALLOC(size) cobble::image::allocate(size)
#define STBI_REALLOC(pointer, size) cobble::image::reallocate(pointer, size)
#define STBI_FREE(pointer) cobble::image::release(pointer)
#define STB_IMAGE_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
