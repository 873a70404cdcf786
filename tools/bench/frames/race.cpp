// SPDX-License-Identifier: MIT
#include "tools/bench/frames/race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tools/bench/frames/compare.hpp"
#include "tools/bench/median.hpp"

namespace cobble::bench {

namespace {

/// What a program needs, and what its passes gave.
struct Entry {
    const Program* program;
    std::string scene, picture;
    std::vector<double> parse, prepare, wall, cpu;
    FrameResult result;
};

/// Processor seconds of everything but the picture, or nearly.
double cpu_without_picture(const Entry& entry, ScenePlan plan, unsigned threads) {
    plan.width = plan.height = 16;
    return run_child(
               entry.program->command(entry.scene, entry.picture + ".small.png", plan, threads))
        .cpu;
}

void run_pass(Entry& entry, const ScenePlan& plan, const RaceOptions& options) {
    const Program& program = *entry.program;
    const auto command = program.command(entry.scene, entry.picture, plan, options.threads);
    const ChildResult child = run_child(command);
    const auto phases = child.ran ? program.phases(child, entry.picture) : std::optional<Phases>();
    if (!phases) {
        entry.result.failed = true;
        fmt::print(stderr, "bench_frames: {} failed on {}:\n{}\n", program.name,
                   entry.result.picture, child.text);
        return;
    }
    entry.parse.push_back(phases->parse);
    entry.prepare.push_back(phases->prepare);
    entry.result.renders.push_back(phases->render);
    if (phases->camera_rays) {
        entry.result.rays_a_pixel =
            *phases->camera_rays / (static_cast<double>(plan.width) * plan.height);
    }
    entry.wall.push_back(child.wall);
    entry.cpu.push_back(child.cpu);
    if (options.render_cpu) {
        entry.result.render_cpus.push_back(
            phases->render_cpu ? *phases->render_cpu
                               : child.cpu - cpu_without_picture(entry, plan, options.threads));
    }
    entry.result.peak_mb = std::max(entry.result.peak_mb, child.peak_mb);
}

}  // namespace

std::vector<FrameResult> race(const Input& input, const ScenePlan& plan, const RaceOptions& options,
                              const std::vector<Program>& programs) {
    std::vector<Entry> entries;
    for (const Program& program : programs) {
        if (plan.picture.glass && !program.renders_glass) continue;
        Entry entry{
            &program,
            program.write(input, plan),
            fmt::format("{}/{}-{}-{}.png", plan.folder, input.name, program.name, plan.samples),
            {},
            {},
            {},
            {},
            {}};
        entry.result.picture = input.name;
        entry.result.program = program.name;
        entry.result.samples = plan.samples;
        entry.result.threads = options.threads;
        entry.result.failed = entry.scene.empty();
        entries.push_back(std::move(entry));
    }
    for (std::size_t pass = 0; pass < options.passes; ++pass) {
        for (Entry& entry : entries) {
            if (!entry.result.failed) run_pass(entry, plan, options);
        }
    }
    std::vector<FrameResult> results;
    const Entry& first = entries.front();
    for (Entry& entry : entries) {
        FrameResult& result = entry.result;
        if (!result.failed) {
            result.phases.parse = median(entry.parse);
            result.phases.prepare = median(entry.prepare);
            result.phases.render = median(result.renders);
            result.wall = median(entry.wall);
            result.cpu = median(entry.cpu);
            if (!first.result.failed && &entry != &first) {
                result.times_cobble = speed_ratio(first.result.renders, result.renders);
                if (options.render_cpu) {
                    result.times_cobble_cpu =
                        speed_ratio(first.result.render_cpus, result.render_cpus);
                }
                if (!plan.picture.glass || entry.program->refracts) {
                    result.difference =
                        picture_difference(first.picture, first.program->enlargement(plan),
                                           entry.picture, entry.program->enlargement(plan));
                }
            }
        }
        results.push_back(result);
    }
    return results;
}

}  // namespace cobble::bench
