// SPDX-License-Identifier: MIT
// Light along one camera ray of a published program, a ray at a time.
//
// The programs recurse; here the rays still to be followed wait on a list, each with the factor
// that its colour counts with, so that neither depth nor time between two stops depends on
// -bounces.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/compat/rules.hpp"
#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/tile/stats.hpp"

namespace cobble::renderer {

/// What all rays share.
struct CompatScene {
    const ir::Scene* scene = nullptr;
    const PreparedScene<double>* prepared = nullptr;
    CompatRules rules;
};

/// A surface as the programs see it.
struct CompatSurface {
    math::Vec3d point;   ///< origin + t direction, local coordinates
    math::Vec3d normal;  ///< unit, never flipped; by the normal map where there is one
    const ir::Material* material = nullptr;
    /// A flat primitive is not met again from itself: the programs' start of 0.001 sees to that,
    /// and leaving it out is faster.
    Exclude self;
    ir::Color kd;  ///< noise, else texture where the hit has coordinates, else the diffuse colour
};

class CompatTrace {
  public:
    /// Begins anew. `direction` is unit, `origin` in world space.
    void start(const CompatScene& scene, math::Vec3d origin, math::Vec3d direction);
    [[nodiscard]] bool done() const { return waiting_.empty(); }
    /// Follows one ray: its hit, the shadow rays from there, and what it sends on.
    void step(const CompatScene& scene, Counters& counters);
    [[nodiscard]] ir::Color color() const { return color_; }
    /// What the camera ray met; nothing before the first step.
    [[nodiscard]] ir::ObjectId first_object() const { return first_object_; }

  private:
    struct Waiting {
        math::Vec3d origin;  ///< local
        math::Vec3d direction;
        Exclude exclude;
        double t_min = 0;
        double index = 1;  ///< of the medium that the ray runs in
        std::uint32_t depth = 0;
        ir::Color factor{1, 1, 1};
    };

    void send_on(const CompatScene& scene, const Waiting& ray, const CompatSurface& surface,
                 Counters& counters);

    std::vector<Waiting> waiting_;
    ir::Color color_;
    ir::ObjectId first_object_;
};

/// The camera ray's hit alone, for the pictures beside the colour.
struct CompatFirstHit {
    bool hit = false;
    double distance = 0;
    math::Vec3d normal;
    ir::Color albedo;
};
CompatFirstHit compat_first_hit(const CompatScene& scene, math::Vec3d origin, math::Vec3d direction,
                                Counters& counters);

}  // namespace cobble::renderer
