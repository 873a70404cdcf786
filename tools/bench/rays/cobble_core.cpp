// SPDX-License-Identifier: MIT
#include "tools/bench/rays/cobble_core.hpp"

#include <fmt/format.h>
#include <hwy/highway.h>

#include <bit>
#include <cstdio>

#include "renderer/intersect/intersect.hpp"
#include "renderer/job/fp_environment.hpp"

namespace cobble::bench {

using renderer::Counters;
using renderer::FpEnvironment;
using renderer::Hit;
using renderer::PreparedScene;

namespace {

template <typename T>
std::uint64_t trace_single(const PreparedScene<T>& scene, const RaySet<T>& rays, std::size_t begin,
                           std::size_t end) {
    const FpEnvironment environment;
    Counters counters;
    std::uint64_t hits = 0;
    if (rays.kind.any) {
        for (std::size_t i = begin; i < end; ++i) {
            const RayQuery<T>& q = rays.queries[i];
            hits += any_hit(scene, q.ray, q.exclude, counters) ? 1 : 0;
        }
    } else {
        for (std::size_t i = begin; i < end; ++i) {
            const RayQuery<T>& q = rays.queries[i];
            hits += closest_hit(scene, q.ray, q.exclude, counters) ? 1 : 0;
        }
    }
    return hits;
}

template <typename T>
bool same_bits(T a, T b) {
    if constexpr (sizeof(T) == sizeof(std::uint32_t)) {
        return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
    } else {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    }
}

template <typename T>
bool same_hit(const Hit<T>& a, const Hit<T>& b) {
    if (!a && !b) return true;
    return a.object == b.object && a.face == b.face && same_bits(a.t, b.t) && same_bits(a.u, b.u) &&
           same_bits(a.v, b.v);
}

template <typename T>
std::uint64_t bytes_of(const renderer::WideTree<T>& tree) {
    return tree.nodes.size() * sizeof(tree.nodes[0]) +
           tree.triangles.size() * sizeof(tree.triangles[0]) +
           tree.spheres.size() * sizeof(tree.spheres[0]);
}

}  // namespace

const std::vector<InstructionSet>& instruction_sets() {
    static const std::vector<InstructionSet> sets = [] {
        std::vector<InstructionSet> found;
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
            std::string name = hwy::TargetName(target);
            for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            found.push_back({std::move(name), target});
        }
        return found;
    }();
    return sets;
}

void use_instruction_set(const InstructionSet& set) {
    hwy::SetSupportedTargetsForTest(set.target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

template <typename T>
std::vector<Contestant> cobble_contestants(const PreparedScene<T>& reference,
                                           const PreparedScene<T>& fast, const RaySet<T>& rays) {
    const auto single = [&rays](const PreparedScene<T>& scene) {
        return [&scene, &rays](std::size_t begin, std::size_t end) {
            return trace_single(scene, rays, begin, end);
        };
    };
    std::vector<Contestant> contestants;
    contestants.push_back({"cobble-reference", 1, {}, single(reference)});
    for (const InstructionSet& set : instruction_sets()) {
        const auto choose = [&set] { use_instruction_set(set); };
        contestants.push_back({"cobble-" + set.name, 1, choose, single(fast)});
    }
    return contestants;
}

template <typename T>
std::uint64_t count_differences(const PreparedScene<T>& fast, const RaySet<T>& rays) {
    const FpEnvironment environment;
    std::uint64_t sum = 0;
    for (const InstructionSet& set : instruction_sets()) {
        use_instruction_set(set);
        Counters counters;
        std::uint64_t here = 0;
        for (std::size_t i = 0; i < rays.queries.size(); ++i) {
            const RayQuery<T>& q = rays.queries[i];
            const Hit<T>& want = rays.expected[i];
            Hit<T> got;
            bool same = false;
            if (rays.kind.any) {
                same = any_hit(fast, q.ray, q.exclude, counters) == want.object.valid();
            } else {
                got = closest_hit(fast, q.ray, q.exclude, counters);
                same = same_hit(got, want);
            }
            if (same) continue;
            if (here++ > 0) continue;
            fmt::print(stderr,
                       "bench_rays: {} ray {} by {}: object {} face {} t {} u {} v {}, the "
                       "reference: object {} face {} t {} u {} v {}\n",
                       rays.kind.name, i, set.name, static_cast<std::int32_t>(got.object.value),
                       got.face, got.t, got.u, got.v, static_cast<std::int32_t>(want.object.value),
                       want.face, want.t, want.u, want.v);
        }
        sum += here;
    }
    use_instruction_set(instruction_sets()[0]);
    return sum;
}

template <typename T>
std::uint64_t tree_bytes(const PreparedScene<T>& fast) {
    const auto& g = fast.geometry;
    std::uint64_t sum = bytes_of(g.wide);
    sum += g.boxes.size() * sizeof(renderer::BoxPrimitive<T>) +
           g.box_objects.size() * sizeof(ir::ObjectId);
    sum += g.instances.size() * sizeof(renderer::Instance<T>) +
           g.instance_keys.size() * sizeof(renderer::InstanceKey<T>);
    for (const auto& mesh : g.meshes) sum += bytes_of(mesh.wide);
    return sum;
}

template std::vector<Contestant> cobble_contestants(const PreparedScene<float>&,
                                                    const PreparedScene<float>&,
                                                    const RaySet<float>&);
template std::vector<Contestant> cobble_contestants(const PreparedScene<double>&,
                                                    const PreparedScene<double>&,
                                                    const RaySet<double>&);
template std::uint64_t count_differences(const PreparedScene<float>&, const RaySet<float>&);
template std::uint64_t count_differences(const PreparedScene<double>&, const RaySet<double>&);
template std::uint64_t tree_bytes(const PreparedScene<float>&);
template std::uint64_t tree_bytes(const PreparedScene<double>&);

}  // namespace cobble::bench
