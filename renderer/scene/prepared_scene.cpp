// SPDX-License-Identifier: MIT
#include "renderer/scene/prepared_scene.hpp"

#include <cstdint>

namespace cobble::renderer {

namespace {

template <typename Vector>
std::uint64_t bytes_of(const Vector& v) {
    return v.size() * sizeof(v[0]);
}

}  // namespace

template <typename T>
std::uint64_t PreparedScene<T>::bytes() const {
    const Geometry<T>& g = geometry;
    std::uint64_t sum =
        bytes_of(g.tree.nodes) + bytes_of(g.triangles) + bytes_of(g.spheres) + bytes_of(g.boxes) +
        bytes_of(g.moving_triangles) + bytes_of(g.moving_spheres) + bytes_of(g.instances) +
        bytes_of(g.planes) + bytes_of(g.triangle_keys) + bytes_of(g.sphere_keys) +
        bytes_of(g.plane_keys) + bytes_of(g.instance_keys) + bytes_of(g.places) + bytes_of(notes);
    const auto add_wide = [&sum](const WideTree<T>& tree) {
        sum += bytes_of(tree.nodes) + bytes_of(tree.triangles) + bytes_of(tree.spheres);
    };
    add_wide(g.wide);
    for (const auto& mesh : g.meshes) {
        sum += bytes_of(mesh.triangles) + bytes_of(mesh.tree.nodes);
        add_wide(mesh.wide);
    }
    return sum;
}

template struct PreparedScene<float>;
template struct PreparedScene<double>;

}  // namespace cobble::renderer
