// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "renderer/accel/wide_builder.hpp"

namespace cobble::renderer {

namespace {

template <typename T>
void set_lane(TriangleBlock<T>& block, std::uint32_t lane, const TrianglePrimitive<T>& from) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block.vertices[corner][axis][lane] = from.vertices[corner][axis];
        }
    }
    block.object[lane] = from.object;
    block.face[lane] = from.face;
}

/// Of lanes behind the last.
template <typename T>
void set_empty(TriangleBlock<T>&, std::uint32_t) {}
template <typename T>
void set_empty(SphereBlock<T>& block, std::uint32_t lane) {
    block.object[lane] = {};
}

template <typename T>
void set_lane(SphereBlock<T>& block, std::uint32_t lane, const SpherePrimitive<T>& from) {
    for (std::size_t axis = 0; axis < 3; ++axis) block.center[axis][lane] = from.center[axis];
    block.radius[lane] = from.radius;
    block.object[lane] = from.object;
}

template <typename T, typename Block, typename Primitive>
void fill(LargeVector<Block>& blocks, const std::vector<LeafRange>& ranges,
          const std::vector<BuildItem<T>>& items, std::span<const Primitive> primitives,
          const BuildControl& control) {
    blocks.resize(ranges.size());
    constexpr std::size_t kAtOnce = 4096;
    const std::size_t chunks = (ranges.size() + kAtOnce - 1) / kAtOnce;
    control.for_each(chunks, [&](std::size_t chunk) {
        const std::size_t end = std::min(ranges.size(), (chunk + 1) * kAtOnce);
        for (std::size_t b = chunk * kAtOnce; b < end; ++b) {
            for (std::uint32_t lane = 0; lane < std::size(blocks[b].object); ++lane) {
                const std::uint32_t from = lane < ranges[b].count ? lane : 0;
                set_lane(blocks[b], lane, primitives[items[ranges[b].first + from].index()]);
                if (lane >= ranges[b].count) set_empty(blocks[b], lane);
            }
        }
    });
}

}  // namespace

template <typename T>
WideTree<T> make_wide_tree(std::vector<BuildItem<T>>& items,
                           std::span<const TrianglePrimitive<T>> triangles,
                           std::span<const SpherePrimitive<T>> spheres,
                           const BuildControl& control) {
    WideBuild<T> build = build_wide_tree(items, control);
    WideTree<T> tree;
    tree.bounds = build.bounds;
    tree.nodes = std::move(build.nodes);
    fill(tree.triangles, build.triangle_blocks, items, triangles, control);
    fill(tree.spheres, build.sphere_blocks, items, spheres, control);
    return tree;
}

template WideTree<float> make_wide_tree(std::vector<BuildItem<float>>&,
                                        std::span<const TrianglePrimitive<float>>,
                                        std::span<const SpherePrimitive<float>>,
                                        const BuildControl&);
template WideTree<double> make_wide_tree(std::vector<BuildItem<double>>&,
                                         std::span<const TrianglePrimitive<double>>,
                                         std::span<const SpherePrimitive<double>>,
                                         const BuildControl&);

}  // namespace cobble::renderer
