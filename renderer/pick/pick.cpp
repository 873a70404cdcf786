// SPDX-License-Identifier: MIT
#include "renderer/pick/pick.hpp"

#include "renderer/integrator/trace.hpp"
#include "renderer/job/fp_environment.hpp"

namespace cobble::renderer {
namespace {

/// A ray still to be asked about, and what it is to its parent.
template <typename T>
struct Waiting {
    TracedRay<T> ray;
    std::uint32_t parent = 0;   ///< the nearest ray before it that is a node
    math::Vec3d tint{1, 1, 1};  ///< of its colour, in its parent's
};

/// Effects that choose at random, off: what is picked is the middle of lens, lights and pixel, at
/// the time the shutter opens.
Settings without_sampling(const Settings& settings) {
    Settings result = settings;
    result.samples = 1;
    for (const ir::Effect effect :
         {ir::Effect::kDepthOfField, ir::Effect::kMotionBlur, ir::Effect::kSoftShadows}) {
        result.effects.states[static_cast<std::size_t>(effect)].on = false;
    }
    return result;
}

template <typename T>
PickNode make_node(const ShadingScene<T>& scene, const TracedRay<T>& ray, const Shaded<T>& shaded,
                   const std::vector<LightAtSurface<T>>& lights) {
    PickNode node;
    node.kind = ray.kind == RayKind::kCamera      ? PickNode::Kind::kCamera
                : ray.kind == RayKind::kReflected ? PickNode::Kind::kReflected
                                                  : PickNode::Kind::kRefracted;
    node.depth = ray.depth;
    node.hit = static_cast<bool>(shaded.met.hit);
    node.origin = scene.geometry.to_world(ray.ray.origin);
    node.direction = ray.ray.direction.template to<double>();
    node.color = shaded.color.template to<double>();
    if (!node.hit) return node;
    node.t = shaded.met.hit.t;
    node.position = scene.geometry.to_world(shaded.met.point.position);
    node.normal = shaded.met.look.normal.template to<double>();
    node.geometric_normal = shaded.met.look.geometric.template to<double>();
    node.object = shaded.met.point.object;
    node.face = shaded.met.point.face;
    node.material = shaded.met.point.material;
    for (const LightAtSurface<T>& light : lights) {
        node.lights.push_back(
            {ir::LightId{light.light}, light.visible, light.contribution.template to<double>()});
    }
    return node;
}

template <typename T>
PickTree pick_in(const ir::Scene& scene, const Settings& settings, std::uint32_t x,
                 std::uint32_t y) {
    const Settings exact = without_sampling(settings);
    const auto shading = prepare_shading<T>(scene, exact);
    const SamplePass pass = whole_pass(exact.seed, 1);
    const Sampler sampler(pass, x, y, 0);
    Counters counters;
    SampleTrace<T> start;
    begin_sample(shading, exact.filter, pass.centred, sampler, x, y, start, counters);

    PickTree tree;
    std::vector<math::Vec3d> tints;  // by node
    std::vector<std::uint32_t> parents;
    std::vector<Waiting<T>> stack = {{start.stack.back(), 0, {1, 1, 1}}};
    while (!stack.empty() && tree.rays < kMostPickRays) {
        Waiting<T> waiting = stack.back();
        stack.pop_back();
        // Alone in its own pixel, so that a child's weight is its part of this ray's colour.
        waiting.ray.weight = {1, 1, 1};
        ++tree.rays;
        if (tree.nodes.size() == kMostPickNodes) {
            const Shaded<T> shaded = shade(shading, sampler, waiting.ray, counters);
            tree.nodes[waiting.parent].color += waiting.tint * shaded.color.template to<double>();
            for (std::uint32_t i = shaded.children.count; i > 0; --i) {
                const TracedRay<T>& child = shaded.children.rays[i - 1];
                stack.push_back(
                    {child, waiting.parent, waiting.tint * child.weight.template to<double>()});
            }
            continue;
        }
        std::vector<LightAtSurface<T>> lights;
        const Shaded<T> shaded = shade(shading, sampler, waiting.ray, counters, &lights);
        const auto index = static_cast<std::uint32_t>(tree.nodes.size());
        tree.nodes.push_back(make_node(shading, waiting.ray, shaded, lights));
        tints.push_back(waiting.tint);
        parents.push_back(waiting.parent);
        if (index > 0) tree.nodes[waiting.parent].children.push_back(index);
        for (std::uint32_t i = shaded.children.count; i > 0; --i) {
            const TracedRay<T>& child = shaded.children.rays[i - 1];
            stack.push_back({child, index, child.weight.template to<double>()});
        }
    }
    tree.complete = stack.empty();
    // Children come after their parents, so one pass backwards gives each ray its whole colour.
    for (std::size_t i = tree.nodes.size(); i-- > 1;) {
        tree.nodes[parents[i]].color += tints[i] * tree.nodes[i].color;
    }
    return tree;
}

}  // namespace

PickTree pick(const ir::Scene& scene, const Settings& settings, std::uint32_t x, std::uint32_t y) {
    const FpEnvironment environment;
    return settings.precision == Precision::kDouble ? pick_in<double>(scene, settings, x, y)
                                                    : pick_in<float>(scene, settings, x, y);
}

}  // namespace cobble::renderer
