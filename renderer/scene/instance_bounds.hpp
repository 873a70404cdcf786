// SPDX-License-Identifier: MIT
// The world box of an instance, wide enough for every ray that its matrix turns into a hit.
#pragma once

#include <span>

#include "renderer/scene/geometry.hpp"

namespace cobble::renderer {

/// `shape` in the instance's own space; `keys` as it stands at equal steps of time, its inverse
/// between them interpolated entry by entry. Contains the image of the box at every time, and
/// beyond it what mapping a ray in T may err: gamma |W^-1| |W| |box|. If a matrix between two keys
/// is singular, or nearly so, the box is everything.
template <typename T>
BoxBounds<T> instance_bounds(const BoxBounds<T>& shape, std::span<const InstanceKey<T>> keys);

}  // namespace cobble::renderer
