// SPDX-License-Identifier: MIT
#include "renderer/integrator/column_loops.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "renderer/integrator/quick_unit.hpp"
#include "renderer/intersect/surface_forms.hpp"
#include "renderer/sampling/sobol.hpp"
#include "renderer/shading/fresnel.hpp"
#include "renderer/shading/phong.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/integrator/column_loops.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h, as Highway wants it.
#include <hwy/highway.h>

#include "renderer/integrator/pixel_places-inl.hpp"
#include "renderer/integrator/pixel_sums-inl.hpp"
#include "renderer/integrator/shadow_rays-inl.hpp"
#include "renderer/integrator/spread-inl.hpp"

// All that a loop calls becomes part of it: a call left over would keep it from taking many at
// once.
#define COBBLE_LOOP __attribute__((flatten))

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

COBBLE_LOOP bool through_pinhole_quickly(const PreparedCamera& of_scene,
                                         const CameraColumns& __restrict s,
                                         Columns3<float>& __restrict directions,
                                         std::size_t count) {
    const PreparedCamera camera = of_scene;
    std::uint32_t unsure = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const QuickUnit unit = quick_unit(camera.toward(s.x[i], s.y[i]));
        directions.set(i, unit.direction);
        unsure |= unit.unsure;
    }
    return unsure == 0;
}

template <typename T>
COBBLE_LOOP void through_pinhole_slowly(const PreparedCamera& of_scene,
                                        const CameraColumns& __restrict s,
                                        Columns3<T>& __restrict directions, std::size_t count) {
    const PreparedCamera camera = of_scene;
    for (std::size_t i = 0; i < count; ++i) {
        directions.set(i, camera.pinhole(s.x[i], s.y[i]).direction.template to<T>());
    }
}

template <typename T>
void through_pinhole(const PreparedCamera& camera, const CameraColumns& s, Columns3<T>& directions,
                     std::size_t count) {
    if constexpr (std::is_same_v<T, float>) {
        if (through_pinhole_quickly(camera, s, directions, count)) return;
    }
    through_pinhole_slowly(camera, s, directions, count);
}

/// What SurfacePoint and SurfaceLook say of a surface of a plain material.
template <bool kClosed, typename T>
void set_surface(HitColumns<T>& hits, std::size_t i, math::Vec3<T> direction,
                 math::Vec3<Wide<T>> position, math::Vec3d unit_normal, math::Vec3<T> shading) {
    const math::Vec3<T> geometric = unit_normal.template to<T>();
    const bool turned = !kClosed && math::dot(direction, geometric) > T(0);
    hits.position.set(i, position.template to<T>());
    hits.geometric.set(i, geometric);
    hits.normal.set(i, {turned ? -shading.x : shading.x, turned ? -shading.y : shading.y,
                        turned ? -shading.z : shading.z});
    hits.error[i] = static_cast<T>(rounding_error<T>(unit_normal, to_double(position)));
    hits.turned[i] = turned ? 1 : 0;
    hits.light.set(i, {});
}

template <typename T>
math::Vec3<Wide<T>> triangle_point_at(const SurfaceForms<T>& forms, const HitColumns<T>& hits,
                                      std::size_t i) {
    using W = Wide<T>;
    return triangle_point(widen(forms.a.at(i)), widen(forms.b.at(i)), widen(forms.c.at(i)),
                          W(hits.u[i]), W(hits.v[i]));
}

template <typename T>
COBBLE_LOOP void flat_triangles(const SurfaceForms<T>& __restrict forms,
                                const Columns3<T>& /*from*/, const Columns3<T>& __restrict way,
                                HitColumns<T>& __restrict hits, std::size_t first,
                                std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        const math::Vec3d normal = forms.normal.at(i);
        set_surface<false>(hits, i, way.at(i), triangle_point_at(forms, hits, i), normal,
                           normal.template to<T>());
    }
}

template <typename T>
COBBLE_LOOP void smooth_triangles(const SurfaceForms<T>& __restrict forms,
                                  const Columns3<T>& /*from*/, const Columns3<T>& __restrict way,
                                  HitColumns<T>& __restrict hits, std::size_t first,
                                  std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        const math::Vec3d normal = forms.normal.at(i);
        const math::Vec3d smooth =
            unit(triangle_point(forms.na.at(i), forms.nb.at(i), forms.nc.at(i),
                                static_cast<double>(hits.u[i]), static_cast<double>(hits.v[i])));
        const bool taken = dot(smooth, smooth) > 0.5;
        const math::Vec3d shading{taken ? smooth.x : normal.x, taken ? smooth.y : normal.y,
                                  taken ? smooth.z : normal.z};
        set_surface<false>(hits, i, way.at(i), triangle_point_at(forms, hits, i), normal,
                           shading.template to<T>());
    }
}

template <typename T>
COBBLE_LOOP void spheres(const SurfaceForms<T>& __restrict forms,
                         const Columns3<T>& __restrict from, const Columns3<T>& __restrict way,
                         HitColumns<T>& __restrict hits, std::size_t first, std::size_t end) {
    using W = Wide<T>;
    for (std::size_t i = first; i < end; ++i) {
        const math::Vec3<W> center = widen(forms.a.at(i));
        const math::Vec3<T> direction = way.at(i);
        const math::Vec3<W> n = sphere_normal(center, along(from.at(i), direction, hits.t[i]));
        const math::Vec3d normal = unit(to_double(n));
        set_surface<true>(hits, i, direction, center + n * W(forms.b.x[i]), normal,
                          normal.template to<T>());
    }
}

template <typename T>
COBBLE_LOOP void boxes(const SurfaceForms<T>& __restrict forms, const Columns3<T>& __restrict from,
                       const Columns3<T>& __restrict way, HitColumns<T>& __restrict hits,
                       std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        const BoxBounds<T> box{forms.a.at(i), forms.b.at(i)};
        const math::Vec3d normal = forms.normal.at(i);
        const math::Vec3<T> direction = way.at(i);
        set_surface<true>(hits, i, direction,
                          box_point(box, normal, along(from.at(i), direction, hits.t[i])), normal,
                          normal.template to<T>());
    }
}

template <typename T, typename U>
void spread(const Columns3<U>& values, std::size_t slot_count, const HitColumns<T>& hits,
            Columns3<U>& of_hits, std::size_t first, std::size_t end) {
    spread_column(values.x, slot_count, hits.slot, of_hits.x, first, end);
    spread_column(values.y, slot_count, hits.slot, of_hits.y, first, end);
    spread_column(values.z, slot_count, hits.slot, of_hits.z, first, end);
}

COBBLE_LOOP bool to_even_light_quickly(const PreparedLight& light, const HitColumns<float>& hits,
                                       LightColumns<float>& __restrict answers, std::size_t count) {
    const math::Vec3d place = light.position;
    const auto target = place.to<float>();
    const auto intensity = light.color.to<float>();
    std::uint32_t unsure = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const QuickUnit unit = quick_unit(place - hits.position.at(i).to<double>());
        answers.direction.set(i, unit.direction);
        answers.target.set(i, target);
        answers.intensity.set(i, intensity);
        unsure |= unit.unsure;
    }
    return unsure == 0;
}

template <typename T>
COBBLE_LOOP void to_point_light_slowly(const PreparedLight& of_scene, const HitColumns<T>& hits,
                                       LightColumns<T>& __restrict answers, std::size_t count) {
    const PreparedLight light = of_scene;
    const auto store = [&](std::size_t i, const LightSample<T>& sample) {
        answers.direction.set(i, sample.direction);
        answers.target.set(i, sample.target);
        answers.intensity.set(i, sample.intensity);
    };
    if (light.falloff == 0) {
        PreparedLight even = light;
        even.falloff = 0;
        for (std::size_t i = 0; i < count; ++i) {
            store(i, light_place(even, hits.position.at(i), even.position));
        }
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        store(i, light_place(light, hits.position.at(i), light.position));
    }
}

template <typename T>
void to_point_light(const PreparedLight& light, const HitColumns<T>& hits, LightColumns<T>& answers,
                    std::size_t count) {
    if constexpr (std::is_same_v<T, float>) {
        if (light.falloff == 0 && to_even_light_quickly(light, hits, answers, count)) return;
    }
    to_point_light_slowly(light, hits, answers, count);
}

template <typename T>
COBBLE_LOOP void lambert_share(const HitColumns<T>& hits, LightColumns<T>& answers,
                               std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        answers.share.set(i, lambert(hits.normal.at(i), answers.direction.at(i), hits.kd.at(i)));
    }
}

/// What ask loops read of a hit, all of it before they write: a number that is read again after a
/// store would keep them from taking many at once.
template <typename T>
struct Lit {
    math::Vec3<T> position, geometric, direction, target, intensity, share;
    T error;
    bool turned;

    Lit(const HitColumns<T>& hits, const LightColumns<T>& answers, std::size_t i)
        : position(hits.position.at(i)),
          geometric(hits.geometric.at(i)),
          direction(answers.direction.at(i)),
          target(answers.target.at(i)),
          intensity(answers.intensity.at(i)),
          share(answers.share.at(i)),
          error(hits.error[i]),
          turned(hits.turned[i] != 0) {}

    /// Of the light that is sent on. `hides_itself`: nothing comes from below the surface.
    void set_share(LightColumns<T>& answers, std::size_t i, bool hides_itself) const {
        const T toward = math::dot(geometric, direction);
        const T cosine = turned ? -toward : toward;
        const math::Vec3<T> sent = intensity * share;
        const bool above = !hides_itself || cosine > T(0);
        const math::Vec3<T> left{above ? sent.x : T(0), above ? sent.y : T(0),
                                 above ? sent.z : T(0)};
        answers.share.set(i, left);
        answers.matters[i] = left.x == T(0) && left.y == T(0) && left.z == T(0) ? 0 : 1;
    }
    void set_way(ShadowColumns<T>& rays, std::size_t i, bool outward, math::Vec3<T> from,
                 const Way<T>& way) const {
        rays.from.set(i, from);
        rays.outward[i] = outward ? 1 : 0;
        rays.way.set(i, way.direction);
        rays.t_max[i] = way.t_max;
    }
};

template <typename T>
COBBLE_LOOP void ask_with_shadows_to_target(const HitColumns<T>& __restrict hits,
                                            LightColumns<T>& __restrict answers,
                                            ShadowColumns<T>& __restrict rays, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const Lit<T> lit(hits, answers, i);
        const bool outward = goes_outward(lit.target - lit.position, lit.geometric);
        const math::Vec3<T> from = start_off(lit.position, lit.geometric, lit.error, outward);
        const Way<T> way = way_to(from, lit.target, lit.geometric);
        lit.set_share(answers, i, true);
        lit.set_way(rays, i, outward, from, way);
    }
}

template <typename T>
COBBLE_LOOP void ask_with_shadows_in_direction(const HitColumns<T>& __restrict hits,
                                               LightColumns<T>& __restrict answers,
                                               ShadowColumns<T>& __restrict rays,
                                               std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const Lit<T> lit(hits, answers, i);
        const bool outward = goes_outward(lit.direction, lit.geometric);
        const math::Vec3<T> from = start_off(lit.position, lit.geometric, lit.error, outward);
        lit.set_share(answers, i, true);
        lit.set_way(rays, i, outward, from, {lit.direction, std::numeric_limits<T>::infinity()});
    }
}

template <typename T>
COBBLE_LOOP void ask_without_shadows(const HitColumns<T>& __restrict hits,
                                     LightColumns<T>& __restrict answers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        Lit<T>(hits, answers, i).set_share(answers, i, false);
    }
}

template <typename T>
COBBLE_LOOP void add_light(HitColumns<T>& __restrict hits,
                           const LightColumns<T>& __restrict answers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const math::Vec3<T> before = hits.light.at(i);
        const math::Vec3<T> after = before + answers.share.at(i);
        const bool arrives = answers.matters[i] != 0;
        hits.light.set(i, {arrives ? after.x : before.x, arrives ? after.y : before.y,
                           arrives ? after.z : before.z});
    }
}

template <typename T>
void set_child(ChildColumns<T>& children, std::size_t i, math::Vec3<T> position,
               math::Vec3<T> geometric, T error, math::Vec3<T> direction, math::Vec3<T> weight,
               bool there) {
    const bool outward = goes_outward(direction, geometric);
    children.from.set(i, start_off(position, geometric, error, outward));
    children.direction.set(i, direction);
    children.weight.set(i, weight);
    children.outward[i] = outward ? 1 : 0;
    const bool nothing = weight.x == T(0) && weight.y == T(0) && weight.z == T(0);
    children.matters[i] = there && !nothing ? 1 : 0;
    children.heading[i] = heading(direction);
}

template <bool kGlass, bool kReflected, bool kRefracted, typename T>
COBBLE_LOOP void scatter(const SurfaceSlots<T>& __restrict slots,
                         const HitColumns<T>& __restrict hits, const Columns3<T>& __restrict way,
                         ScatterColumns<T>& __restrict rays, ChildColumns<T>* __restrict reflected,
                         ChildColumns<T>* __restrict refracted, std::size_t count) {
    static_assert(kGlass || !kRefracted);
    for (std::size_t i = 0; i < count; ++i) {
        const auto slot = static_cast<std::size_t>(hits.slot[i]);
        const math::Vec3<T> direction = way.at(i);
        const math::Vec3<T> geometric = hits.geometric.at(i);
        const math::Vec3<T> position = hits.position.at(i);
        const T error = hits.error[i];
        const math::Vec3<T> tint = rays.weight.at(i) * slots.specular.at(slot);
        // look_at_surface()'s view of it: turned or not, the normal has the viewer's side.
        const bool leaving = math::dot(direction, geometric) > T(0);
        const T away = leaving ? T(-1) : T(1);
        const T normal_away = hits.turned[i] != 0 ? -away : away;
        const math::Vec3<T> viewer_geometric = geometric * away;
        const math::Vec3<T> viewer_normal =
            facing(hits.normal.at(i) * normal_away, viewer_geometric, direction);
        T reflectance = 1;
        if constexpr (kGlass) {
            const T inside = slots.index[slot];
            const bool see_through = inside > T(0);
            const T index = leaving ? T(1) : inside;
            const Refraction<T> through =
                refract(direction, viewer_normal, rays.index[i], see_through ? index : T(1));
            reflectance = see_through ? through.reflectance : T(1);
            if constexpr (kRefracted) {
                const math::Vec3<T> on = keep_above(through.direction, -viewer_geometric);
                rays.index_beyond[i] = index;
                set_child(*refracted, i, position, geometric, error, on,
                          tint * (T(1) - reflectance), see_through && !through.total);
            }
        }
        if constexpr (kReflected) {
            const math::Vec3<T> back =
                keep_above(reflect(direction, viewer_normal), viewer_geometric);
            set_child(*reflected, i, position, geometric, error, back, tint * reflectance, true);
        }
    }
}

template <typename T>
COBBLE_LOOP void add_ambient(math::Vec3<T> ambient, const HitColumns<T>& hits, Columns3<T>& colors,
                             std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        colors.set(i, ambient * hits.kd.at(i) + hits.light.at(i));
    }
}

template <typename T>
COBBLE_LOOP bool all_finite(const Columns3<T>& values, std::size_t count) {
    constexpr T kMost = std::numeric_limits<T>::max();
    std::uint32_t unsound = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const math::Vec3<T> v = values.at(i);
        const bool sound =
            std::fabs(v.x) <= kMost && std::fabs(v.y) <= kMost && std::fabs(v.z) <= kMost;
        unsound |= sound ? 0U : 1U;
    }
    return unsound == 0;
}

template <typename T>
const ColumnLoops<T>& loops() {
    static constexpr ColumnLoops<T> kLoops{
        place_in_pixels,
        through_pinhole<T>,
        flat_triangles<T>,
        smooth_triangles<T>,
        spheres<T>,
        boxes<T>,
        spread<T, T>,
        spread<T, double>,
        to_point_light<T>,
        lambert_share<T>,
        ask_with_shadows_to_target<T>,
        ask_with_shadows_in_direction<T>,
        ask_without_shadows<T>,
        begin_shadow_rays<T>,
        add_light<T>,
        scatter<false, true, false, T>,
        scatter<true, true, false, T>,
        scatter<true, false, true, T>,
        scatter<true, true, true, T>,
        add_ambient<T>,
        sum_pixels<T>,
        all_finite<T>,
    };
    return kLoops;
}

const ColumnLoops<float>& loops_float() { return loops<float>(); }
const ColumnLoops<double>& loops_double() { return loops<double>(); }

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cobble::renderer {

HWY_EXPORT(loops_float);
HWY_EXPORT(loops_double);

template <>
const ColumnLoops<float>& column_loops<float>() {
    return HWY_DYNAMIC_DISPATCH(loops_float)();
}
template <>
const ColumnLoops<double>& column_loops<double>() {
    return HWY_DYNAMIC_DISPATCH(loops_double)();
}

}  // namespace cobble::renderer
#endif
