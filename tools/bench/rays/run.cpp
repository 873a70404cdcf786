// SPDX-License-Identifier: MIT
#include "tools/bench/rays/run.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/build_on.hpp"
#include "renderer/job/fp_environment.hpp"
#include "tools/bench/clock.hpp"
#include "tools/bench/median.hpp"
#include "tools/bench/rays/cobble_core.hpp"
#ifdef COBBLE_BENCH_EMBREE
#include "tools/bench/rays/embree_core.hpp"
#endif

namespace cobble::bench {

using renderer::Acceleration;
using renderer::PreparedScene;
using renderer::PrepareOptions;

namespace {

/// The peer that figures are divided by.
constexpr std::string_view kRobust = "embree-robust";

template <typename T>
PreparedScene<T> prepare_as(const ir::Scene& scene, Acceleration acceleration,
                            const renderer::BuildControl& build = {}) {
    const renderer::FpEnvironment environment;
    PrepareOptions options;
    options.build = build;
    options.acceleration = acceleration;
    options.texture_coordinates = false;
    return renderer::prepare<T>(scene, options);
}

bool chosen(const std::vector<std::string>& words, std::string_view name) {
    return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
               return name.find(word) != std::string_view::npos;
           });
}

bool has_kind(const Choice& choice, std::string_view kind) {
    return std::find(choice.kinds.begin(), choice.kinds.end(), kind) != choice.kinds.end();
}

/// Those that were chosen; with more than one thread only what is not an older instruction set, a
/// reference or Embree without its robust flag.
std::vector<Contestant> entrants(const std::vector<Contestant>& all, const Choice& choice) {
    const std::string best = renderer::instruction_sets()[0];
    std::vector<Contestant> result;
    for (const unsigned threads : choice.threads) {
        for (const Contestant& contestant : all) {
            if (!chosen(choice.cores, contestant.core)) continue;
            const bool leading =
                contestant.core.ends_with(best) || contestant.core.starts_with(kRobust);
            if (threads > 1 && !leading) continue;
            result.push_back(contestant);
            result.back().threads = threads;
        }
    }
    return result;
}

std::vector<CoreResult> summarise(const std::vector<Contestant>& contestants,
                                  const std::vector<Timing>& timings, std::size_t rays) {
    std::vector<CoreResult> results;
    const double millions = static_cast<double>(rays) * 1e-6;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        const Contestant& me = contestants[i];
        const std::vector<double>& seconds = timings[i].seconds();
        CoreResult result;
        result.core = me.core;
        result.threads = me.threads;
        result.passes = seconds.size();
        result.rate = millions / median(seconds);
        result.slow = millions / quantile(seconds, 0.75);
        result.fast = millions / quantile(seconds, 0.25);
        for (std::size_t k = 0; k < contestants.size(); ++k) {
            const Contestant& other = contestants[k];
            if (other.threads == me.threads && k != i) {
                result.ratios.emplace_back(other.core, speed_ratio(seconds, timings[k].seconds()));
            }
            if (other.core == me.core && other.threads == 1 && me.threads > 1) {
                result.scaling = speed_ratio(timings[i].wall, timings[k].wall);
            }
        }
        results.push_back(std::move(result));
    }
    return results;
}

/// Something that can be built, how long it took, and what it then holds.
struct Builder {
    struct Built {
        double seconds;
        std::uint64_t bytes;
    };
    std::string core;
    unsigned threads;
    std::size_t primitives;
    std::function<Built()> build;
};

std::vector<BuildResult> measure_builds(const std::vector<Builder>& builders, Effort effort) {
    std::vector<std::vector<double>> seconds(builders.size());
    std::vector<BuildResult> results;
    for (const Builder& b : builders)
        results.push_back({b.core, b.threads, 0, b.primitives, 0, {}});
    for (std::size_t pass = 0; pass < effort.passes; ++pass) {
        for (std::size_t i = 0; i < builders.size(); ++i) {
            const auto built = builders[i].build();
            seconds[i].push_back(built.seconds);
            results[i].bytes = built.bytes;
        }
    }
    for (std::size_t i = 0; i < builders.size(); ++i) {
        results[i].seconds = median(seconds[i]);
        for (std::size_t k = 0; k < builders.size(); ++k) {
            if (builders[k].core == kRobust && builders[k].threads == builders[i].threads) {
                results[i].ratio = speed_ratio(seconds[i], seconds[k]);
            }
        }
    }
    return results;
}

template <typename T>
std::vector<Builder> builders_for(const Input& input, const Choice& choice) {
    std::vector<Builder> builders;
    const std::size_t primitives = stored_primitives(input.scene);
    if (chosen(choice.cores, "cobble-" + renderer::instruction_sets()[0])) {
        for (const unsigned threads : choice.threads) {
            builders.push_back({"cobble", threads, primitives, [&input, threads] {
                                    const auto workers = renderer::make_thread_scheduler(threads);
                                    const Stopwatch watch;
                                    const auto scene =
                                        prepare_as<T>(input.scene, Acceleration::kFast,
                                                      renderer::build_on(*workers));
                                    return Builder::Built{threads == 1 ? watch.process_seconds()
                                                                       : watch.wall_seconds(),
                                                          tree_bytes(scene)};
                                }});
        }
    }
#ifdef COBBLE_BENCH_EMBREE
    const std::size_t theirs = stored_primitives(input.for_peers());
    for (const unsigned threads : choice.threads) {
        for (const bool robust : {true, false}) {
            const std::string name = robust ? std::string(kRobust) : "embree-fast";
            if (!chosen(choice.cores, name)) continue;
            builders.push_back({name, threads, theirs, [&input, robust, threads] {
                                    const EmbreeScene scene(input.for_peers(), {}, robust, threads);
                                    return Builder::Built{
                                        threads == 1 ? scene.cpu_seconds() : scene.wall_seconds(),
                                        static_cast<std::uint64_t>(scene.bytes())};
                                }});
        }
    }
#endif
    return builders;
}

}  // namespace

template <typename T>
std::uint64_t run_input(const Input& input, const Choice& choice, Report& report) {
    report.begin_input(input.name, input.title, sizeof(T) == sizeof(float) ? "float" : "double");
    std::uint64_t differences = 0;
    const bool any_rays = std::any_of(kRayKinds.begin(), kRayKinds.end(), [&](const RayKind& kind) {
        return has_kind(choice, kind.name);
    });
    if (any_rays) {
        const auto reference = prepare_as<T>(input.scene, Acceleration::kBvh);
        const auto fast = prepare_as<T>(input.scene, Acceleration::kFast);
#ifdef COBBLE_BENCH_EMBREE
        const EmbreeScene robust(input.for_peers(), reference.origin, true, 2);
        const EmbreeScene quick(input.for_peers(), reference.origin, false, 2);
#endif
        for (const RaySet<T>& rays : make_ray_sets(reference, input, choice.size)) {
            if (!has_kind(choice, rays.kind.name) || rays.rays.empty()) continue;
            KindResult result;
            result.kind = rays.kind.name;
            result.rays = rays.rays.size();
            const auto hits = std::count_if(rays.expected.begin(), rays.expected.end(),
                                            [](const auto& hit) { return bool(hit); });
            result.hit_share = static_cast<double>(hits) / static_cast<double>(result.rays);
            result.differences = count_differences(reference, fast, rays);
            differences += result.differences;
            auto all = cobble_contestants(reference, fast, rays);
#ifdef COBBLE_BENCH_EMBREE
            for (auto& peer : embree_contestants(robust, quick, rays)) {
                all.push_back(std::move(peer));
            }
            const Disagreement other = count_disagreements(robust, rays);
            result.disagreements = PeerCheck{other.hits, other.distances};
#endif
            const auto contestants = entrants(all, choice);
            const auto timings = measure(contestants, result.rays, choice.effort);
            result.cores = summarise(contestants, timings, result.rays);
            report.add(result);
        }
    }
    if (has_kind(choice, "build")) {
        renderer::use_instruction_set("");
        report.add(measure_builds(builders_for<T>(input, choice), choice.effort));
    }
    return differences;
}

template std::uint64_t run_input<float>(const Input&, const Choice&, Report&);
template std::uint64_t run_input<double>(const Input&, const Choice&, Report&);

}  // namespace cobble::bench
