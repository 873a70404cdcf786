// SPDX-License-Identifier: MIT
// What the rays of many samples brought back, kept until it can be added in the order of the
// reference: of each sample the ray itself, then all that came of its reflection, then all that
// came of its refraction.
//
// Rays that went the same way are a group. The tree of groups has each sample's own tree in it, so
// that going through it once, depth first, adds to all samples in their order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ir/math/vec.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/pending_rays.hpp"
#include "renderer/integrator/stages.hpp"
#include "renderer/sampling/sampler.hpp"

namespace cobble::renderer {

/// Reflected rays and refracted ones, by place in an array.
inline constexpr std::size_t kTurns = 2;
inline constexpr std::array<RayKind, kTurns> kTurn{RayKind::kReflected, RayKind::kRefracted};

/// Rays of one path.
struct RayGroup {
    static constexpr std::uint32_t kNone = 0;  ///< the first one is nobody's child

    PathAddress path;
    std::uint32_t begin = 0, end = 0;  ///< among the tree's rays
    std::array<std::uint32_t, kTurns> children{kNone, kNone};
};

/// What a ray brought back, as its sample has it.
template <typename T>
struct Brought {
    math::Vec3<T> color;
    std::uint32_t sample = 0;
};

template <typename T>
class RayTree {
  public:
    /// With `count` rays of one path.
    void begin(PathAddress path, std::size_t count) {
        groups_.assign(1, {path, 0, static_cast<std::uint32_t>(count), {}});
        ray_count_ = count;
    }
    /// A new group of the next `count` rays.
    void add(std::uint32_t parent, std::size_t turn, std::size_t count) {
        RayGroup& of = groups_[parent];
        of.children[turn] = static_cast<std::uint32_t>(groups_.size());
        const PathAddress path = turn == 0 ? of.path.reflected() : of.path.refracted();
        const std::size_t end = ray_count_ + count;
        groups_.push_back(
            {path, static_cast<std::uint32_t>(ray_count_), static_cast<std::uint32_t>(end), {}});
        ray_count_ = end;
    }
    [[nodiscard]] const std::vector<RayGroup>& groups() const { return groups_; }
    [[nodiscard]] std::size_t ray_count() const { return ray_count_; }

    /// What rays bring back: the colours of their batch.
    void bring(const Columns3<T>& colors, const Carried<T>* carried, std::size_t count) {
        if (brought_.size() < ray_count_) brought_.resize(ray_count_);
        for (std::size_t i = 0; i < count; ++i) {
            brought_[carried[i].number] = {carried[i].weight * colors.at(i), carried[i].sample};
        }
    }
    /// That of a ray.
    [[nodiscard]] const RayGroup& group_of(std::uint32_t number) const {
        return *std::upper_bound(
            groups_.begin(), groups_.end(), number,
            [](std::uint32_t of, const RayGroup& group) { return of < group.end; });
    }

    /// `visit(index of a group)`, depth first.
    template <typename Visit>
    void visit_all(const Visit& visit) {
        next_.assign(1, 0);
        while (!next_.empty()) {
            const std::uint32_t index = next_.back();
            next_.pop_back();
            visit(index);
            for (std::size_t turn = kTurns; turn > 0; --turn) {
                const std::uint32_t child = groups_[index].children[turn - 1];
                if (child != RayGroup::kNone) next_.push_back(child);
            }
        }
    }
    /// `add(what a ray of the group brought)`.
    template <typename Add>
    void each_brought(const RayGroup& group, const Add& add) const {
        for (std::size_t i = group.begin; i < group.end; ++i) add(brought_[i]);
    }

  private:
    std::vector<RayGroup> groups_;
    std::vector<Brought<T>> brought_;  ///< by number; of more rays than there are
    std::size_t ray_count_ = 0;
    std::vector<std::uint32_t> next_;
};

}  // namespace cobble::renderer
