// SPDX-License-Identifier: MIT
// Rays that wait to be traced, all of one kind and depth.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/geometry/ray.hpp"
#include "renderer/integrator/columns.hpp"

namespace cobble::renderer {

/// What a ray has with it for the way back and for its children.
template <typename T>
struct Carried {
    math::Vec3<T> weight{1, 1, 1};  ///< of what it brings back, in its pixel
    T index = 1;                    ///< refraction index of where it travels
    std::uint32_t sample = 0;       ///< that it belongs to, among those on their way
    std::uint32_t number = 0;       ///< in the tree; its parent's before it has one
};

/// What rays have in common that go the same way from the same object, or one of few: they are
/// likely to meet the same things. First by where they go.
using Likeness = std::uint16_t;
inline constexpr std::size_t kLikePlaces = 64;
inline constexpr std::size_t kLikenesses = kHeadings * kLikePlaces;
inline Likeness likeness(std::int32_t heading, std::uint32_t object) {
    return static_cast<Likeness>(static_cast<std::uint32_t>(heading) * kLikePlaces +
                                 object % kLikePlaces);
}

/// Written one after the other, read in pieces. Keeps its memory.
template <typename T>
class PendingRays {
  public:
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    void clear() { count_ = 0; }

    /// Room for so many more: reached by place until they are taken in.
    void make_room(std::size_t more) {
        if (count_ + more <= rays_.size()) return;
        const std::size_t size = std::max(count_ + more, 2 * rays_.size());
        rays_.resize(size);
        excludes_.resize(size);
        carried_.resize(size);
        likenesses_.resize(size);
    }
    void take_in(std::size_t more) { count_ += more; }

    [[nodiscard]] Ray<T>* rays(std::size_t at) { return rays_.data() + at; }
    [[nodiscard]] Exclude* excludes(std::size_t at) { return excludes_.data() + at; }
    [[nodiscard]] Carried<T>* carried(std::size_t at) { return carried_.data() + at; }
    [[nodiscard]] Likeness* likenesses(std::size_t at) { return likenesses_.data() + at; }

    /// `count` of another's rays from `first` on.
    void append(PendingRays& from, std::size_t first, std::size_t count) {
        make_room(count);
        std::copy_n(from.rays(first), count, rays(count_));
        std::copy_n(from.excludes(first), count, excludes(count_));
        std::copy_n(from.carried(first), count, carried(count_));
        std::copy_n(from.likenesses(first), count, likenesses(count_));
        count_ += count;
    }

  private:
    std::vector<Ray<T>> rays_;
    std::vector<Exclude> excludes_;
    std::vector<Carried<T>> carried_;
    std::vector<Likeness> likenesses_;
    std::size_t count_ = 0;
};

}  // namespace cobble::renderer
