// SPDX-License-Identifier: MIT
// What float loses of an object, and the words for it: the findings of the lint `precision-loss`.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "frontend/source/diagnostic.hpp"
#include "ir/lower.hpp"
#include "ir/math/narrow.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Shapes that are moved by less keep three quarters of their width.
inline constexpr double kLostShare = 0.25;

inline double largest(math::Vec3d p) {
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

/// Something that has a width, and what float does to it.
struct Feature {
    double width = 0;
    double reach = 0;  ///< its largest coordinate, relative to the local origin
    double moved = 0;  ///< by narrowing

    [[nodiscard]] double lost() const { return moved / width; }
};

/// A place in the picture.
struct Place {
    double pixel = 0;  ///< its width there
    double reach = 0;  ///< the largest coordinate of it, or of the camera if that is larger
    bool at_camera = false;

    [[nodiscard]] double step() const { return double{math::step_at<float>(reach)}; }
    [[nodiscard]] double steps() const { return pixel / step(); }
};

struct Loss {
    std::optional<Feature> feature;
    std::optional<Place> place;
    bool out_of_range = false;
    double reach = 0;                       ///< if so, its largest coordinate in the world
    std::size_t lost_faces = 0, faces = 0;  ///< of those of a mesh that were looked at
    std::size_t flat_faces = 0;             ///< of them, those that narrowing leaves without area
    std::optional<Feature> flat;            ///< the widest of these
    std::uint32_t flat_at = 0;              ///< byte of the first one's line
};

/// The findings of one scene.
class LossWords {
  public:
    LossWords(const Scene& scene, PictureSize size, math::Vec3d local_origin)
        : scene_(&scene), size_(size), origin_(local_origin) {}

    source::Diagnostic describe(const Object& object, const Loss& loss);

  private:
    const Scene* scene_;
    PictureSize size_;
    math::Vec3d origin_;
    bool origin_told_ = false;  ///< once is enough for a scene
};

}  // namespace cobble::ir
