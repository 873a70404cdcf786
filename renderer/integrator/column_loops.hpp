// SPDX-License-Identifier: MIT
// Loops over columns, compiled for each instruction set from the same inline functions that the
// reference calls for one ray: additions, multiplications, divisions and roots of each number
// alone, in the same order, so that the bits are the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/camera/camera.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/shading/light.hpp"

namespace cobble::renderer {

/// Loops over [first, end) or [0, count). They may go on to the end of a register: beyond `end`
/// columns hold anything.
template <typename T>
struct ColumnLoops {
    /// The places that the filter chooses in each run's pixel, for PixelFilter::kBox.
    void (*place_in_pixels)(CameraColumns& samples);
    /// From places to directions, without a lens.
    void (*through_pinhole)(const PreparedCamera& camera, const CameraColumns& samples,
                            Columns3<T>& directions, std::size_t count);

    /// Surfaces of plain materials: all that HitColumns says of them but for `kd`. `forms`, `from`
    /// and `direction` are those of the hits.
    using Surfaces = void (*)(const SurfaceForms<T>& forms, const Columns3<T>& from,
                              const Columns3<T>& direction, HitColumns<T>& hits, std::size_t first,
                              std::size_t end);
    Surfaces flat_triangles, smooth_triangles, spheres, boxes;
    /// What `values` has for each of the first `slot_count` slots, for each hit by its slot: values
    /// of hits up to 15 before `first` and behind `end` may be written too.
    template <typename U>
    using Spread = void (*)(const Columns3<U>& values, std::size_t slot_count,
                            const HitColumns<T>& hits, Columns3<U>& of_hits, std::size_t first,
                            std::size_t end);
    Spread<T> spread;
    Spread<double> spread_double;

    /// light_middle(), for kPoint.
    void (*to_point_light)(const PreparedLight& light, const HitColumns<T>& hits,
                           LightColumns<T>& answers, std::size_t count);
    /// lambert(), into `share`.
    void (*lambert_share)(const HitColumns<T>& hits, LightColumns<T>& answers, std::size_t count);
    /// Times intensity; nothing from below, and the way to the light: to `target`, or endlessly in
    /// its direction.
    using Ask = void (*)(const HitColumns<T>& hits, LightColumns<T>& answers,
                         ShadowColumns<T>& rays, std::size_t count);
    Ask ask_with_shadows_to_target, ask_with_shadows_in_direction;
    void (*ask_without_shadows)(const HitColumns<T>& hits, LightColumns<T>& answers,
                                std::size_t count);

    /// The rays to the light from hits whose share matters, side by side, all but their time; which
    /// hits those are, and how many.
    std::size_t (*begin_shadow_rays)(const SurfaceSlots<T>& slots, std::size_t slot_count,
                                     const HitColumns<T>& hits, const LightColumns<T>& answers,
                                     const ShadowColumns<T>& of_entries, std::size_t count,
                                     RayBatch<T>& rays,
                                     std::array<std::uint32_t, kBatchSize>& askers);

    /// Adds the shares that matter to the hits' light.
    void (*add_light)(HitColumns<T>& hits, const LightColumns<T>& answers, std::size_t count);

    /// What scatter() sends on, into the columns of each kind; null: none of that kind. Of mirrors
    /// alone; and of glass too: what it reflects, what it lets through, both.
    using Scatter = void (*)(const SurfaceSlots<T>& slots, const HitColumns<T>& hits,
                             const Columns3<T>& direction, ScatterColumns<T>& rays,
                             ChildColumns<T>* reflected, ChildColumns<T>* refracted,
                             std::size_t count);
    Scatter scatter_mirror, scatter_off_glass, scatter_through_glass, scatter_glass;

    /// ambient kd + light, into `colors`, which may be the light's own columns.
    void (*add_ambient)(math::Vec3<T> ambient, const HitColumns<T>& hits, Columns3<T>& colors,
                        std::size_t count);
    /// Of `pixels` pixels, each the next `samples` colours: each channel added in the order of the
    /// samples.
    void (*sum_pixels)(const Columns3<T>& colors, std::size_t samples, std::size_t pixels,
                       PixelSums& sums);
    bool (*all_finite)(const Columns3<T>& values, std::size_t count);
};

/// By the best instruction set that the processor has, or use_instruction_set()'s.
template <typename T>
const ColumnLoops<T>& column_loops();

}  // namespace cobble::renderer
