// SPDX-License-Identifier: MIT
// The rays to a light, of the hits that it matters to, side by side.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SHADOW_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SHADOW_RAYS_INL
#undef COBBLE_SHADOW_RAYS_INL
#else
#define COBBLE_SHADOW_RAYS_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/integrator/spread-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Askers = std::array<std::uint32_t, kBatchSize>;

template <typename T>
std::size_t shadow_rays_one_by_one(const HitColumns<T>& hits, const LightColumns<T>& answers,
                                   const ShadowColumns<T>& of_entries, std::size_t count,
                                   RayBatch<T>& rays, Askers& askers, std::int32_t* slots) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (answers.matters[i] == 0) continue;
        rays.origin.set(found, of_entries.from.at(i));
        rays.direction.set(found, of_entries.way.at(i));
        rays.t_max[found] = of_entries.t_max[i];
        rays.outward[found] = of_entries.outward[i];
        slots[found] = hits.slot[i];
        askers[found++] = static_cast<std::uint32_t>(i);
    }
    return found;
}

#if HWY_TARGET != HWY_SCALAR

/// What is written behind the rays found so far is never beyond the registers read.
inline std::size_t shadow_rays_in_lanes(const HitColumns<float>& hits,
                                        const LightColumns<float>& answers,
                                        const ShadowColumns<float>& of_entries, std::size_t count,
                                        RayBatch<float>& rays, Askers& askers,
                                        std::int32_t* slots) {
    const hn::CappedTag<float, 16> d;
    const hn::RebindToSigned<decltype(d)> di;
    const hn::RebindToUnsigned<decltype(d)> du;
    alignas(kColumnAlignment) static constexpr std::int32_t kLanesInOrder[16] = {
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const auto lane = hn::Load(di, kLanesInOrder);
    std::size_t found = 0;
    for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
        const auto left = hn::Set(di, static_cast<std::int32_t>(count - at));
        const auto matters =
            hn::And(hn::Ne(hn::Load(di, answers.matters + at), hn::Zero(di)), hn::Lt(lane, left));
        const auto mask = hn::RebindMask(d, matters);
        const auto keep = [&](const float* from, float* to) HWY_ATTR {
            hn::StoreU(hn::Compress(hn::Load(d, from + at), mask), d, to + found);
        };
        const auto keep3 = [&](const Columns3<float>& from, Columns3<float>& to) HWY_ATTR {
            keep(from.x, to.x);
            keep(from.y, to.y);
            keep(from.z, to.z);
        };
        const auto keep_whole = [&](const std::int32_t* from, std::int32_t* to) HWY_ATTR {
            hn::StoreU(hn::Compress(hn::Load(di, from + at), matters), di, to + found);
        };
        keep3(of_entries.from, rays.origin);
        keep3(of_entries.way, rays.direction);
        keep(of_entries.t_max, rays.t_max);
        keep_whole(of_entries.outward, rays.outward);
        keep_whole(hits.slot, slots);
        const auto entry = hn::Add(lane, hn::Set(di, static_cast<std::int32_t>(at)));
        hn::StoreU(hn::BitCast(du, hn::Compress(entry, matters)), du, askers.data() + found);
        found += hn::CountTrue(di, matters);
    }
    return found;
}

#endif

template <typename T>
std::size_t begin_shadow_rays(const SurfaceSlots<T>& of_slots, std::size_t slot_count,
                              const HitColumns<T>& hits, const LightColumns<T>& answers,
                              const ShadowColumns<T>& of_entries, std::size_t count,
                              RayBatch<T>& rays, Askers& askers) {
    alignas(kColumnAlignment) std::int32_t slots[kBatchSize];
    std::size_t found = 0;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (sizeof(T) == sizeof(float)) {
        found = shadow_rays_in_lanes(hits, answers, of_entries, count, rays, askers, slots);
    } else
#endif
    {
        found = shadow_rays_one_by_one(hits, answers, of_entries, count, rays, askers, slots);
    }
    spread_column(of_slots.object, slot_count, slots, rays.object, 0, found);
    spread_column(of_slots.face, slot_count, slots, rays.face, 0, found);
    return found;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
