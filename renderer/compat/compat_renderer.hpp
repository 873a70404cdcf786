// SPDX-License-Identifier: MIT
// Pixels as the published programs computed them: the course's ray caster (a4) and ray tracer (a5)
// of 2012, its edition of 2016, and the project that Cobble grew from.
//
// Fixed by what is on record: the place of pixels (2 i / (w - 1) - 1 in both directions, pictures
// that are not square stretched), the surface formulas, secondary rays that begin 0.001 from the
// hit point, the 3x3 grid of -jitter, the 5-tap kernel of -filter. The originals used single
// precision and rand(); here everything is double, and jitter is a hash of sample and seed.
// Pictures must be written with Quantise::kTruncate, depth and normals through
// renderer/compat/pictures.hpp.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// `scene.compat` is not kNone; `scene` must outlive the renderer. Of the settings it reads the
/// size, bounces, seed, acceleration (kFast counts as kBvh), which planes are wanted, and
/// Settings::Compat; effects and samples are the program's own. A tile that needs its neighbours'
/// samples (-filter) computes them itself, so that tiles do not matter. Memory while a tile is on
/// its way: 24 bytes a sample, 3x3 a pixel at most. `bytes`: of the prepared scene. If `cancelled`
/// is given and becomes true, returns soon, with what must not be used.
std::unique_ptr<TileRenderer> make_compat_renderer(const ir::Scene& scene, const Settings& settings,
                                                   std::uint64_t& bytes,
                                                   const std::atomic<bool>* cancelled = nullptr);

/// Samples that one pixel counts as in TileWork::samples_done: 9 with jitter or filter, else 1, and
/// 16 times that with a lens.
std::uint32_t compat_samples_per_pixel(const ir::Scene& scene, const Settings& settings);

}  // namespace cobble::renderer
