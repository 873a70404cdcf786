// SPDX-License-Identifier: MIT
// Everything that the ray loop reads: geometry narrowed to T, camera, lights, materials, and what
// is done at each stage.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/camera/camera.hpp"
#include "renderer/integrator/active_effects.hpp"
#include "renderer/integrator/prepared_material.hpp"
#include "renderer/integrator/render_plan.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/settings.hpp"
#include "renderer/shading/light.hpp"

namespace cobble::renderer {

template <typename T>
struct ShadingScene {
    const ir::Scene* source = nullptr;  ///< must outlive this
    ActiveEffects effects;
    RenderPlan plan;
    std::vector<PreparedMaterial<T>> materials;  ///< and one more, for objects without
    PreparedScene<T> geometry;
    PreparedCamera camera;
    std::vector<PreparedLight> lights;
    math::Vec3<T> ambient;
    math::Vec3<T> background;
    const ir::CubeMap* sky = nullptr;
    std::uint32_t bounces = 0;
    /// Of each object whether it is a see-through body that may touch another in a face; empty if
    /// none is.
    std::vector<std::uint8_t> touching{};

    [[nodiscard]] const PreparedMaterial<T>& material(ir::MaterialId id) const {
        return id.value + std::size_t{1} < materials.size() ? materials[id.value]
                                                            : materials.back();
    }
    /// Bytes of all this, without the source's images.
    [[nodiscard]] std::uint64_t bytes() const;
};

/// If `build` is cancelled, returns soon, with what must not be used.
template <typename T>
ShadingScene<T> prepare_shading(const ir::Scene& scene, const Settings& settings,
                                const BuildControl& build = {});

}  // namespace cobble::renderer
