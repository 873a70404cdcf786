// SPDX-License-Identifier: MIT
#include "tools/bench/frames/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "tools/bench/median.hpp"

namespace cobble::bench {

namespace {

/// What Cobble aims at with 16 rays a pixel.
struct Aim {
    std::string_view picture, program;
    double ratio;
};
constexpr std::array<Aim, 8> kAims{{
    {"mesh", "povray", 10},
    {"mesh", "tachyon", 4},
    {"mesh", "embree-packets", 1},
    {"boxes", "povray", 8},
    {"boxes", "tachyon", 8},
    {"spheres", "povray", 4},
    {"spheres", "tachyon", 3},
    {"glass", "povray", 4.5},
}};
constexpr double kTwoThreads = 1.85;

std::optional<double> aim_of(std::string_view picture, std::string_view program, unsigned samples) {
    if (samples != 16) return {};
    for (const Aim& aim : kAims) {
        if (aim.picture == picture && aim.program == program) return aim.ratio;
    }
    return {};
}

const FrameResult* find(const std::vector<FrameResult>& all, std::string_view picture,
                        std::string_view program, unsigned samples, unsigned threads) {
    for (const FrameResult& r : all) {
        if (r.picture == picture && r.program == program && r.samples == samples &&
            r.threads == threads && !r.failed) {
            return &r;
        }
    }
    return nullptr;
}

/// Of a peer on one picture: the median over passes, which are compared turn by turn.
std::optional<Ratio> of_peer(const FrameResult& r) {
    if (!r.times_cobble) return {};
    return Ratio{fmt::format("{}: {} over cobble", r.picture, r.program),
                 r.samples,
                 r.threads,
                 *r.times_cobble,
                 r.times_cobble_cpu,
                 aim_of(r.picture, r.program, r.samples)};
}

/// Blocks, which peers take as boxes or as triangles, against Cobble's boxes.
std::optional<Ratio> of_faster_form(const std::vector<FrameResult>& all, const FrameResult& boxes) {
    const FrameResult* const cobble = find(all, "boxes", "cobble", boxes.samples, boxes.threads);
    const FrameResult* const blocks =
        find(all, "blocks", boxes.program, boxes.samples, boxes.threads);
    if (cobble == nullptr || blocks == nullptr) return {};
    Ratio ratio{fmt::format("blocks: {}'s faster form over cobble's boxes", boxes.program),
                boxes.samples,
                boxes.threads,
                std::min(boxes.phases.render, blocks->phases.render) / cobble->phases.render,
                {},
                aim_of("boxes", boxes.program, boxes.samples)};
    const auto ours = render_cpu(*cobble);
    const auto as_boxes = render_cpu(boxes);
    const auto as_blocks = render_cpu(*blocks);
    if (ours && as_boxes && as_blocks) ratio.by_cpu = std::min(*as_boxes, *as_blocks) / *ours;
    return ratio;
}

std::optional<Ratio> of_threads(const std::vector<FrameResult>& all, const FrameResult& r) {
    const FrameResult* const one = find(all, r.picture, r.program, r.samples, 1);
    if (one == nullptr) return {};
    return Ratio{fmt::format("{}: {}, one thread over {}", r.picture, r.program, r.threads),
                 r.samples,
                 r.threads,
                 one->phases.render / r.phases.render,
                 {},
                 r.threads == 2 && r.samples == 16 && r.program == "cobble"
                     ? std::optional(kTwoThreads)
                     : std::nullopt};
}

}  // namespace

std::optional<double> render_cpu(const FrameResult& result) {
    return result.render_cpus.empty() ? std::nullopt : std::optional(median(result.render_cpus));
}

std::vector<Ratio> ratios_of(const std::vector<FrameResult>& results) {
    std::vector<Ratio> ratios;
    const auto add = [&ratios](const std::optional<Ratio>& ratio) {
        if (ratio) ratios.push_back(*ratio);
    };
    for (const FrameResult& r : results) {
        if (r.failed) continue;
        if (r.program == "cobble-reference") continue;
        const bool blocks = r.picture == "boxes" || r.picture == "blocks";
        if (r.program != "cobble") {
            if (!blocks) {
                add(of_peer(r));
            } else if (r.picture == "boxes") {
                add(of_faster_form(results, r));
            }
        }
        if (r.threads > 1) add(of_threads(results, r));
    }
    return ratios;
}

}  // namespace cobble::bench
