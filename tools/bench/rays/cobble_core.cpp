// SPDX-License-Identifier: MIT
#include "tools/bench/rays/cobble_core.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <span>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/fp_environment.hpp"

namespace cobble::bench {

using renderer::Counters;
using renderer::FpEnvironment;
using renderer::Hit;
using renderer::PreparedScene;

namespace {

renderer::Coherence coherence_of(const RayKind& kind) {
    return kind.coherent ? renderer::Coherence::kCoherent : renderer::Coherence::kNone;
}

/// As many as the renderer asks for at once.
constexpr std::size_t kBatch = 128;

enum class Ask : bool { kSingle, kBatches };

/// Answers rays [begin, end) into `hits` from its beginning on; of an any hit, only whether.
template <typename T>
void closest(const PreparedScene<T>& scene, const RaySet<T>& set, Ask ask, std::size_t begin,
             std::span<Hit<T>> hits) {
    Counters counters;
    if (ask == Ask::kBatches) {
        renderer::closest_hits<T>(scene, std::span(set.rays).subspan(begin, hits.size()),
                                  std::span(set.excludes).subspan(begin, hits.size()), hits,
                                  counters, coherence_of(set.kind));
        return;
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i] = closest_hit(scene, set.rays[begin + i], set.excludes[begin + i], counters);
    }
}

template <typename T>
void any(const PreparedScene<T>& scene, const RaySet<T>& set, Ask ask, std::size_t begin,
         std::span<std::uint8_t> hits) {
    Counters counters;
    if (ask == Ask::kBatches) {
        renderer::any_hits<T>(scene, std::span(set.rays).subspan(begin, hits.size()),
                              std::span(set.excludes).subspan(begin, hits.size()), hits, counters,
                              coherence_of(set.kind));
        return;
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i] = any_hit(scene, set.rays[begin + i], set.excludes[begin + i], counters) ? 1 : 0;
    }
}

template <typename T>
std::uint64_t trace(const PreparedScene<T>& scene, const RaySet<T>& set, Ask ask, std::size_t begin,
                    std::size_t end) {
    const FpEnvironment environment;
    std::array<Hit<T>, kBatch> hits;
    std::array<std::uint8_t, kBatch> flags{};
    std::uint64_t sum = 0;
    for (; begin < end; begin += kBatch) {
        const std::size_t count = std::min(kBatch, end - begin);
        if (set.kind.any) {
            any(scene, set, ask, begin, std::span(flags).first(count));
            for (std::size_t i = 0; i < count; ++i) sum += flags[i];
        } else {
            closest(scene, set, ask, begin, std::span(hits).first(count));
            for (std::size_t i = 0; i < count; ++i) sum += hits[i] ? 1 : 0;
        }
    }
    return sum;
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
void complain(const PreparedScene<T>& scene, const RaySet<T>& rays, std::size_t i,
              const std::string& set, Ask ask, const Hit<T>& got) {
    const auto text = [](const Hit<T>& hit) {
        return fmt::format("object {} face {} t {} u {} v {}",
                           static_cast<std::int32_t>(hit.object.value), hit.face, hit.t, hit.u,
                           hit.v);
    };
    const Hit<T>& want = rays.expected[i];
    Counters counters;
    const Hit<T> every = closest_hit_brute_force(scene, rays.rays[i], rays.excludes[i], counters);
    fmt::print(stderr, "bench_rays: {} ray {} by {}{}: {}, the reference: {}, brute force: {}\n",
               rays.kind.name, i, set, ask == Ask::kBatches ? " in batches" : "",
               rays.kind.any ? (want ? "no hit" : "a hit") : text(got),
               rays.kind.any ? (want ? "a hit" : "no hit") : text(want), text(every));
}

template <typename T>
std::uint64_t bytes_of(const renderer::WideTree<T>& tree) {
    return tree.nodes.size() * sizeof(tree.nodes[0]) +
           tree.triangles.size() * sizeof(tree.triangles[0]) +
           tree.spheres.size() * sizeof(tree.spheres[0]);
}

}  // namespace

template <typename T>
std::vector<Contestant> cobble_contestants(const PreparedScene<T>& reference,
                                           const PreparedScene<T>& fast, const RaySet<T>& rays) {
    const auto way = [&rays](const PreparedScene<T>& scene, Ask ask) {
        return [&scene, &rays, ask](std::size_t begin, std::size_t end) {
            return trace(scene, rays, ask, begin, end);
        };
    };
    std::vector<Contestant> contestants;
    contestants.push_back({"cobble-reference", 1, {}, way(reference, Ask::kSingle)});
    for (const std::string& set : renderer::instruction_sets()) {
        const auto choose = [set] { renderer::use_instruction_set(set); };
        contestants.push_back({"cobble-" + set, 1, choose, way(fast, Ask::kSingle)});
        contestants.push_back({"cobble-batch-" + set, 1, choose, way(fast, Ask::kBatches)});
    }
    return contestants;
}

template <typename T>
std::uint64_t count_differences(const PreparedScene<T>& reference, const PreparedScene<T>& fast,
                                const RaySet<T>& rays) {
    const FpEnvironment environment;
    const std::size_t count = rays.rays.size();
    std::uint64_t sum = 0;
    for (const std::string& set : renderer::instruction_sets()) {
        renderer::use_instruction_set(set);
        for (const Ask ask : {Ask::kSingle, Ask::kBatches}) {
            std::vector<Hit<T>> hits(count);
            std::vector<std::uint8_t> flags(count);
            if (rays.kind.any) {
                any(fast, rays, ask, 0, std::span(flags));
            } else {
                closest(fast, rays, ask, 0, std::span(hits));
            }
            std::uint64_t here = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const bool same = rays.kind.any ? (flags[i] != 0) == rays.expected[i].object.valid()
                                                : same_hit(hits[i], rays.expected[i]);
                if (!same && here++ == 0) complain(reference, rays, i, set, ask, hits[i]);
            }
            sum += here;
        }
    }
    renderer::use_instruction_set("");
    return sum;
}

template <typename T>
std::uint64_t tree_bytes(const PreparedScene<T>& fast) {
    const auto& g = fast.geometry;
    std::uint64_t sum = bytes_of(g.wide);
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
template std::uint64_t count_differences(const PreparedScene<float>&, const PreparedScene<float>&,
                                         const RaySet<float>&);
template std::uint64_t count_differences(const PreparedScene<double>&, const PreparedScene<double>&,
                                         const RaySet<double>&);
template std::uint64_t tree_bytes(const PreparedScene<float>&);
template std::uint64_t tree_bytes(const PreparedScene<double>&);

}  // namespace cobble::bench
