// SPDX-License-Identifier: MIT
#include "ir/lower/precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/lower/loss.hpp"
#include "ir/math/elementary.hpp"
#include "ir/math/inverse.hpp"
#include "ir/math/narrow.hpp"
#include "ir/scene/bounds.hpp"
#include "ir/scene/local_origin.hpp"

namespace cobble::ir {
namespace {

using math::BoxBounds;
using math::Vec3d;

// A screenful; a scene of which more is lost has one thing wrong with it.
constexpr std::size_t kMostFindings = 20;
// Of all meshes together: some 50 ms.
constexpr std::size_t kMostFaces = std::size_t{1} << 20;
// Rays at the border of the picture, but not outside it for rounding.
constexpr double kBorder = 0.999;
// Decimals narrowed to double leave flat what is as flat as this, relative to the coordinates: the
// checker's measure of triangles without area.
constexpr double kFlat = 16 * 0x1p-53;

/// How far narrowing moves a point.
Vec3d narrowing(Vec3d p) { return p.to<float>().to<double>() - p; }

class Precision {
  public:
    Precision(const Scene& scene, PictureSize size)
        : scene_(scene),
          size_(size),
          bounds_(scene),
          origin_(local_origin(scene, bounds_)),
          eye_(scene.camera.center - origin_),
          slope_(math::tan(scene.camera.angle / 2)),
          meshes_(static_cast<std::size_t>(std::count_if(
              scene.objects.begin(), scene.objects.end(),
              [](const Object& object) { return object.kind == ShapeKind::kMesh; }))) {}

    std::vector<source::Diagnostic> run() {
        std::vector<source::Diagnostic> found;
        LossWords words(scene_, size_, origin_);
        std::size_t more = 0;
        for (const Object& object : scene_.objects) {
            const Loss loss = measure(object);
            if (!loss.out_of_range && !loss.feature && !loss.place && !loss.flat) continue;
            if (found.size() < kMostFindings) {
                found.push_back(words.describe(object, loss));
            } else {
                ++more;
            }
        }
        if (more > 0) {
            found.back().notes.push_back(fmt::format("float loses {} more object{} of the scene",
                                                     more, more == 1 ? "" : "s"));
        }
        return found;
    }

  private:
    // --- Measuring ---

    Loss measure(const Object& object) {
        Loss loss;
        if (object.kind == ShapeKind::kPlane) {
            plane(object, loss);
            return loss;
        }
        const bool placed = object.placement.count > 0;
        // An instance is reckoned with in its own space.
        const BoxBounds<double> box = placed ? bounds_.shape(object) : bounds_.world(object);
        if (box.empty()) return loss;
        const Vec3d middle = placed ? (box.lo + box.hi) * 0.5 : origin_;
        if (std::max(largest(box.lo - middle), largest(box.hi - middle)) >
            double{math::kLargestCoordinate<float>}) {
            loss.out_of_range = true;
            loss.reach = largest_coordinate(object);
            return loss;
        }
        const Placement place = placed ? scene_.placements[object.placement.first] : Placement{};
        // Told as a transform that is ill-conditioned.
        if (math::condition(place.object_to_world, place.world_to_object) > kWorstCondition) {
            return loss;
        }
        const math::Affined& map = place.object_to_world;
        switch (object.kind) {
            case ShapeKind::kSphere:
                sphere(scene_.spheres[object.shape].keys[0], map, placed, loss);
                break;
            case ShapeKind::kBox:
                this->box(scene_.boxes[object.shape], map, placed, loss);
                break;
            case ShapeKind::kTriangle:
                triangle(scene_.triangles[object.shape].keys[0], map, placed, loss);
                break;
            case ShapeKind::kMesh:
                mesh(scene_.meshes[object.shape], map, placed,
                     placed ? math::grid_origin(box, middle) : origin_, loss);
                break;
            case ShapeKind::kPlane:
                break;
        }
        return loss;
    }

    /// Under a matrix a ray is mapped by numbers of float, which moves all by about a step.
    static double moved_at(double reach, Vec3d narrowed, bool placed) {
        return placed ? double{math::step_at<float>(reach)} : length(narrowed);
    }

    void sphere(const Sphere::Key& key, const math::Affined& map, bool placed, Loss& loss) const {
        const Vec3d center = map.point(key.center) - origin_;
        double thinnest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < 3; ++j) thinnest = std::min(thinnest, length(column(map, j)));
        const double radius = key.radius * thinnest;
        Feature feature{2 * radius, largest(center) + radius, 0};
        feature.moved = moved_at(feature.reach, narrowing(center), placed);
        keep(feature, loss);
        const Vec3d way = eye_ - center;
        const double distance = length(way);
        if (distance > radius) look(center + way * (radius / distance), loss);
    }

    void box(const Box& box, const math::Affined& map, bool placed, Loss& loss) const {
        const Vec3d low = map.point(box.min) - origin_;
        const Vec3d high = map.point(box.max) - origin_;
        for (std::size_t i = 0; i < 3; ++i) {
            // A side along an axis is as good as the coordinates on that axis.
            Feature feature{(box.max[i] - box.min[i]) * length(column(map, i)),
                            std::max(std::fabs(low[i]), std::fabs(high[i])),
                            std::fabs(narrowing(low)[i]) + std::fabs(narrowing(high)[i])};
            if (placed) {
                feature.reach = std::max(largest(low), largest(high));
                feature.moved = moved_at(feature.reach, {}, placed);
            }
            keep(feature, loss);
        }
        for (unsigned i = 0; i < 8; ++i) {
            look(map.point({(i & 1U) != 0 ? box.max.x : box.min.x,
                            (i & 2U) != 0 ? box.max.y : box.min.y,
                            (i & 4U) != 0 ? box.max.z : box.min.z}) -
                     origin_,
                 loss);
        }
        if (placed) return;
        Vec3d near = eye_;
        for (std::size_t i = 0; i < 3; ++i) near[i] = std::clamp(near[i], low[i], high[i]);
        look(near, loss);
    }

    void triangle(std::array<Vec3d, 3> v, const math::Affined& map, bool placed, Loss& loss) const {
        Feature feature;
        double size = 0;
        for (Vec3d& p : v) {
            p = map.point(p);
            size = std::max(size, largest(p));
            p = p - origin_;
            feature.reach = std::max(feature.reach, largest(p));
        }
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, length(v[(i + 1) % 3] - v[i]));
            feature.moved =
                std::max(feature.moved, moved_at(feature.reach, narrowing(v[i]), placed));
            look(v[i], loss);
        }
        look((v[0] + v[1] + v[2]) / 3.0, loss);
        const double area = length(cross(v[1] - v[0], v[2] - v[0]));
        // Without an area there is nothing to lose, and others tell of it.
        if (!(area > kFlat * (size * longest))) return;
        feature.width = area / longest;
        keep(feature, loss);
    }

    /// `origin`: what the mesh itself is narrowed relative to.
    void mesh(const Mesh& mesh, const math::Affined& map, bool placed, Vec3d origin,
              Loss& loss) const {
        const std::size_t share = std::max<std::size_t>(8, kMostFaces / meshes_);
        const std::size_t stride = (mesh.faces.size() + share - 1) / share;
        std::optional<Feature> worst;
        for (std::size_t f = 0; f < mesh.faces.size(); f += stride) {
            const auto& c = mesh.faces[f].corners;
            const std::array<Vec3d, 3> v{mesh.positions[c[0].position],
                                         mesh.positions[c[1].position],
                                         mesh.positions[c[2].position]};
            Loss of_face;
            of_face.place = loss.place;
            triangle(v, map, placed, of_face);
            loss.place = of_face.place;
            ++loss.faces;
            if (flattened(v, origin)) {
                if (loss.flat_faces++ == 0) loss.flat_at = mesh.face_offsets[f];
                const Feature feature = flat_feature(v, origin);
                if (!loss.flat || feature.width > loss.flat->width) loss.flat = feature;
            }
            if (!of_face.feature) continue;
            ++loss.lost_faces;
            if (!worst || of_face.feature->lost() > worst->lost()) worst = of_face.feature;
        }
        // Slivers are common in meshes, and little is lost with them.
        if (2 * loss.lost_faces >= loss.faces) loss.feature = worst;
    }

    /// Has an area, and none once it is narrowed.
    static bool flattened(const std::array<Vec3d, 3>& v, Vec3d origin) {
        std::array<Vec3d, 3> n;
        for (std::size_t i = 0; i < 3; ++i) n[i] = (v[i] - origin).to<float>().to<double>();
        return cross(n[1] - n[0], n[2] - n[0]) == Vec3d{} && has_area(v[0], v[1], v[2]);
    }

    static Feature flat_feature(const std::array<Vec3d, 3>& v, Vec3d origin) {
        Feature feature;
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, length(v[(i + 1) % 3] - v[i]));
            feature.reach = std::max(feature.reach, largest(v[i] - origin));
        }
        feature.width = length(cross(v[1] - v[0], v[2] - v[0])) / longest;
        return feature;
    }

    /// Planes have no width to lose; the nearest that is seen of one is its foot or at the border.
    void plane(const Object& object, Loss& loss) const {
        const Plane& plane = scene_.planes[object.shape];
        const bool placed = object.placement.count > 0;
        const auto map =
            placed ? scene_.placements[object.placement.first].world_to_object : math::Affined{};
        const Camera& camera = scene_.camera;
        const Vec3d normal = map.transposed_vector(plane.normal);
        const double height = dot(plane.normal, map.point(camera.center)) - plane.offset;
        const auto meet = [&](Vec3d direction) {
            const double t = -height / dot(normal, direction);
            if (t > 0 && t < double{math::kLargestCoordinate<float>}) {
                look(eye_ + direction * t, loss);
            }
        };
        meet(normal * (height > 0 ? -1.0 : 1.0));
        const Vec3d up = camera.up * (slope_ * kBorder);
        const Vec3d right = camera.right * (slope_ * form() * kBorder);
        for (const double y : {-1.0, 0.0, 1.0}) {
            for (const double x : {-1.0, 0.0, 1.0}) {
                meet((camera.forward + up * y) + right * x);
            }
        }
    }

    [[nodiscard]] double form() const { return static_cast<double>(size_.width) / size_.height; }

    static Vec3d column(const math::Affined& map, std::size_t j) {
        return {map.rows[0][j], map.rows[1][j], map.rows[2][j]};
    }

    static void keep(const Feature& feature, Loss& loss) {
        if (!(feature.lost() >= kLostShare)) return;
        if (!loss.feature || feature.lost() > loss.feature->lost()) loss.feature = feature;
    }

    /// Keeps the place with the fewest steps a pixel, if that is less than one.
    void look(Vec3d p, Loss& loss) const {
        const Vec3d way = p - eye_;
        const double depth = dot(way, scene_.camera.forward);
        if (!(depth > 0) || !(std::fabs(dot(way, scene_.camera.up)) <= depth * slope_) ||
            !(std::fabs(dot(way, scene_.camera.right)) <= depth * slope_ * form())) {
            return;
        }
        const double here = largest(p);
        const double camera = largest(eye_);
        const Place place{length(way) * (2 * slope_ / static_cast<double>(size_.height)),
                          std::max(here, camera), camera > here};
        if (!(place.steps() < 1)) return;
        if (!loss.place || place.steps() < loss.place->steps()) loss.place = place;
    }

    double largest_coordinate(const Object& object) {
        const BoxBounds<double> box = bounds_.world(object);
        return std::max(largest(box.lo), largest(box.hi));
    }

    const Scene& scene_;
    PictureSize size_;
    SceneBounds bounds_;
    Vec3d origin_;
    Vec3d eye_;  ///< local
    double slope_;
    std::size_t meshes_;
};

}  // namespace

std::vector<source::Diagnostic> precision_findings(const Scene& scene, PictureSize size) {
    if (scene.objects.empty()) return {};
    return Precision(scene, size).run();
}

}  // namespace cobble::ir
