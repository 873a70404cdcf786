// SPDX-License-Identifier: MIT
#include "ir/lower/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/math/inverse.hpp"

namespace cobble::ir {
namespace {

namespace field = frontend::field;
using frontend::BlockNodeId;
using frontend::BlockView;
using grammar::BlockId;
using math::Affined;
using math::vec;
using math::Vec3d;

bool is_identity(const Affined& map) { return map == Affined(); }

/// The factor of an even scaling without rotation, or nothing.
std::optional<double> even_scale(const Affined& map) {
    const double s = map.rows[0][0];
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (map.rows[i][j] != (i == j ? s : 0)) return std::nullopt;
        }
    }
    return s > 0 ? std::optional(s) : std::nullopt;
}

/// The factor of an even scaling with any rotation or reflection, or nothing. Rotations composed
/// in double are orthogonal to a few units in the last place per factor; 2^-47 (64 of them) allows
/// for dozens of factors and is 2^-24, a float's precision, squared and doubled.
std::optional<double> similar_scale(const Affined& map) {
    constexpr double kTolerance = 0x1p-47;
    std::array<Vec3d, 3> column;
    for (std::size_t j = 0; j < 3; ++j) {
        column[j] = {map.rows[0][j], map.rows[1][j], map.rows[2][j]};
    }
    const double square = dot(column[0], column[0]);
    if (!(square > 0) || !std::isfinite(square)) return std::nullopt;
    for (std::size_t j = 0; j < 3; ++j) {
        if (std::fabs(dot(column[j], column[j]) - square) > kTolerance * square) {
            return std::nullopt;
        }
        if (std::fabs(dot(column[j], column[(j + 1) % 3])) > kTolerance * square) {
            return std::nullopt;
        }
    }
    return std::sqrt(square);
}

bool keeps_axes(const Affined& map) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (i == j ? !(map.rows[i][j] > 0) : map.rows[i][j] != 0) return false;
        }
    }
    return true;
}

/// {least, greatest} of each coordinate; not of an empty range.
std::pair<Vec3d, Vec3d> bounds_of(std::span<const Vec3d> points) {
    std::pair<Vec3d, Vec3d> bounds{points[0], points[0]};
    for (const Vec3d& p : points) {
        for (std::size_t i = 0; i < 3; ++i) {
            bounds.first[i] = std::min(bounds.first[i], p[i]);
            bounds.second[i] = std::max(bounds.second[i], p[i]);
        }
    }
    return bounds;
}

double distance(Vec3d a, Vec3d b) { return length(a - b); }

}  // namespace

std::array<Vec3d, 2> plane_tangents(Vec3d n) {
    const bool flat = n.y * n.y > n.x * n.x + n.z * n.z;
    // A ceiling is a floor seen from the other side: the same u, the opposite v.
    const Vec3d up_side = n.y < 0 ? -n : n;
    const Vec3d u =
        safe_normalize(flat ? cross(up_side, Vec3d{0, 0, 1}) : cross(Vec3d{0, 1, 0}, n));
    return {u, cross(n, u)};
}

bool ShapeBuilder::within_budget(std::uint32_t keys) {
    if (keys == 1) return true;
    if (own_keys_ + keys > kMaxOwnKeys) return false;
    own_keys_ += keys;
    return true;
}

void ShapeBuilder::note_chord(double value) {
    if (std::isfinite(value)) {
        scene_.motion_chord_error = std::max(scene_.motion_chord_error, value);
    }
}

std::optional<Keys> ShapeBuilder::placement(std::uint32_t frame) {
    Placed& placed = placed_[frame];
    if (placed.tried) return placed.keys.count > 0 ? std::optional(placed.keys) : std::nullopt;
    placed.tried = true;
    if (frames_.frame(frame).vanishes) return std::nullopt;
    const std::uint32_t count = frames_.keys(frame);
    const auto first = static_cast<std::uint32_t>(scene_.placements.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        const Affined& map = frames_.map(frame, k);
        const auto inverse = math::invert(map);
        if (!inverse) {
            scene_.placements.resize(first);
            return std::nullopt;
        }
        placed.condition = std::max(placed.condition, inverse->condition);
        placed.mirrors = inverse->mirrors;
        scene_.placements.push_back({map, inverse->map});
    }
    placed.keys = {first, count};
    return placed.keys;
}

void ShapeBuilder::note_instance(std::uint32_t frame, Vec3d low, Vec3d high) {
    if (!frames_.frame(frame).moving || !finite(low) || !finite(high)) return;
    auto& bounds = placed_[frame].moving_bounds;
    if (!bounds) {
        bounds = {low, high};
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        bounds->first[i] = std::min(bounds->first[i], low[i]);
        bounds->second[i] = std::max(bounds->second[i], high[i]);
    }
}

/// Between two keys a point of the object is seen where the interpolated inverse puts it. That
/// place and the true one are both affine in the point, so their distance is largest at a corner.
void ShapeBuilder::finish() {
    for (std::uint32_t frame = 0; frame < placed_.size(); ++frame) {
        if (!placed_[frame].moving_bounds) continue;
        const auto [low, high] = *placed_[frame].moving_bounds;
        const Keys keys = placed_[frame].keys;
        for (std::uint32_t k = 0; k + 1 < keys.count; ++k) {
            const Affined& a = scene_.placements[keys.first + k].world_to_object;
            const Affined& b = scene_.placements[keys.first + k + 1].world_to_object;
            const auto seen = math::invert(math::lerp(a, b, 0.5));
            if (!seen) continue;
            const Affined& truth = frames_.map_between(frame, k);
            for (unsigned corner = 0; corner < 8; ++corner) {
                const Vec3d p{(corner & 1) != 0 ? high.x : low.x,
                              (corner & 2) != 0 ? high.y : low.y,
                              (corner & 4) != 0 ? high.z : low.z};
                note_chord(distance(seen->map.point(p), truth.point(p)));
            }
        }
    }
}

bool ShapeBuilder::sphere_instance(Vec3d center, double radius, std::uint32_t frame, Object& out) {
    // The sphere's own centre and radius join the map, so that rays meet a unit sphere at the
    // origin, where its numbers are best.
    Affined local;
    for (std::size_t i = 0; i < 3; ++i) {
        local.rows[i][i] = radius;
        local.rows[i][3] = center[i];
    }
    const auto first = static_cast<std::uint32_t>(scene_.placements.size());
    const std::uint32_t count = frames_.keys(frame);
    const Vec3d reach{radius, radius, radius};
    note_instance(frame, center - reach, center + reach);
    if (!within_budget(count)) {
        out.placement = *placement(frame);
        scene_.spheres.push_back({{{center, radius}}});
        return true;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        const Affined map = frames_.map(frame, k) * local;
        const auto inverse = math::invert(map);
        if (!inverse) {
            scene_.placements.resize(first);
            return false;
        }
        scene_.placements.push_back({map, inverse->map});
    }
    out.placement = {first, count};
    scene_.spheres.push_back({{{Vec3d{}, 1.0}}});
    return true;
}

bool ShapeBuilder::sphere(const BlockView& view, std::uint32_t frame, bool reads_uv, Object& out) {
    const auto center = field::Sphere_center(view);
    const auto radius = field::Sphere_radius(view);
    if (!center || !radius || !(*radius > 0)) return false;
    const Vec3d c = vec(*center);
    Sphere sphere;
    const auto scale_of = [&](const Affined& map) {
        const auto even = even_scale(map);
        return even || reads_uv ? even : similar_scale(map);
    };
    const std::uint32_t count = frames_.keys(frame);
    const bool bake = within_budget(count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Affined& map = frames_.map(frame, k);
        const auto scale = bake ? scale_of(map) : std::nullopt;
        if (!scale) return sphere_instance(c, *radius, frame, out);
        sphere.keys.push_back({is_identity(map) ? c : map.point(c), *scale * *radius});
        const auto& key = sphere.keys.back();
        if (!finite(key.center) || !std::isfinite(key.radius) || !(key.radius > 0)) return false;
    }
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
        const Affined& map = frames_.map_between(frame, k);
        const auto& a = sphere.keys[k];
        const auto& b = sphere.keys[k + 1];
        const auto scale = similar_scale(map);
        const double shrunk =
            scale ? std::fabs(*scale * *radius - math::lerp(a.radius, b.radius, 0.5)) : 0;
        note_chord(distance(map.point(c), lerp(a.center, b.center, 0.5)) + shrunk);
    }
    scene_.spheres.push_back(std::move(sphere));
    return true;
}

bool ShapeBuilder::plane(const BlockView& view, std::uint32_t frame, Object& out) {
    const auto normal = field::Plane_normal(view);
    const auto offset = field::Plane_offset(view);
    if (!normal || !offset) return false;
    const Vec3d written = vec(*normal);
    const Vec3d n = safe_normalize(written);
    const double size = length(written);
    if (!(size > 0) || !std::isfinite(size)) return false;
    const auto [u, v] = plane_tangents(n);
    Plane plane{n, *offset / size, u, v, 0, 0};
    if (!std::isfinite(plane.offset)) return false;
    if (frames_.frame(frame).moving) {
        const Vec3d foot = n * plane.offset;
        note_instance(frame, foot, foot);
    } else {
        const Placement& place = scene_.placements[out.placement.first];
        if (!is_identity(place.object_to_world)) {
            // f(W p) for each affine functional f = axis . p + constant of the plane.
            const Affined& w = place.world_to_object;
            const Vec3d shift{w.rows[0][3], w.rows[1][3], w.rows[2][3]};
            const Vec3d image = w.transposed_vector(n);
            const double image_size = length(image);
            plane.normal = safe_normalize(image);
            plane.offset = (plane.offset - dot(n, shift)) / image_size;
            plane.u_axis = w.transposed_vector(u);
            plane.v_axis = w.transposed_vector(v);
            plane.u_offset = dot(u, shift);
            plane.v_offset = dot(v, shift);
            if (!(image_size > 0) || !std::isfinite(plane.offset) || !finite(plane.u_axis) ||
                !finite(plane.v_axis) || !std::isfinite(plane.u_offset) ||
                !std::isfinite(plane.v_offset)) {
                return false;
            }
        }
        out.placement = {};
    }
    scene_.planes.push_back(plane);
    return true;
}

bool ShapeBuilder::triangle(const BlockView& view, std::uint32_t frame, Object& out) {
    const auto a = field::Triangle_vertex0(view);
    const auto b = field::Triangle_vertex1(view);
    const auto c = field::Triangle_vertex2(view);
    if (!a || !b || !c) return false;
    std::array<Vec3d, 3> written{vec(*a), vec(*b), vec(*c)};
    if (!within_budget(frames_.keys(frame))) {
        const auto [low, high] = bounds_of(written);
        note_instance(frame, low, high);
        scene_.triangles.push_back({{written}});
        return true;
    }
    if (placed_[frame].mirrors) std::swap(written[1], written[2]);
    Triangle triangle;
    const std::uint32_t count = frames_.keys(frame);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Affined& map = frames_.map(frame, k);
        auto& key = triangle.keys.emplace_back(written);
        for (Vec3d& p : key) {
            if (!is_identity(map)) p = map.point(p);
            if (!finite(p)) return false;
        }
    }
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
        const Affined& map = frames_.map_between(frame, k);
        for (std::size_t i = 0; i < 3; ++i) {
            note_chord(distance(map.point(written[i]),
                                lerp(triangle.keys[k][i], triangle.keys[k + 1][i], 0.5)));
        }
    }
    out.placement = {};
    scene_.triangles.push_back(std::move(triangle));
    return true;
}

bool ShapeBuilder::box(const BlockView& view, std::uint32_t frame, Object& out) {
    const auto low = field::Box_min(view);
    const auto high = field::Box_max(view);
    if (!low || !high) return false;
    Box box{vec(*low), vec(*high)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(box.min[i] < box.max[i])) return false;
    }
    if (frames_.frame(frame).moving) {
        note_instance(frame, box.min, box.max);
    } else if (const Affined& map = frames_.map(frame, 0); keeps_axes(map)) {
        if (!is_identity(map)) {
            box = {map.point(box.min), map.point(box.max)};
            if (!finite(box.min) || !finite(box.max)) return false;
            // Far from the origin rounding may have swallowed the box.
            for (std::size_t i = 0; i < 3; ++i) {
                if (!(box.min[i] < box.max[i])) return false;
            }
        }
        out.placement = {};
    }
    scene_.boxes.push_back(box);
    return true;
}

bool ShapeBuilder::add(BlockNodeId block, bool reads_uv, Object& object) {
    const BlockView view(checked_.tokens, checked_.ast, block);
    const std::uint32_t frame = frames_.inside(block);
    const auto keys = placement(frame);
    if (!keys) return false;
    // Shapes that are baked drop it again; placements are shared, so none is wasted on them.
    object.placement = *keys;
    switch (checked_.ast.block(block).row) {
        case BlockId::kSphere:
            object.kind = ShapeKind::kSphere;
            object.shape = static_cast<std::uint32_t>(scene_.spheres.size());
            object.placement = {};
            return sphere(view, frame, reads_uv, object);
        case BlockId::kPlane:
            object.kind = ShapeKind::kPlane;
            object.shape = static_cast<std::uint32_t>(scene_.planes.size());
            return plane(view, frame, object);
        case BlockId::kTriangle:
            object.kind = ShapeKind::kTriangle;
            object.shape = static_cast<std::uint32_t>(scene_.triangles.size());
            return triangle(view, frame, object);
        case BlockId::kBox:
            object.kind = ShapeKind::kBox;
            object.shape = static_cast<std::uint32_t>(scene_.boxes.size());
            return box(view, frame, object);
        default:
            return false;
    }
}

void ShapeBuilder::bake(Mesh& mesh, const Placement& place, bool mirrors) {
    if (is_identity(place.object_to_world)) return;
    for (Vec3d& p : mesh.positions) p = place.object_to_world.point(p);
    for (Vec3d& n : mesh.normals) n = safe_normalize(place.world_to_object.transposed_vector(n));
    if (!mirrors) return;
    for (auto& face : mesh.faces) std::swap(face.corners[1], face.corners[2]);
}

bool ShapeBuilder::place_mesh(std::uint32_t mesh, bool sole, BlockNodeId block, Object& object) {
    const std::uint32_t frame = frames_.inside(block);
    const auto keys = placement(frame);
    if (!keys) return false;
    object.kind = ShapeKind::kMesh;
    object.shape = mesh;
    object.placement = *keys;
    Mesh& m = scene_.meshes[mesh];
    if (!frames_.frame(frame).moving) {
        if (!sole) return true;
        bake(m, scene_.placements[keys->first], placed_[frame].mirrors);
        object.placement = {};
        return std::all_of(m.positions.begin(), m.positions.end(), math::finite<double>);
    }
    if (mesh_bounds_.size() <= mesh) mesh_bounds_.resize(mesh + std::size_t{1});
    if (!mesh_bounds_[mesh]) mesh_bounds_[mesh] = bounds_of(m.positions);
    const auto [low, high] = *mesh_bounds_[mesh];
    note_instance(frame, low, high);
    return true;
}

}  // namespace cobble::ir
