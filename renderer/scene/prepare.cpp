// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "ir/math/inverse.hpp"
#include "ir/math/narrow.hpp"
#include "ir/scene/local_origin.hpp"
#include "renderer/accel/builder.hpp"
#include "renderer/accel/tree_limits.hpp"
#include "renderer/accel/wide_builder.hpp"
#include "renderer/geometry/bounds.hpp"
#include "renderer/scene/flat.hpp"
#include "renderer/scene/instance_bounds.hpp"
#include "renderer/scene/narrow_mesh.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/scene/rebase.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {

namespace {

using math::Vec3;
using math::Vec3d;
using Kind = PreparationNote::Kind;

using math::kLargestCoordinate;

template <typename T>
bool in_range(T x) {
    return std::fabs(x) <= kLargestCoordinate<T>;
}
template <typename T>
bool in_range(Vec3<T> p) {
    return in_range(p.x) && in_range(p.y) && in_range(p.z);
}

/// Room for `a + f (b - a)` in T: its three roundings err by less than 5 times half an epsilon of
/// the larger end; a sphere's box has pads of its own on top.
template <typename T>
void pad_for_motion(BoxBounds<T>& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        const T lo = std::fabs(box.lo[i]);
        const T hi = std::fabs(box.hi[i]);
        const T pad = (lo > hi ? lo : hi) * (8 * std::numeric_limits<T>::epsilon());
        box.lo[i] -= pad;
        box.hi[i] += pad;
    }
}

template <typename T>
class Preparation {
  public:
    Preparation(const ir::Scene& scene, const PrepareOptions& options)
        : scene_(scene), bounds_(scene) {
        out_.source = &scene;
        out_.options = options;
        out_.origin = ir::local_origin(scene, bounds_);
        geometry().places.resize(scene.objects.size());
        placed_mesh_.assign(scene.meshes.size(), Geometry<T>::kNone);
    }

    PreparedScene<T> run() {
        reserve();
        for (std::uint32_t i = 0; i < scene_.objects.size() && !cancelled(); ++i) {
            const ir::Object& object = scene_.objects[i];
            const ir::ObjectId id{i};
            if (object.kind == ir::ShapeKind::kPlane) {
                add_plane(object, id);
            } else if (object.placement.count > 0) {
                add_instance(object, id);
            } else {
                add_baked(object, id);
            }
        }
        build();
        out_.options.build = {};
        return std::move(out_);
    }

  private:
    /// Arrays of millions that grow as they are filled would be moved again and again. Nothing is
    /// taken for what no tree could hold.
    void reserve() {
        std::size_t all = 0;
        std::size_t triangles = 0;
        std::size_t spheres = 0;
        std::size_t boxes = 0;
        for (const ir::Object& object : scene_.objects) {
            const bool placed = object.placement.count > 0;
            const bool mesh = object.kind == ir::ShapeKind::kMesh;
            const std::size_t things = mesh ? scene_.meshes[object.shape].faces.size() : 1;
            require_room(things);  // a placed mesh has a tree of its own
            all += placed ? 1 : things;
            if (placed) continue;
            if (mesh || object.kind == ir::ShapeKind::kTriangle) triangles += things;
            if (object.kind == ir::ShapeKind::kSphere) spheres += 1;
            if (object.kind == ir::ShapeKind::kBox) boxes += 1;
        }
        require_room(all);
        if (boxes > 0) require_room(scene_.objects.size());  // by which their slots are numbered
        items_.reserve(all);
        geometry().triangles.reserve(triangles);
        geometry().spheres.reserve(spheres);
        geometry().boxes.reserve(boxes);
    }

    Geometry<T>& geometry() { return out_.geometry; }
    [[nodiscard]] const PrepareOptions& options() const { return out_.options; }
    [[nodiscard]] bool cancelled() const { return options().build.stopped(); }

    void note(Kind kind, ir::ObjectId object, std::uint32_t face) {
        for (auto i = out_.notes.size(); i > 0 && out_.notes[i - 1].object == object; --i) {
            if (out_.notes[i - 1].kind == kind) {
                out_.notes[i - 1].count += 1;
                return;
            }
        }
        out_.notes.push_back({kind, object, face, 1});
    }

    /// False, with a note, for what can not be hit.
    bool usable(const std::array<Vec3<T>, 3>& v, ir::ObjectId id, std::uint32_t face) {
        if (!in_range(v[0]) || !in_range(v[1]) || !in_range(v[2])) {
            note(Kind::kOutOfRange, id, face);
            return false;
        }
        const bool none = flat(v);
        if (none) note(without_extent(flat_as_written(id, face)), id, face);
        return !none;
    }

    [[nodiscard]] bool flat_as_written(ir::ObjectId id, std::uint32_t face) const {
        const ir::Object& object = scene_.objects[id.value];
        if (object.kind == ir::ShapeKind::kMesh) {
            return flat_in_double(face_vertices<double>(scene_.meshes[object.shape], face, {}));
        }
        return flat(scene_.triangles[object.shape].keys[0]);
    }

    static Kind without_extent(bool as_written) {
        return as_written ? Kind::kDegenerate : Kind::kFlattened;
    }

    void add_item(PrimitiveKind kind, std::size_t index, const BoxBounds<T>& bounds) {
        items_.emplace_back(bounds, kind, static_cast<std::uint32_t>(index));
    }

    void add_baked(const ir::Object& object, ir::ObjectId id) {
        Geometry<T>& g = geometry();
        switch (object.kind) {
            case ir::ShapeKind::kMesh: {
                const ir::Mesh& mesh = scene_.meshes[object.shape];
                const NarrowMesh<T> narrow(mesh, out_.origin);
                for (std::uint32_t f = 0; f < mesh.faces.size() && !cancelled(); ++f) {
                    add_triangle(narrow.vertices(f), id, f);
                }
                break;
            }
            case ir::ShapeKind::kTriangle: {
                const auto& keys = scene_.triangles[object.shape].keys;
                if (keys.size() > 1) {
                    add_moving_triangle(keys, id);
                } else {
                    add_triangle(narrow_vertices<T>(keys[0], out_.origin), id, 0);
                }
                break;
            }
            case ir::ShapeKind::kSphere: {
                const auto& keys = scene_.spheres[object.shape].keys;
                if (keys.size() > 1) {
                    add_moving_sphere(keys, id);
                } else {
                    const SphereKey<T> s = narrow_sphere<T>(keys[0], out_.origin);
                    if (!usable(s, id)) break;
                    add_item(PrimitiveKind::kSphere, g.spheres.size(),
                             bounds_of(s.center, s.radius));
                    g.spheres.push_back({s.center, s.radius, id});
                }
                break;
            }
            case ir::ShapeKind::kBox: {
                const auto b = narrow_box<T>(scene_.boxes[object.shape], out_.origin);
                if (!usable(b, id)) break;
                if (fast()) {
                    add_item(PrimitiveKind::kBox, id.value, b);
                    g.any_boxes = true;
                } else {
                    add_item(PrimitiveKind::kBox, g.boxes.size(), b);
                    g.boxes.push_back({b, id});
                }
                break;
            }
            case ir::ShapeKind::kPlane:
                break;
        }
    }

    bool usable(const SphereKey<T>& s, ir::ObjectId id) {
        if (!in_range(s.center) || !in_range(s.radius)) {
            note(Kind::kOutOfRange, id, 0);
            return false;
        }
        if (s.radius > 0) return true;
        bool as_written = true;
        for (const auto& key : scene_.spheres[scene_.objects[id.value].shape].keys) {
            as_written = as_written && !(key.radius > 0);
        }
        note(without_extent(as_written), id, 0);
        return false;
    }

    /// A box may be a plate, but not a rod or a point.
    bool usable(const BoxBounds<T>& b, ir::ObjectId id) {
        if (!in_range(b.lo) || !in_range(b.hi)) {
            note(Kind::kOutOfRange, id, 0);
            return false;
        }
        if (has_faces(b)) return true;
        const ir::Box& written = scene_.boxes[scene_.objects[id.value].shape];
        note(without_extent(!has_faces(BoxBounds<double>{written.min, written.max})), id, 0);
        return false;
    }

    template <typename U>
    static bool has_faces(const BoxBounds<U>& b) {
        int extents = 0;
        for (std::size_t i = 0; i < 3; ++i) extents += b.lo[i] < b.hi[i] ? 1 : 0;
        const bool ordered = b.lo.x <= b.hi.x && b.lo.y <= b.hi.y && b.lo.z <= b.hi.z;
        return ordered && extents >= 2;
    }

    void add_triangle(const std::array<Vec3<T>, 3>& v, ir::ObjectId id, std::uint32_t face) {
        if (!usable(v, id, face)) return;
        add_item(PrimitiveKind::kTriangle, geometry().triangles.size(), bounds_of(v));
        geometry().triangles.push_back({v, id, face});
    }

    void add_moving_triangle(const std::vector<std::array<Vec3d, 3>>& keys, ir::ObjectId id) {
        Geometry<T>& g = geometry();
        const auto first = static_cast<std::uint32_t>(g.triangle_keys.size());
        BoxBounds<T> bounds;
        bool always_flat = true;
        bool as_written = true;
        for (const auto& key : keys) {
            const auto v = narrow_vertices<T>(key, out_.origin);
            if (!in_range(v[0]) || !in_range(v[1]) || !in_range(v[2])) {
                note(Kind::kOutOfRange, id, 0);
                g.triangle_keys.resize(first);
                return;
            }
            always_flat = always_flat && flat(v);
            as_written = as_written && flat(key);
            bounds.add(bounds_of(v));
            g.triangle_keys.push_back(v);
        }
        if (always_flat) note(without_extent(as_written), id, 0);
        pad_for_motion(bounds);
        add_item(PrimitiveKind::kMovingTriangle, g.moving_triangles.size(), bounds);
        g.moving_triangles.push_back({first, static_cast<std::uint32_t>(keys.size()), id});
    }

    void add_moving_sphere(const std::vector<ir::Sphere::Key>& keys, ir::ObjectId id) {
        Geometry<T>& g = geometry();
        const auto first = static_cast<std::uint32_t>(g.sphere_keys.size());
        BoxBounds<T> bounds;
        for (const auto& key : keys) {
            const SphereKey<T> s = narrow_sphere<T>(key, out_.origin);
            if (!usable(s, id)) {
                g.sphere_keys.resize(first);
                return;
            }
            bounds.add(bounds_of(s.center, s.radius));
            g.sphere_keys.push_back(s);
        }
        pad_for_motion(bounds);
        add_item(PrimitiveKind::kMovingSphere, g.moving_spheres.size(), bounds);
        g.moving_spheres.push_back({first, static_cast<std::uint32_t>(keys.size()), id});
    }

    void add_plane(const ir::Object& object, ir::ObjectId id) {
        Geometry<T>& g = geometry();
        const auto first = static_cast<std::uint32_t>(g.plane_keys.size());
        const std::uint32_t count = object.placement.count > 0 ? object.placement.count : 1;
        for (std::uint32_t k = 0; k < count; ++k) {
            const PlaneKey key = plane_key(scene_, object, k, out_.origin);
            const double most = std::fabs(key.normal.x) + std::fabs(key.normal.y) +
                                std::fabs(key.normal.z) + std::fabs(key.offset);
            const bool flat_normal = key.normal == Vec3d{};
            if (flat_normal || !(most <= kLargestCoordinate<double>)) {
                note(flat_normal ? Kind::kDegenerate : Kind::kOutOfRange, id, 0);
                g.plane_keys.resize(first);
                return;
            }
            g.plane_keys.push_back(key);
        }
        g.places[id.value] = {false, static_cast<std::uint32_t>(g.planes.size())};
        g.planes.push_back({first, count, id});
    }

    void add_instance(const ir::Object& object, ir::ObjectId id) {
        Geometry<T>& g = geometry();
        Instance<T> instance;
        instance.kind = object.kind;
        instance.object = id;
        instance.keys = object.placement.count;
        instance.first_key = static_cast<std::uint32_t>(g.instance_keys.size());
        const BoxBounds<double> own = bounds_.shape(object);
        instance.shape_origin = object.kind == ir::ShapeKind::kSphere
                                    ? scene_.spheres[object.shape].keys[0].center
                                    : grid_origin(own, (own.lo + own.hi) * 0.5);
        const std::optional<BoxBounds<T>> bounds = place_shape(object, id, instance);
        if (!bounds) return;
        for (std::uint32_t k = 0; k < instance.keys; ++k) {
            const ir::Placement& placement = scene_.placements[object.placement.first + k];
            InstanceKey<T> key;
            key.world_to_object =
                rebased(placement.world_to_object, out_.origin, instance.shape_origin)
                    .template to<T>();
            const auto rounded = key.world_to_object.template to<double>();
            const auto back = math::inverse(rounded);
            if (!back) {
                note(Kind::kSingular, id, 0);
                g.instance_keys.resize(instance.first_key);
                return;
            }
            // A millionth of the digits of float left, and as many more for double as it has.
            constexpr double kWorst = 1e6 * (double{std::numeric_limits<float>::epsilon()} /
                                             double{std::numeric_limits<T>::epsilon()});
            if (math::condition(rounded, *back) > kWorst) note(Kind::kIllConditioned, id, 0);
            key.object_to_world = *back;
            g.instance_keys.push_back(key);
        }
        instance.world_bounds = instance_bounds<T>(
            *bounds, std::span(g.instance_keys).subspan(instance.first_key, instance.keys));
        add_item(PrimitiveKind::kInstance, g.instances.size(), instance.world_bounds);
        g.instances.push_back(instance);
    }

    /// The shape itself, relative to its origin, and its box; nothing if nothing of it can be hit.
    std::optional<BoxBounds<T>> place_shape(const ir::Object& object, ir::ObjectId id,
                                            Instance<T>& instance) {
        Geometry<T>& g = geometry();
        switch (object.kind) {
            case ir::ShapeKind::kSphere: {
                const auto s =
                    narrow_sphere<T>(scene_.spheres[object.shape].keys[0], instance.shape_origin);
                if (!usable(s, id)) return std::nullopt;
                instance.sphere = {s.center, s.radius, id};
                return bounds_of(s.center, s.radius);
            }
            case ir::ShapeKind::kBox: {
                const auto b = narrow_box<T>(scene_.boxes[object.shape], instance.shape_origin);
                if (!usable(b, id)) return std::nullopt;
                instance.box = {b, id};
                return b;
            }
            case ir::ShapeKind::kTriangle: {
                const auto v = narrow_vertices<T>(scene_.triangles[object.shape].keys[0],
                                                  instance.shape_origin);
                if (!usable(v, id, 0)) return std::nullopt;
                instance.triangle = {v, id, 0};
                return bounds_of(v);
            }
            case ir::ShapeKind::kMesh: {
                std::uint32_t& place = placed_mesh_[object.shape];
                if (place == Geometry<T>::kNone) {
                    place = static_cast<std::uint32_t>(g.meshes.size());
                    place_mesh(scene_.meshes[object.shape], id, instance.shape_origin);
                }
                instance.mesh = place;
                const PlacedMesh<T>& mesh = g.meshes[place];
                const BoxBounds<T>& box = fast() ? mesh.wide.bounds : mesh.tree.bounds;
                if (box.empty()) return std::nullopt;
                return box;
            }
            case ir::ShapeKind::kPlane:
                break;
        }
        return std::nullopt;
    }

    void place_mesh(const ir::Mesh& mesh, ir::ObjectId id, Vec3d shape_origin) {
        PlacedMesh<T> placed;
        std::vector<TrianglePrimitive<T>> triangles;
        std::vector<BuildItem<T>> items;
        triangles.reserve(mesh.faces.size());
        items.reserve(mesh.faces.size());
        const NarrowMesh<T> narrow(mesh, shape_origin);
        for (std::uint32_t f = 0; f < mesh.faces.size() && !cancelled(); ++f) {
            const auto v = narrow.vertices(f);
            if (!usable(v, id, f)) continue;
            items.emplace_back(bounds_of(v), PrimitiveKind::kTriangle,
                               static_cast<std::uint32_t>(triangles.size()));
            triangles.push_back({v, id, f});
        }
        if (fast()) {
            placed.wide = make_wide_tree<T>(items, triangles, {}, options().build);
        } else {
            placed.tree = build_tree(items, options().build.cancelled);
            if (cancelled()) items.clear();
            placed.triangles.reserve(items.size());
            for (const auto& item : items) placed.triangles.push_back(triangles[item.index()]);
        }
        geometry().meshes.push_back(std::move(placed));
    }

    [[nodiscard]] bool fast() const { return options().acceleration == Acceleration::kFast; }

    void build_fast() {
        Geometry<T>& g = geometry();
        g.wide = make_wide_tree<T>(items_, g.triangles, g.spheres, options().build);
        g.triangles = {};
        g.spheres = {};
    }

    template <typename U>
    void sort_kind(PrimitiveKind kind, std::vector<U>& array) {
        std::vector<U> sorted;
        sorted.reserve(array.size());
        for (const auto& item : items_) {
            if (item.kind() == kind) sorted.push_back(array[item.index()]);
        }
        array = std::move(sorted);
    }

    void build() {
        Geometry<T>& g = geometry();
        if (fast()) {
            build_fast();
        } else {
            build_reference();
        }
        if (cancelled()) return;
        const auto place = [&g](const auto& array, bool instance) {
            for (std::uint32_t i = 0; i < array.size(); ++i) {
                g.places[array[i].object.value] = {instance, i};
            }
        };
        place(g.moving_triangles, false);
        place(g.moving_spheres, false);
        place(g.instances, true);
    }

    void build_reference() {
        Geometry<T>& g = geometry();
        g.tree = build_tree(items_, options().build.cancelled);
        if (cancelled()) return;
        sort_kind(PrimitiveKind::kTriangle, g.triangles);
        sort_kind(PrimitiveKind::kSphere, g.spheres);
        sort_kind(PrimitiveKind::kBox, g.boxes);
        sort_kind(PrimitiveKind::kMovingTriangle, g.moving_triangles);
        sort_kind(PrimitiveKind::kMovingSphere, g.moving_spheres);
        sort_kind(PrimitiveKind::kInstance, g.instances);
    }

    const ir::Scene& scene_;
    ir::SceneBounds bounds_;
    PreparedScene<T> out_;
    std::vector<BuildItem<T>> items_;
    std::vector<std::uint32_t> placed_mesh_;
};

}  // namespace

template <typename T>
PreparedScene<T> prepare(const ir::Scene& scene, const PrepareOptions& options) {
    return Preparation<T>(scene, options).run();
}

template PreparedScene<float> prepare(const ir::Scene&, const PrepareOptions&);
template PreparedScene<double> prepare(const ir::Scene&, const PrepareOptions&);

}  // namespace cobble::renderer
