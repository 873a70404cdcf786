// SPDX-License-Identifier: MIT
#include "renderer/integrator/met_surfaces.hpp"

#include "renderer/intersect/surface_forms.hpp"
#include "renderer/scene/shape_bounds.hpp"
#include "renderer/shading/phong.hpp"

namespace cobble::renderer {

template <typename T>
MetSurfaces<T>::MetSurfaces(const ShadingScene<T>& scene)
    : scene_(&scene), columns_(std::make_unique<SurfaceSlots<T>>()) {}

template <typename T>
SurfaceForm MetSurfaces<T>::form_of(const ir::Object& object, const Hit<T>& hit) const {
    const ir::Scene& source = *scene_->source;
    const PreparedMaterial<T>& material = scene_->material(object.material);
    if (material.cube_map != nullptr) return SurfaceForm::kUnlit;
    if (!material.plain() || !is_plain_shape(source, object)) return SurfaceForm::kOther;
    switch (object.kind) {
        case ir::ShapeKind::kMesh: {
            const auto& c = source.meshes[object.shape].faces[hit.face].corners;
            constexpr std::uint32_t kNone = ir::Mesh::kNone;
            const bool smooth =
                c[0].normal != kNone && c[1].normal != kNone && c[2].normal != kNone;
            return smooth ? SurfaceForm::kSmooth : SurfaceForm::kFlat;
        }
        case ir::ShapeKind::kTriangle:
            return SurfaceForm::kFlat;
        case ir::ShapeKind::kSphere:
            return SurfaceForm::kSphere;
        case ir::ShapeKind::kBox:
            return SurfaceForm::kBox;
        case ir::ShapeKind::kPlane:
            break;
    }
    return SurfaceForm::kOther;
}

template <typename T>
void MetSurfaces<T>::fill_triangle(std::size_t slot, const std::array<math::Vec3<T>, 3>& vertices) {
    SurfaceForms<T>& forms = columns_->forms;
    forms.a.set(slot, vertices[0]);
    forms.b.set(slot, vertices[1]);
    forms.c.set(slot, vertices[2]);
    forms.normal.set(slot, unit(triangle_normal(vertices[0], vertices[1], vertices[2])));
}

template <typename T>
void MetSurfaces<T>::fill_slot(std::size_t slot, const Hit<T>& hit) {
    const ir::Scene& source = *scene_->source;
    const ir::Object& object = source.objects[hit.object.value];
    const PreparedMaterial<T>& material = scene_->material(object.material);
    const math::Vec3d origin = scene_->geometry.origin;
    columns_->object[slot] = hit.object.value;
    columns_->face[slot] = hit.face;
    columns_->kd.set(slot, material.diffuse);
    material_[slot] = &material;
    const ActiveEffects& effects = scene_->effects;
    any_highlight_ = any_highlight_ ||
                     (effects.highlights() && has_highlight(material.specular, material.shininess));
    columns_->specular.set(slot, material.specular);
    columns_->index[slot] = material.refraction_index;
    scatters_[slot] = material.sends_on ? 1 : 0;
    any_scatters_ = any_scatters_ || scatters_[slot] != 0;
    any_glass_ = any_glass_ || (scatters_[slot] != 0 && material.refraction_index > T(0));
    form_[slot] = form_of(object, hit);
    switch (form_[slot]) {
        case SurfaceForm::kSmooth: {
            const ir::Mesh& mesh = source.meshes[object.shape];
            const auto& corners = mesh.faces[hit.face].corners;
            columns_->forms.na.set(slot, mesh.normals[corners[0].normal]);
            columns_->forms.nb.set(slot, mesh.normals[corners[1].normal]);
            columns_->forms.nc.set(slot, mesh.normals[corners[2].normal]);
            fill_triangle(slot, face_vertices<T>(mesh, hit.face, origin));
            break;
        }
        case SurfaceForm::kFlat:
            fill_triangle(slot,
                          object.kind == ir::ShapeKind::kMesh
                              ? face_vertices<T>(source.meshes[object.shape], hit.face, origin)
                              : narrow_vertices<T>(source.triangles[object.shape].keys[0], origin));
            break;
        case SurfaceForm::kSphere: {
            const SphereKey<T> sphere =
                narrow_sphere<T>(source.spheres[object.shape].keys[0], origin);
            columns_->forms.a.set(slot, sphere.center);
            columns_->forms.b.set(slot, {sphere.radius, 0, 0});
            break;
        }
        case SurfaceForm::kBox: {
            const BoxBounds<T> box = narrow_box<T>(source.boxes[object.shape], origin);
            columns_->forms.a.set(slot, box.lo);
            columns_->forms.b.set(slot, box.hi);
            math::Vec3d normal;
            normal[hit.face / 2] = hit.face % 2 == 1 ? 1 : -1;
            columns_->forms.normal.set(slot, normal);
            break;
        }
        case SurfaceForm::kOther:
        case SurfaceForm::kUnlit:
            break;
    }
}

template class MetSurfaces<float>;
template class MetSurfaces<double>;

}  // namespace cobble::renderer
