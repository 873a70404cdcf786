// SPDX-License-Identifier: MIT
#include "renderer/stability/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ir/math/elementary.hpp"
#include "ir/math/narrow.hpp"
#include "renderer/camera/camera.hpp"
#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/job/fp_environment.hpp"
#include "renderer/stability/aim.hpp"
#include "renderer/stability/flattened.hpp"
#include "renderer/stability/judge.hpp"
#include "renderer/stability/random.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;

// Rays that are cast together: a packet or a few.
constexpr std::uint32_t kBatch = 64;
// Through the picture: enough to meet what fills a thousandth of it.
constexpr std::uint32_t kColumns = 64;
constexpr std::uint32_t kRows = 48;
// Rays that leave each hit.
constexpr std::uint32_t kDepartures = 4;
// Of a pixel: what covers less cannot be seen.
constexpr double kLeastSeen = 1e-3;
// Meshes of more faces get no outline: the sort would take longer than all rays.
constexpr std::size_t kMostFaces = std::size_t{1} << 21;

/// A ray to be cast and judged.
struct Aim {
    math::Vec3f direction;  ///< from the camera
    Choices choices;        ///< of the rays that leave what it hits
};

class Measurement {
  public:
    Measurement(const ir::Scene& scene, const StabilityOptions& options)
        : source_(scene),
          options_(options),
          narrow_(prepare<float>(scene, {options.acceleration, false, {}})),
          wide_(prepare<double>(scene, {options.acceleration, false, {}})),
          judge_(scene, wide_),
          eye_(narrow_.to_local(scene.camera.center)),
          // Square pixels; the angle spans the height.
          pixel_(2 * math::tan(scene.camera.angle / 2) / options.height),
          edges_(scene.meshes.size()) {}

    Stability run() {
        const auto count = static_cast<std::uint32_t>(source_.objects.size());
        result_.objects.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) result_.objects[i].object = {i};
        cast_all(count);
        for (ObjectStability& entry : result_.objects) {
            const MeshEdges* edges = edges_of(source_.objects[entry.object.value]);
            entry.closed = edges != nullptr && edges->closed();
        }
        count_faces();
        const auto rank = [](const ObjectStability& o) {
            return std::tuple(~o.faults(), o.least_ulps(), o.object);
        };
        std::sort(result_.objects.begin(), result_.objects.end(),
                  [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
        result_.notes = narrow_.notes;
        return std::move(result_);
    }

  private:
    void cast_all(std::uint32_t count) {
        for (std::uint32_t row = 0; row < kRows; ++row) {
            if (!step(0.1 * row / kRows)) return;
            look_through_picture(row);
        }
        // A few rays for each object in turn, so that no object waits long for its first.
        std::uint64_t total = 0;
        for (std::uint32_t i = 0; i < count; ++i) total += share_of(i);
        std::uint64_t done = 0;
        for (std::uint32_t first = 0; done < total; first += kBatch) {
            for (std::uint32_t i = 0; i < count; ++i) {
                const std::uint32_t share = share_of(i);
                if (share <= first) continue;
                const std::uint32_t part = std::min(kBatch, share - first);
                if (!step(0.1 + 0.9 * static_cast<double>(done) / static_cast<double>(total))) {
                    return;
                }
                aim_at({i}, first, part);
                done += part;
            }
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            if (result_.objects[i].hits > 0) continue;
            if (!step(1)) return;
            look_for_lost({i});
        }
    }

    /// False if that is enough.
    bool step(double fraction) {
        const std::uint64_t rays = result_.rays + result_.picture_rays + result_.departures;
        if (options_.go_on && !options_.go_on(fraction, rays)) result_.complete = false;
        return result_.complete;
    }

    /// In whole numbers, evenly.
    [[nodiscard]] std::uint32_t share_of(std::uint32_t object) const {
        const std::uint64_t count = source_.objects.size();
        const auto until = [&](std::uint64_t objects) {
            return options_.rays / count * objects + options_.rays % count * objects / count;
        };
        const std::uint64_t share = until(object + std::uint64_t{1}) - until(object);
        return static_cast<std::uint32_t>(std::min(share, options_.rays / kLargestShare + 1));
    }

    void look_through_picture(std::uint32_t row) {
        const PreparedCamera camera(source_.camera, options_.width, options_.height);
        std::vector<Aim> aims;
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const double x = (column + 0.5) / kColumns * options_.width;
            const double y = (row + 0.5) / kRows * options_.height;
            aims.push_back({camera.pinhole(x, y).direction.to<float>(),
                            Choices(~std::uint64_t{0}, row * kColumns + column)});
        }
        result_.picture_rays += aims.size();
        judge(aims, true);
    }

    void aim_at(ir::ObjectId id, std::uint32_t first, std::uint32_t count) {
        const AimPoints points(source_, id, source_.camera.center,
                               edges_of(source_.objects[id.value]));
        std::vector<Aim> aims;
        for (std::uint32_t i = first; i < first + count; ++i) {
            // Not made unit: so a ray at a vertex meets it as exactly as float can say.
            const math::Vec3f direction = narrow_.to_local(points.point(i)) - eye_;
            const Vec3d way = direction.to<double>();
            if (!finite(way) || way == Vec3d{}) continue;
            aims.push_back({direction, Choices(~std::uint64_t{id.value}, i)});
        }
        result_.rays += aims.size();
        result_.objects[id.value].rays += aims.size();
        judge(aims, false);
    }

    /// What float sees along no ray is hidden or lost: it is lost if double sees a face of it where
    /// the camera and the face are. Float was aimed at the same points, and narrowing, which moved
    /// both, may have left nothing to be seen: that is what rounding does, and no excuse.
    void look_for_lost(ir::ObjectId id) {
        const AimPoints points(source_, id, source_.camera.center, nullptr);
        const Vec3d eye = wide_.to_local(source_.camera.center);
        const std::uint32_t share = share_of(id.value);
        for (std::uint32_t i = 0; i < share; ++i) {
            if (!AimPoints::is_inner(i)) continue;
            Seen<double> seen;
            seen.ray.origin = eye;
            seen.ray.direction = wide_.to_local(points.point(i)) - eye;
            if (!finite(seen.ray.direction) || seen.ray.direction == Vec3d{}) continue;
            seen.hit = closest_hit(wide_, seen.ray, {}, counters_);
            if (!seen.hit || seen.hit.object != id) continue;
            const bool first = result_.objects[id.value].lost == 0;
            if (first && object_pixels(source_, id, pixel_) < kLeastSeen) return;
            seen.point = surface_at(wide_, seen.ray, seen.hit);
            ++result_.objects[id.value].lost;
            keep_example(StabilityFault::kLost, seen);
        }
    }

    void count_faces() {
        using Kind = PreparationNote::Kind;
        for (ObjectStability& entry : result_.objects) {
            const ir::Object& object = source_.objects[entry.object.value];
            if (object.kind != ir::ShapeKind::kMesh) continue;
            entry.faces = source_.meshes[object.shape].faces.size();
        }
        for (const PreparationNote& note : narrow_.notes) {
            ObjectStability& entry = result_.objects[note.object.value];
            const bool flattened = note.kind == Kind::kFlattened;
            if (note.kind == Kind::kSingular) entry.faces_lost = entry.faces;
            if (note.kind == Kind::kOutOfRange ||
                (flattened && flattened_pixels(narrow_, source_, note, pixel_) > kLeastSeen)) {
                entry.faces_lost += note.count;
            }
        }
    }

    /// Nothing for what is no mesh, or too large a one.
    const MeshEdges* edges_of(const ir::Object& object) {
        if (object.kind != ir::ShapeKind::kMesh) return nullptr;
        const ir::Mesh& mesh = source_.meshes[object.shape];
        if (mesh.faces.size() > kMostFaces) return nullptr;
        auto& edges = edges_[object.shape];
        if (edges == nullptr) edges = std::make_unique<MeshEdges>(mesh);
        return edges.get();
    }

    /// What float sees, by the kernels that render; `coherent` rays go as packets.
    void look(std::vector<Seen<float>>& seen, const std::vector<Exclude>& excludes,
              Coherence coherence) {
        std::vector<Ray<float>> rays;
        rays.reserve(seen.size());
        for (const auto& entry : seen) rays.push_back(entry.ray);
        std::vector<Hit<float>> hits(rays.size());
        if (options_.cast) {
            options_.cast(narrow_, rays, excludes, hits);
        } else {
            closest_hits<float>(narrow_, rays, excludes, hits, counters_, coherence);
        }
        for (std::size_t i = 0; i < seen.size(); ++i) {
            seen[i].hit = hits[i];
            if (hits[i]) seen[i].point = surface_at(narrow_, rays[i], hits[i]);
        }
    }

    void judge(const std::vector<Aim>& aims, bool picture) {
        std::vector<Seen<float>> narrow(aims.size());
        for (std::size_t i = 0; i < aims.size(); ++i) {
            narrow[i].ray.origin = eye_;
            narrow[i].ray.direction = aims[i].direction;
        }
        look(narrow, std::vector<Exclude>(aims.size()), Coherence::kCoherent);
        std::vector<Leaving> leaving;
        for (std::size_t i = 0; i < aims.size(); ++i) {
            Leaving next{narrow[i], {}, aims[i].choices, {}};
            Seen<double>& wide = next.around.middle;
            wide.ray.origin = narrow[i].ray.origin.to<double>();
            wide.ray.direction = narrow[i].ray.direction.to<double>();
            wide.hit = closest_hit(wide_, wide.ray, {}, counters_);
            if (wide.hit) wide.point = surface_at(wide_, wide.ray, wide.hit);
            if (narrow[i].hit) measure(narrow[i], picture);
            count_change(narrow[i], wide);
            switch (judge_.judge(narrow[i], next.around)) {
                case FloatVerdict::kCrack:
                    ++result_.objects[wide.hit.object.value].cracks;
                    keep_example(StabilityFault::kCrack, wide);
                    break;
                case FloatVerdict::kChanged:
                    ++result_.objects[narrow[i].hit.object.value].changed;
                    keep_example(StabilityFault::kChanged, narrow[i]);
                    break;
                case FloatVerdict::kRight:
                    if (narrow[i].hit) leaving.push_back(std::move(next));
                    break;
                case FloatVerdict::kUnknown:
                    break;
            }
        }
        leave_all(leaving);
    }

    void count_change(const Seen<float>& narrow, const Seen<double>& wide) {
        if (narrow.hit.object == wide.hit.object &&
            (!narrow.hit || narrow.hit.face == wide.hit.face)) {
            return;
        }
        ++result_.changes.rays;
        switch (judge_.settle(narrow, wide)) {
            case ExactVerdict::kDouble:
                ++result_.changes.for_double;
                break;
            case ExactVerdict::kFloat:
                ++result_.changes.for_float;
                break;
            case ExactVerdict::kBoth:
                ++result_.changes.for_both;
                break;
            case ExactVerdict::kOpen:
                ++result_.changes.open;
                break;
        }
    }

    /// A float hit that is right, from which rays are sent on.
    struct Leaving {
        Seen<float> from;
        Surroundings around;
        Choices choices;
        Vec3d side;  ///< the surface's normal, toward the camera
    };

    /// Sends rays on from each hit, to the side it was seen from, and counts those that meet the
    /// surface they start on.
    void leave_all(std::vector<Leaving>& leaving) {
        std::vector<Seen<float>> next(leaving.size() * kDepartures);
        std::vector<Exclude> excludes(next.size());
        for (std::size_t i = 0; i < leaving.size(); ++i) {
            Leaving& start = leaving[i];
            const Vec3d normal = start.from.point.geometric_normal.to<double>();
            const Vec3d way = normalize(start.from.ray.direction.to<double>());
            start.side = dot(normal, way) > 0 ? -normal : normal;
            for (std::uint32_t k = 0; k < kDepartures; ++k) {
                const Vec3d direction = direction_of(k, way, start.side, start.choices);
                Departure<float> departure =
                    leave(start.from.point, direction.to<float>(), start.from.ray.time);
                // At a horizon the mirror's direction may be rounded to below it, and the ray goes
                // through what it shall leave: straight up, then.
                if (departure.exclude.goes_inside != (dot(start.side, normal) < 0)) {
                    departure =
                        leave(start.from.point, start.side.to<float>(), start.from.ray.time);
                }
                next[i * kDepartures + k].ray = departure.ray;
                excludes[i * kDepartures + k] = departure.exclude;
            }
        }
        look(next, excludes, Coherence::kNone);
        result_.departures += next.size();
        for (std::size_t j = 0; j < next.size(); ++j) {
            if (!next[j].hit) continue;
            Leaving& start = leaving[j / kDepartures];
            if (!judge_.is_self_hit(start.from, start.side, next[j], start.around)) continue;
            ++result_.objects[start.from.hit.object.value].self_hits;
            keep_example(StabilityFault::kSelfHit, start.from);
        }
    }

    /// Of the k-th ray that leaves a surface seen along `way`: the mirror's, any, one that grazes.
    static Vec3d direction_of(std::uint32_t k, Vec3d way, Vec3d side, Choices& choices) {
        Vec3d direction = choices.direction();
        if (k == 0) direction = way - side * (2 * dot(side, way));
        if (k == 2) {
            // The steepest by a half, the flattest by 2^-12.
            direction = normalize(direction - side * dot(side, direction)) +
                        side * std::ldexp(1.0, -1 - static_cast<int>(choices.below(12)));
        }
        if (dot(direction, side) < 0) direction = -direction;
        return normalize(direction);
    }

    void measure(const Seen<float>& seen, bool picture) {
        const Vec3d position = seen.point.position.to<double>();
        const Vec3d eye = eye_.to<double>();
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            largest = std::max({largest, std::fabs(position[i]), std::fabs(eye[i])});
        }
        PixelPrecision at;
        at.distance = length(position - eye);
        at.pixel = at.distance * pixel_;
        at.step = double{math::step_at<float>(largest)};
        at.position = position + narrow_.origin;
        at.object = seen.hit.object;
        ObjectStability& object = result_.objects[at.object.value];
        ++object.hits;
        for (auto* worst : {&object.worst, &result_.worst}) {
            if (!*worst || at.ulps() < (*worst)->ulps()) *worst = at;
        }
        if (!picture) return;
        auto& nearest = result_.nearest;
        auto& farthest = result_.farthest;
        if (!nearest || at.distance < nearest->distance) nearest = at;
        if (!farthest || at.distance > farthest->distance) farthest = at;
    }

    template <typename T>
    void keep_example(StabilityFault fault, const Seen<T>& seen) {
        ObjectStability& object = result_.objects[seen.hit.object.value];
        if (object.example) return;
        const Vec3d local = seen.point.position.template to<double>();
        const Vec3d origin = std::is_same_v<T, float> ? narrow_.origin : wide_.origin;
        object.example = {fault, local + origin, seen.hit.face};
    }

    const ir::Scene& source_;
    StabilityOptions options_;
    PreparedScene<float> narrow_;
    PreparedScene<double> wide_;
    FloatJudge judge_;
    math::Vec3f eye_;
    double pixel_;                                   ///< wide at distance 1
    std::vector<std::unique_ptr<MeshEdges>> edges_;  ///< by mesh; made when asked for
    Counters counters_;
    Stability result_;
};

}  // namespace

bool Stability::clean() const {
    return std::all_of(objects.begin(), objects.end(),
                       [](const ObjectStability& object) { return object.sound(); });
}

Stability measure_stability(const ir::Scene& scene, const StabilityOptions& options) {
    const FpEnvironment environment;
    return Measurement(scene, options).run();
}

}  // namespace cobble::renderer
