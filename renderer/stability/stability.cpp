// SPDX-License-Identifier: MIT
#include "renderer/stability/stability.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ir/math/elementary.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/job/fp_environment.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/stability/aim.hpp"
#include "renderer/stability/random.hpp"
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
constexpr std::uint32_t kDepartures = 4;
// Surfaces that touch at less than 8 degrees lie with each other.
constexpr double kSameSurface = 0.99;
// Rays around one, to find the outline of something that is near it.
constexpr std::uint32_t kRing = 16;

double sum_of(Vec3d a) { return (std::fabs(a.x) + std::fabs(a.y)) + std::fabs(a.z); }

/// The way from x to the next float that is larger in size.
double ulp_at(double x) {
    const float size = std::fabs(static_cast<float>(x));
    return double{std::nextafter(size, std::numeric_limits<float>::infinity())} - double{size};
}

template <typename T>
struct Seen {
    Ray<T> ray;
    Hit<T> hit;
    SurfacePoint<T> point;  ///< if hit

    /// Infinite for nothing.
    [[nodiscard]] double t() const { return hit ? double{hit.t} : kInfinity; }
};

/// What double sees around a ray, to be looked at only where float and double differ.
struct Surroundings {
    const Seen<double>& middle;
    double bound;                    ///< world units
    std::vector<Seen<double>> seen;  ///< empty until asked for
};

class Measurement {
  public:
    Measurement(const ir::Scene& scene, const StabilityOptions& options)
        : source_(scene),
          options_(options),
          narrow_(prepare<float>(scene, {Acceleration::kBvh, false, nullptr})),
          wide_(prepare<double>(scene, {Acceleration::kBvh, false, nullptr})),
          eye_(narrow_.to_local(scene.camera.center)),
          // Square pixels; the angle spans the height.
          pixel_(2 * math::tan(scene.camera.angle / 2) / options.height) {}

    Stability run() {
        const std::uint64_t count = source_.objects.size();
        result_.objects.resize(count);
        const std::uint64_t most = options_.rays / kLargestShare + 1;
        for (std::uint64_t i = 0; i < count; ++i) {
            const ir::ObjectId id{static_cast<std::uint32_t>(i)};
            result_.objects[i].object = id;
            const std::uint64_t share = share_until(i + 1) - share_until(i);
            aim_at(id, static_cast<std::uint32_t>(std::min(share, most)));
        }
        const auto rank = [](const ObjectStability& o) {
            return std::tuple(~o.faults(), o.least_ulps, o.object);
        };
        std::sort(result_.objects.begin(), result_.objects.end(),
                  [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
        result_.notes = narrow_.notes;
        return std::move(result_);
    }

  private:
    /// Of the rays, those that the first `objects` get: in whole numbers, evenly.
    [[nodiscard]] std::uint64_t share_until(std::uint64_t objects) const {
        const std::uint64_t count = source_.objects.size();
        return options_.rays / count * objects + options_.rays % count * objects / count;
    }

    void aim_at(ir::ObjectId id, std::uint32_t rays) {
        const AimPoints points(source_, id, source_.camera.center);
        for (std::uint32_t i = 0; i < rays; ++i) {
            Seen<float> narrow;
            narrow.ray.origin = eye_;
            // Not made unit: so a ray at a vertex meets it as exactly as float can say.
            narrow.ray.direction = narrow_.to_local(points.point(i)) - eye_;
            const Vec3d way = narrow.ray.direction.to<double>();
            if (!finite(way) || way == Vec3d{}) continue;
            ++result_.rays;
            ++result_.objects[id.value].rays;
            compare(narrow, Choices(~std::uint64_t{id.value}, i));
        }
    }

    Hit<float> cast(const Ray<float>& ray, const Exclude& exclude) {
        if (options_.cast) return options_.cast(narrow_, ray, exclude);
        return closest_hit(narrow_, ray, exclude, counters_);
    }

    template <typename T>
    void look(const PreparedScene<T>& scene, Seen<T>& seen) {
        if constexpr (std::is_same_v<T, float>) {
            seen.hit = cast(seen.ray, {});
        } else {
            seen.hit = closest_hit(scene, seen.ray, {}, counters_);
        }
        if (seen.hit) seen.point = surface_at(scene, seen.ray, seen.hit);
    }

    void compare(Seen<float>& narrow, Choices choices) {
        look(narrow_, narrow);
        Seen<double> wide;
        wide.ray.origin = narrow.ray.origin.to<double>();
        wide.ray.direction = narrow.ray.direction.to<double>();
        look(wide_, wide);
        if (narrow.hit) {
            ObjectStability& object = result_.objects[narrow.hit.object.value];
            ++object.hits;
            object.least_ulps = std::min(object.least_ulps, ulps_at(narrow));
        }
        if (!narrow.hit && !wide.hit) return;
        // Whether float is right depends on the outline of what is in front.
        const double bound = narrow.t() < wide.t() ? bound_of(narrow) : bound_of(wide);
        if (!(bound <= std::numeric_limits<double>::max())) return;
        // The bound is across the surface: along a ray that grazes it, it is longer.
        const double cosine = narrow.t() < wide.t() ? cosine_of(narrow) : cosine_of(wide);
        const double slack = cosine > 0 ? bound / (length(wide.ray.direction) * cosine) : kInfinity;
        Surroundings around{wide, bound, {}};
        const bool agree = std::fabs(narrow.t() - wide.t()) <= slack;
        if (!agree && narrow.t() > farthest(around) + slack) {
            ++result_.objects[wide.hit.object.value].cracks;
            keep_example(StabilityFault::kCrack, wide);
        } else if (!agree && narrow.t() < nearest(around) - slack) {
            ++result_.objects[narrow.hit.object.value].changed;
            keep_example(StabilityFault::kChanged, narrow);
        } else if (narrow.hit) {
            leave_it(narrow, around, choices);
        }
    }

    /// World units: how far off a float hit here may be from where double sees it.
    template <typename T>
    [[nodiscard]] double bound_of(const Seen<T>& seen) const {
        const Vec3d origin = seen.ray.origin.template to<double>();
        const double way = length(seen.ray.direction.template to<double>()) * double{seen.hit.t};
        const double reach = reach_of(source_, narrow_.origin, seen.hit.object, seen.hit.face);
        // The point's own bound grows with the rounding of its type.
        const double own = double{seen.point.error} *
                           (kFloatRounding / (double{std::numeric_limits<T>::epsilon()} / 2));
        return kBound * (sum_of(origin) + way + reach) + kLeavingBounds * own;
    }

    /// Of the angle between the ray and the surface's normal; 0 at a silhouette.
    template <typename T>
    static double cosine_of(const Seen<T>& seen) {
        return std::fabs(dot(seen.point.geometric_normal.template to<double>(),
                             normalize(seen.ray.direction.template to<double>())));
    }

    /// What double sees along the ray and along those around it.
    const std::vector<Seen<double>>& seen_around(Surroundings& around) {
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
            look(wide_, seen);
        }
        return around.seen;
    }

    double nearest(Surroundings& around) {
        double t = kInfinity;
        for (const Seen<double>& seen : seen_around(around)) t = std::min(t, seen.t());
        return t;
    }

    double farthest(Surroundings& around) {
        double t = 0;
        for (const Seen<double>& seen : seen_around(around)) t = std::max(t, seen.t());
        return t;
    }

    /// Sends rays on from a hit, to the side it was seen from, and counts those that meet the
    /// surface they start on.
    void leave_it(const Seen<float>& narrow, Surroundings& around, Choices choices) {
        const Vec3d normal = narrow.point.geometric_normal.to<double>();
        const Vec3d way = normalize(narrow.ray.direction.to<double>());
        const Vec3d side = dot(normal, way) > 0 ? -normal : normal;
        const double near = kLeavingBounds * double{narrow.point.error};
        for (std::uint32_t k = 0; k < kDepartures; ++k) {
            Vec3d direction = choices.direction();
            if (k == 0) direction = way - side * (2 * dot(side, way));  // the mirror's
            // Every other one grazes, the steepest by a half, the flattest by 2^-12.
            if (k == 2) direction = direction - side * dot(side, direction);
            if (k == 2) {
                direction = normalize(direction) +
                            side * std::ldexp(1.0, -1 - static_cast<int>(choices.below(12)));
            }
            if (dot(direction, side) < 0) direction = -direction;
            const Departure<float> next =
                leave(narrow.point, normalize(direction).to<float>(), narrow.ray.time);
            const Hit<float> again = cast(next.ray, next.exclude);
            if (!again) continue;
            const Vec3d moved = next.ray.direction.to<double>() * double{again.t} +
                                (next.ray.origin - narrow.point.position).to<double>();
            if (std::fabs(dot(moved, normal)) > near) continue;
            // At a corner either wall is right. Only what lies with the surface, met from behind,
            // is the surface itself.
            const Vec3d met = surface_at(narrow_, next.ray, again).geometric_normal.to<double>();
            const double along = dot(met, side);
            const double through = dot(next.ray.direction.to<double>(), met);
            if (std::fabs(along) < kSameSurface || (through < 0) == (along > 0)) continue;
            // Where it would be met from a start a bound away: further off if it is grazed.
            constexpr double kLeastCosine = 1e-4;
            const double later =
                kLeavingBounds * around.bound / std::max(std::fabs(through), kLeastCosine);
            if (meets_in_double(around, next.ray, double{again.t} + later)) continue;
            ++result_.objects[narrow.hit.object.value].self_hits;
            keep_example(StabilityFault::kSelfHit, narrow);
        }
    }

    /// Whether one of the rays that leave what double saw, the same way, meets anything by t.
    bool meets_in_double(Surroundings& around, const Ray<float>& ray, double t) {
        for (const Seen<double>& seen : seen_around(around)) {
            if (!seen.hit) continue;
            Departure<double> next = leave(seen.point, ray.direction.to<double>(), seen.ray.time);
            next.ray.t_max = t;
            if (any_hit(wide_, next.ray, next.exclude, counters_)) return true;
        }
        return false;
    }

    [[nodiscard]] double ulps_at(const Seen<float>& seen) const {
        const Vec3d position = seen.point.position.to<double>();
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            largest = std::max({largest, std::fabs(position[i]), std::fabs(double{eye_[i]})});
        }
        return length(position - eye_.to<double>()) * pixel_ / ulp_at(largest);
    }

    template <typename T>
    void keep_example(StabilityFault fault, const Seen<T>& seen) {
        ObjectStability& object = result_.objects[seen.hit.object.value];
        if (object.example) return;
        const Vec3d local = seen.point.position.template to<double>();
        object.example = {fault, local + narrow_.origin, seen.hit.face};
    }

    const ir::Scene& source_;
    StabilityOptions options_;
    PreparedScene<float> narrow_;
    PreparedScene<double> wide_;
    math::Vec3f eye_;
    double pixel_;  ///< wide at distance 1
    Counters counters_;
    Stability result_;
};

}  // namespace

bool Stability::clean() const {
    return std::all_of(objects.begin(), objects.end(),
                       [](const ObjectStability& object) { return object.faults() == 0; });
}

Stability measure_stability(const ir::Scene& scene, const StabilityOptions& options) {
    const FpEnvironment environment;
    return Measurement(scene, options).run();
}

}  // namespace cobble::renderer
