// SPDX-License-Identifier: MIT
// The scene as the ray loop sees it: narrowed to the scalar type T once, in flat arrays.
//
// T is float or double. Coordinates are local: world minus `origin`, a point on a power-of-two grid
// near where the camera looks from, so that a scene far from zero keeps its precision and a scene
// moved by whole grid steps keeps its every bit.
#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/accel/build_control.hpp"
#include "renderer/scene/geometry.hpp"
#include "renderer/scene/preparation_note.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

struct PrepareOptions {
    Acceleration acceleration = Acceleration::kBvh;
    bool texture_coordinates = true;  ///< keep uv and give tangents; off: none are loaded
    /// Who works at it, and whether it was cancelled: then prepare() returns soon, with a scene
    /// that must not be used.
    BuildControl build{};
};

template <typename T>
struct PreparedScene {
    const ir::Scene* source = nullptr;  ///< must outlive this
    PrepareOptions options;
    math::Vec3d origin;

    [[nodiscard]] math::Vec3<T> to_local(math::Vec3d world) const {
        return (world - origin).template to<T>();
    }
    [[nodiscard]] math::Vec3d to_world(math::Vec3<T> local) const {
        return local.template to<double>() + origin;
    }

    Geometry<T> geometry;
    std::vector<PreparationNote> notes;  ///< by object

    /// Bytes of everything held, without the source.
    [[nodiscard]] std::uint64_t bytes() const;
};

/// Costs O(n log n) time and some 150 bytes a triangle in float. Takes any scene that lowering
/// returns; meets no number that it cannot treat. Throws TooManyThings (a std::bad_alloc) for more
/// than a tree can hold.
template <typename T>
PreparedScene<T> prepare(const ir::Scene& scene, const PrepareOptions& options = {});

}  // namespace cobble::renderer
