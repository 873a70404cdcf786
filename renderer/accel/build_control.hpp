// SPDX-License-Identifier: MIT
// How building a tree is run: nothing here changes the tree.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace cobble::renderer {

struct BuildControl {
    /// If given and true at any time, building returns soon, with nothing in it.
    const std::atomic<bool>* cancelled = nullptr;
    /// Calls work(i) once for each i in [0, count), at once or in any order, and returns when all
    /// have returned. Empty: one after the other.
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)> parallel{};

    void for_each(std::size_t count, const std::function<void(std::size_t)>& work) const {
        if (parallel) {
            parallel(count, work);
        } else {
            for (std::size_t i = 0; i < count; ++i) work(i);
        }
    }
    [[nodiscard]] bool stopped() const {
        return cancelled != nullptr && cancelled->load(std::memory_order_relaxed);
    }
};

}  // namespace cobble::renderer
