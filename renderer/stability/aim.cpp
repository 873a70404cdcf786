// SPDX-License-Identifier: MIT
#include "renderer/stability/aim.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "renderer/scene/shape_bounds.hpp"
#include "renderer/stability/random.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;

enum class Feature : std::uint8_t { kVertex, kEdge, kFace, kOutline };
constexpr std::uint32_t kFeatures = 4;
// Of a round mesh of a million faces every five-hundredth edge is on the outline: many are found.
constexpr int kOutlineTries = 256;

Vec3d on_triangle(const std::array<Vec3d, 3>& v, Feature feature, Choices& choices) {
    const std::size_t corner = choices.below(3);
    const Vec3d a = v[corner];
    if (feature == Feature::kVertex) return a;
    const Vec3d b = v[(corner + 1) % 3];
    const Vec3d on_edge = math::lerp(a, b, choices.unit());
    if (feature != Feature::kFace) return on_edge;
    return math::lerp(v[(corner + 2) % 3], on_edge, std::sqrt(choices.unit()));
}

/// `eye` is above the side of the triangle from which its corners run counter-clockwise.
bool shows_front(const std::array<Vec3d, 3>& v, Vec3d eye) {
    return dot(cross(v[1] - v[0], v[2] - v[0]), eye - v[0]) > 0;
}

/// A point of an edge between a front and a back; of any edge if none is found in time.
Vec3d on_outline(const ir::Mesh& mesh, const MeshEdges& edges, Vec3d eye, Choices& choices) {
    std::array<Vec3d, 2> ends;
    for (int i = 0; i < kOutlineTries; ++i) {
        const std::uint32_t face = choices.below(mesh.faces.size());
        const std::uint32_t corner = choices.below(3);
        const auto v = face_vertices<double>(mesh, face, {});
        ends = {v[corner], v[(corner + 1) % 3]};
        const std::uint32_t other = edges.across(face, corner);
        if (other == MeshEdges::kNone) continue;
        if (shows_front(v, eye) != shows_front(face_vertices<double>(mesh, other, {}), eye)) break;
    }
    return math::lerp(ends[0], ends[1], choices.unit());
}

Vec3d on_box(const ir::Box& box, Feature feature, Choices& choices) {
    // So many coordinates are at an end: three at a vertex, two on an edge, one on a face.
    const std::size_t inner = feature == Feature::kVertex ? 0 : feature == Feature::kFace ? 2 : 1;
    const std::size_t first = choices.below(3);
    Vec3d p;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t axis = (first + k) % 3;
        const double f = k < inner ? choices.unit() : choices.below(2);
        // Either end is met exactly.
        p[axis] = f == 1 ? box.max[axis] : math::lerp(box.min[axis], box.max[axis], f);
    }
    return p;
}

/// Two unit vectors at right angles to a unit one and to each other.
std::array<Vec3d, 2> across(Vec3d n) {
    const Vec3d other = std::fabs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = normalize(cross(other, n));
    return {u, cross(n, u)};
}

/// `eye` in the sphere's own space: maps keep what is on the outline.
Vec3d on_sphere(const ir::Sphere::Key& sphere, Vec3d eye, Feature feature, Choices& choices) {
    const Vec3d out = eye - sphere.center;
    const double distance = length(out);
    const double r = sphere.radius;
    const bool outside = distance > r;
    if (!outside || feature == Feature::kFace) return sphere.center + choices.direction() * r;
    // Points that see the eye have a cosine to the axis of at least r / distance, the outline's.
    const double least = r / distance;
    double cosine = math::lerp(least, 1.0, choices.unit());
    if (feature != Feature::kEdge) {
        // 2^-4 to 2^-23 of the way inwards: down to where float still tells it from the outline.
        const double inwards = std::ldexp(1.0, -4 - static_cast<int>(choices.below(20)));
        cosine = math::lerp(least, 1.0, inwards);
    }
    const Vec3d axis = out / distance;
    const auto [u, v] = across(axis);
    const math::SinCos turn = math::sincos(2 * math::kPi * choices.unit());
    const double sine = std::sqrt(cosine < 1 ? 1 - cosine * cosine : 0);
    return sphere.center + (axis * cosine + (u * turn.cos + v * turn.sin) * sine) * r;
}

Vec3d on_plane(const PlaneKey& plane, Vec3d eye, Choices& choices) {
    const double size = dot(plane.normal, plane.normal);
    const double height = (dot(plane.normal, eye) - plane.offset) / size;
    const Vec3d foot = eye - plane.normal * height;
    const auto [u, v] = across(normalize(plane.normal));
    // From right below to where the plane is seen at 2^-14, some pixels from the horizon.
    // Drawn one by one: compilers differ in which argument of a call they evaluate first.
    const int doublings = static_cast<int>(choices.below(16)) - 2;
    const double away = std::ldexp(1 + choices.unit(), doublings);
    const math::SinCos turn = math::sincos(2 * math::kPi * choices.unit());
    const double unit = std::fabs(height) * std::sqrt(size);
    return foot + (u * turn.cos + v * turn.sin) * (away * (unit > 0 ? unit : 1));
}

}  // namespace

AimPoints::AimPoints(const ir::Scene& scene, ir::ObjectId object, Vec3d eye, const MeshEdges* edges)
    : scene_(&scene), id_(object), eye_(eye), edges_(edges) {}

bool AimPoints::is_inner(std::uint32_t i) {
    return static_cast<Feature>(i % kFeatures) == Feature::kFace;
}

Vec3d AimPoints::point(std::uint32_t i) const {
    Choices choices(id_.value, i);
    const auto feature = static_cast<Feature>(i % kFeatures);
    const ir::Object& object = scene_->objects[id_.value];
    const bool placed = object.placement.count > 0;
    const auto placement = placed ? scene_->placements[object.placement.first] : ir::Placement{};
    const Vec3d own_eye = placed ? placement.world_to_object.point(eye_) : eye_;
    Vec3d p;
    switch (object.kind) {
        case ir::ShapeKind::kSphere:
            p = on_sphere(scene_->spheres[object.shape].keys[0], own_eye, feature, choices);
            break;
        case ir::ShapeKind::kBox:
            p = on_box(scene_->boxes[object.shape], feature, choices);
            break;
        case ir::ShapeKind::kTriangle:
            p = on_triangle(scene_->triangles[object.shape].keys[0], feature, choices);
            break;
        case ir::ShapeKind::kMesh: {
            const ir::Mesh& mesh = scene_->meshes[object.shape];
            if (mesh.faces.empty()) break;
            if (feature == Feature::kOutline && edges_ != nullptr) {
                p = on_outline(mesh, *edges_, own_eye, choices);
                break;
            }
            const std::uint32_t face = choices.below(mesh.faces.size());
            p = on_triangle(face_vertices<double>(mesh, face, {}), feature, choices);
            break;
        }
        case ir::ShapeKind::kPlane:
            // Composed with its matrix: in the world already.
            return on_plane(plane_key(*scene_, object, 0, {}), eye_, choices);
    }
    return placed ? placement.object_to_world.point(p) : p;
}

}  // namespace cobble::renderer
