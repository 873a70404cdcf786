// SPDX-License-Identifier: MIT
#include "renderer/stability/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ir/math/elementary.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/scene/shape_bounds.hpp"
#include "renderer/stability/exact.hpp"
#include "renderer/stability/reach.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloatRounding = 0x1p-24;
// What the tests of spheres and silhouettes hold float to: 8 u of the coordinates.
constexpr double kBound = 8 * kFloatRounding;
// A point that leave() has moved off lies up to 2.25 bounds of its own from the surface, and was
// up to 1 from it before: 4 with the roundings of this sum.
constexpr double kLeavingBounds = 4;
// Surfaces that touch at less than 8 degrees lie with each other.
constexpr double kSameSurface = 0.99;
// Rays around one, to find the outline of something that is near it.
constexpr std::uint32_t kRing = 16;

double sum_of(Vec3d a) { return (std::fabs(a.x) + std::fabs(a.y)) + std::fabs(a.z); }

/// Of the angle between the ray and the surface's normal; 0 at a silhouette.
template <typename T>
double cosine_of(const Seen<T>& seen) {
    return std::fabs(dot(seen.point.geometric_normal.template to<double>(),
                         normalize(seen.ray.direction.template to<double>())));
}

}  // namespace

/// World units: how far off a float hit here may be from where double sees it.
template <typename T>
double FloatJudge::bound_of(const Seen<T>& seen) const {
    const Vec3d origin = seen.ray.origin.template to<double>();
    const double way = length(seen.ray.direction.template to<double>()) * double{seen.hit.t};
    const double reach = reach_of(source_, wide_.origin, seen.hit.object, seen.hit.face);
    // The point's own bound grows with the rounding of its type.
    const double own = double{seen.point.error} *
                       (kFloatRounding / (double{std::numeric_limits<T>::epsilon()} / 2));
    return kBound * (sum_of(origin) + way + reach) + kLeavingBounds * own;
}

void FloatJudge::look(Seen<double>& seen) {
    seen.hit = closest_hit(wide_, seen.ray, {}, counters_);
    if (seen.hit) seen.point = surface_at(wide_, seen.ray, seen.hit);
}

/// What double sees along the ray and along those around it.
const std::vector<Seen<double>>& FloatJudge::seen_around(Surroundings& around) {
    if (!around.seen.empty()) return around.seen;
    const Seen<double>& middle = around.middle;
    around.seen.assign(kRing + 1, middle);
    const Vec3d way = normalize(middle.ray.direction);
    const Vec3d other = std::fabs(way.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = normalize(cross(other, way)) * around.bound;
    const Vec3d v = cross(way, u);
    for (std::uint32_t k = 0; k < kRing; ++k) {
        const math::SinCos turn = math::sincos(k * (2 * math::kPi / kRing));
        Seen<double>& seen = around.seen[k];
        // Every other one at half the bound: outlines have corners.
        const double size = k % 2 == 0 ? 1 : 0.5;
        seen.ray.origin = middle.ray.origin + (u * turn.cos + v * turn.sin) * size;
        look(seen);
    }
    return around.seen;
}

FloatVerdict FloatJudge::judge(const Seen<float>& narrow, Surroundings& around) {
    const Seen<double>& wide = around.middle;
    if (!narrow.hit && !wide.hit) return FloatVerdict::kRight;
    // Whether float is right depends on the outline of what is in front.
    const bool float_first = narrow.t() < wide.t();
    around.bound = float_first ? bound_of(narrow) : bound_of(wide);
    if (!(around.bound <= std::numeric_limits<double>::max())) return FloatVerdict::kUnknown;
    // The bound is across the surface: along a ray that grazes it, it is longer.
    const double cosine = float_first ? cosine_of(narrow) : cosine_of(wide);
    const double slack =
        cosine > 0 ? around.bound / (length(wide.ray.direction) * cosine) : kInfinity;
    if (std::fabs(narrow.t() - wide.t()) <= slack) return FloatVerdict::kRight;
    double nearest = kInfinity;
    double farthest = 0;
    for (const Seen<double>& seen : seen_around(around)) {
        nearest = std::min(nearest, seen.t());
        farthest = std::max(farthest, seen.t());
    }
    if (narrow.t() > farthest + slack) return FloatVerdict::kCrack;
    if (narrow.t() < nearest - slack) return FloatVerdict::kChanged;
    return FloatVerdict::kRight;
}

bool FloatJudge::is_self_hit(const Seen<float>& narrow, Vec3d side, const Seen<float>& again,
                             Surroundings& around) {
    const Vec3d way = again.ray.direction.to<double>();
    const Vec3d moved =
        way * double{again.hit.t} + (again.ray.origin - narrow.point.position).to<double>();
    if (std::fabs(dot(moved, side)) > kLeavingBounds * double{narrow.point.error}) return false;
    // At a corner either wall is right. Only what lies with the surface, met from behind, is the
    // surface itself.
    const Vec3d met = again.point.geometric_normal.to<double>();
    const double along = dot(met, side);
    const double through = dot(way, met);
    if (std::fabs(along) < kSameSurface || (through < 0) == (along > 0)) return false;
    // Where it would be met from a start a bound away: further off if it is grazed.
    constexpr double kLeastCosine = 1e-4;
    const double later = kLeavingBounds * around.bound / std::max(std::fabs(through), kLeastCosine);
    const auto meets_anything = [&](const Seen<double>& from) {
        Departure<double> next = leave(from.point, way, from.ray.time);
        next.ray.t_max = double{again.hit.t} + later;
        return any_hit(wide_, next.ray, next.exclude, counters_);
    };
    for (const Seen<double>& seen : seen_around(around)) {
        if (seen.hit && meets_anything(seen)) return false;
    }
    const auto same = surface_behind(narrow, around);
    return !same || !meets_anything(*same);
}

/// Of sheets that lie closer than the bound float may see the second: it as double has it, if it is
/// found among the next few.
std::optional<Seen<double>> FloatJudge::surface_behind(const Seen<float>& narrow,
                                                       const Surroundings& around) {
    constexpr int kSheets = 8;
    Seen<double> seen = around.middle;
    for (int i = 0; i < kSheets && seen.hit; ++i) {
        if (seen.hit.object == narrow.hit.object && seen.hit.face == narrow.hit.face) return seen;
        seen.ray.t_min = seen.hit.t;
        seen.hit = closest_hit(wide_, seen.ray, {seen.hit.object, seen.hit.face, false}, counters_);
        if (seen.hit) seen.point = surface_at(wide_, seen.ray, seen.hit);
    }
    return std::nullopt;
}

namespace {

/// Of a ray mapped into an instance in double: it and what it meets are off by some roundings.
constexpr double kMappedRounding = 0x1p-46;

/// The ray and the shape that was hit, as double has it, at the time 0 of all rays here.
template <typename T>
ExactMeeting meet(const ir::Scene& scene, Vec3d origin, Ray<double> ray, const Hit<T>& hit) {
    const ir::Object& object = scene.objects[hit.object.value];
    if (object.kind == ir::ShapeKind::kPlane) {
        return meet_exactly(ray, plane_key(scene, object, 0, origin));
    }
    double rounding = kExactRounding;
    if (object.placement.count > 0) {
        const auto& map = scene.placements[object.placement.first].world_to_object;
        ray.origin = map.point(ray.origin + origin);
        ray.direction = map.vector(ray.direction);
        origin = {};
        rounding = kMappedRounding;
    }
    switch (object.kind) {
        case ir::ShapeKind::kMesh:
            return meet_exactly(
                ray, face_vertices<double>(scene.meshes[object.shape], hit.face, origin), rounding);
        case ir::ShapeKind::kTriangle:
            return meet_exactly(
                ray, narrow_vertices<double>(scene.triangles[object.shape].keys[0], origin),
                rounding);
        case ir::ShapeKind::kSphere:
            return meet_exactly(
                ray, narrow_sphere<double>(scene.spheres[object.shape].keys[0], origin), rounding);
        case ir::ShapeKind::kBox:
            return meet_exactly(ray, narrow_box<double>(scene.boxes[object.shape], origin),
                                rounding);
        case ir::ShapeKind::kPlane:
            break;
    }
    return {};
}

}  // namespace

ExactVerdict FloatJudge::settle(const Seen<float>& narrow, const Seen<double>& wide) const {
    const auto meeting = [&](const auto& hit) {
        return hit ? meet(source_, wide_.origin, wide.ray, hit)
                   : ExactMeeting{Meeting::kMisses, {}};
    };
    const ExactMeeting of_float = meeting(narrow.hit);
    const ExactMeeting of_double = meeting(wide.hit);
    if (of_float.meeting == Meeting::kUnsure || of_double.meeting == Meeting::kUnsure) {
        return ExactVerdict::kOpen;
    }
    if (of_float.meeting != of_double.meeting) {
        return of_float.meeting == Meeting::kMeets ? ExactVerdict::kFloat : ExactVerdict::kDouble;
    }
    if (of_float.meeting == Meeting::kMisses) {
        // Whoever saw nothing is right, unless both saw something that is not there.
        if (!wide.hit) return ExactVerdict::kDouble;
        return narrow.hit ? ExactVerdict::kOpen : ExactVerdict::kFloat;
    }
    // Surfaces that meet in the ray: nothing tells them apart but rounding.
    const bool mapped = source_.objects[narrow.hit.object.value].placement.count > 0 ||
                        source_.objects[wide.hit.object.value].placement.count > 0;
    const double same_place = mapped ? kMappedRounding : kExactRounding;
    const math::DoubleDouble apart = of_float.t - of_double.t;
    if (std::fabs(apart.hi) <= same_place * std::fabs(of_double.t.hi)) return ExactVerdict::kBoth;
    return apart.hi < 0 ? ExactVerdict::kFloat : ExactVerdict::kDouble;
}

}  // namespace cobble::renderer
