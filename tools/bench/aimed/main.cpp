// SPDX-License-Identifier: MIT
// bench_aimed [--rays N] [--seed S] [--json FILE]: shoots rays at the edges, vertices and outlines
// of the hard cases' scenes (tests/hard/aims.hpp) through the fast core, by every instruction set,
// ray by ray, in batches and in packets, and counts those that slip through closed things, and
// answers that differ between instruction sets or from brute force. Ends with 1 if there are any.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/fp_environment.hpp"
#include "tests/hard/aims.hpp"

namespace {

using namespace cobble;
using renderer::Counters;
using renderer::Exclude;
using renderer::Hit;
using renderer::PreparedScene;
using renderer::Ray;

struct Counts {
    std::uint64_t rays = 0;     ///< distinct ones
    std::uint64_t answers = 0;  ///< by all instruction sets and in all ways
    std::uint64_t leaks = 0;    ///< answers "nothing" where something cannot be missed
    std::uint64_t differ = 0;   ///< answers unlike the first instruction set's, ray by ray
    std::uint64_t checked = 0;  ///< rays that brute force was asked about
    std::uint64_t packed = 0;   ///< answers that were found in packets
    std::uint64_t wrong = 0;    ///< of those, answered otherwise

    void add(const Counts& c) {
        rays += c.rays;
        answers += c.answers;
        leaks += c.leaks;
        differ += c.differ;
        checked += c.checked;
        packed += c.packed;
        wrong += c.wrong;
    }
    [[nodiscard]] bool clean() const { return leaks + differ + wrong == 0; }
};

/// One batch of rays, and room for its answers.
template <typename T>
struct Batch {
    explicit Batch(std::size_t count)
        : rays(count), excludes(count), first(count), hits(count), any(count) {}
    std::vector<Ray<T>> rays;
    std::vector<Exclude> excludes;
    std::vector<Hit<T>> first;
    std::vector<Hit<T>> hits;
    std::vector<std::uint8_t> any;
};

template <typename T>
void compare(const Batch<T>& batch, bool closed, Counts& counts) {
    counts.answers += batch.hits.size();
    for (std::size_t i = 0; i < batch.hits.size(); ++i) {
        if (closed && !batch.hits[i]) ++counts.leaks;
        if (!test::same(batch.hits[i], batch.first[i])) ++counts.differ;
    }
}

template <typename T>
void compare_any(const Batch<T>& batch, bool closed, Counts& counts) {
    counts.answers += batch.any.size();
    for (std::size_t i = 0; i < batch.any.size(); ++i) {
        if (closed && batch.any[i] == 0) ++counts.leaks;
        if ((batch.any[i] != 0) != batch.first[i].object.valid()) ++counts.differ;
    }
}

/// All instruction sets and ways; the first one's single rays are what the others are held against.
template <typename T>
void ask(const PreparedScene<T>& scene, bool closed, Batch<T>& batch, Counts& counts) {
    Counters counters;
    const auto rays = std::span<const Ray<T>>(batch.rays);
    const auto excludes = std::span<const Exclude>(batch.excludes);
    bool begun = false;
    for (const std::string& name : renderer::instruction_sets()) {
        renderer::use_instruction_set(name);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            batch.hits[i] = closest_hit(scene, rays[i], excludes[i], counters);
        }
        if (!begun) batch.first = batch.hits;
        begun = true;
        compare(batch, closed, counts);
        for (const auto coherence : {renderer::Coherence::kNone, renderer::Coherence::kCoherent}) {
            closest_hits(scene, rays, excludes, std::span(batch.hits), counters, coherence);
            compare(batch, closed, counts);
            any_hits(scene, rays, excludes, std::span(batch.any), counters, coherence);
            compare_any(batch, closed, counts);
        }
    }
    renderer::use_instruction_set("");
    counts.packed += counters.packet_rays;
}

template <typename T>
Counts shoot(const test::Aim& aim, std::uint64_t rays, std::uint64_t seed) {
    constexpr std::uint64_t kBatch = 4096;
    constexpr std::size_t kCheckEach = 509;  // brute force is slow; of each bundle another one
    const renderer::FpEnvironment environment;
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    const auto fast = renderer::prepare<T>(aim.scene, options);
    const auto reference = renderer::prepare<T>(aim.scene);
    test::Random random(seed);
    Counts counts;
    Counters counters;
    while (counts.rays < rays) {
        Batch<T> batch(static_cast<std::size_t>(std::min(kBatch, rays - counts.rays)));
        // Half of them in bundles: rays that each go their own way make no packets.
        auto* next = batch.rays.data();
        test::aim_rays(aim, batch.rays.size(), batch.rays.size() / 2, random,
                       [&](const test::AimedRay& r) { *next++ = test::local_ray(fast, r); });
        ask(fast, aim.closed, batch, counts);
        for (std::size_t i = 0; i < batch.rays.size(); i += kCheckEach) {
            const auto right =
                closest_hit_brute_force(reference, batch.rays[i], batch.excludes[i], counters);
            ++counts.checked;
            counts.wrong += test::same(right, batch.first[i]) ? 0 : 1;
        }
        counts.rays += batch.rays.size();
    }
    return counts;
}

nlohmann::ordered_json as_json(const Counts& c) {
    return {{"rays", c.rays},     {"answers", c.answers},   {"leaks", c.leaks},
            {"differ", c.differ}, {"in_packets", c.packed}, {"checked", c.checked},
            {"wrong", c.wrong}};
}

int run(std::uint64_t rays, std::uint64_t seed, const std::string& json_file) {
    const auto all = test::aims();
    const auto sets = renderer::instruction_sets();
    fmt::print("{} scenes; {}\n", all.size(), fmt::join(sets, ", "));
    nlohmann::ordered_json report;
    Counts total;
    for (const test::Aim& aim : all) {
        // One in ten in double, which is slower.
        const std::uint64_t share = rays / all.size() + 1;
        Counts counts = shoot<float>(aim, share - share / 10, seed);
        counts.add(shoot<double>(aim, share / 10, seed + 1));
        total.add(counts);
        fmt::print(
            "row {:2}  {:38} {:>10} rays {:>12} answers {:>11} in packets {:>3} leaks {:>3} differ "
            "{:>3} of {} wrong\n",
            aim.row, aim.name, counts.rays, counts.answers, counts.packed, counts.leaks,
            counts.differ, counts.wrong, counts.checked);
        std::fflush(stdout);
        auto entry = as_json(counts);
        entry["row"] = aim.row;
        entry["name"] = aim.name;
        report["scenes"].push_back(entry);
    }
    report["instruction_sets"] = sets;
    report["total"] = as_json(total);
    fmt::print(
        "total: {} rays, {} answers, {} of them in packets, {} leaks, {} differ, {} of {} unlike "
        "brute force\n",
        total.rays, total.answers, total.packed, total.leaks, total.differ, total.wrong,
        total.checked);
    if (!json_file.empty()) std::ofstream(json_file) << report.dump(2) << '\n';
    return total.clean() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("rays at the weak places of hard scenes, by every instruction set");
    std::uint64_t rays = 1000000;
    std::uint64_t seed = 1;
    std::string json_file;
    app.add_option("--rays", rays, "how many different ones, over all scenes");
    app.add_option("--seed", seed, "of the rays");
    app.add_option("--json", json_file, "write the counts to this file, too");
    CLI11_PARSE(app, argc, argv);
    return run(rays, seed, json_file);
}
