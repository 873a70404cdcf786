// SPDX-License-Identifier: MIT
#include "tools/bench/rays/report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "tools/bench/machine.hpp"

namespace cobble::bench {

namespace {

/// The columns of ratios: cores that others are compared with.
constexpr const char* kAgainst[] = {"embree-robust-1", "embree-robust-8", "embree-robust-16",
                                    "cobble-reference"};

std::string ratio_text(const CoreResult& result, const std::string& other) {
    for (const auto& [name, value] : result.ratios) {
        if (name == other) return fmt::format("{:.2f}", value);
    }
    return "-";
}

}  // namespace

void Report::begin() {
    all_ = {{"processor", processor()},
            {"load_at_begin", load_now()},
            {"inputs", nlohmann::json::array()}};
    if (!json_) fmt::print("{}, load {}\n", processor(), load_now());
}

void Report::begin_input(const std::string& name, const std::string& title,
                         const std::string& scalar) {
    all_["inputs"].push_back({{"name", name},
                              {"title", title},
                              {"scalar", scalar},
                              {"kinds", nlohmann::json::array()},
                              {"builds", nlohmann::json::array()}});
    if (json_) return;
    fmt::print("\n{}: {}, {}\n", name, title, scalar);
    std::fflush(stdout);
}

void Report::add(const KindResult& result) {
    auto cores = nlohmann::json::array();
    for (const CoreResult& core : result.cores) {
        nlohmann::json entry{{"core", core.core},
                             {"threads", core.threads},
                             {"passes", core.passes},
                             {"mrays_per_second", core.rate},
                             {"lower_quartile", core.slow},
                             {"upper_quartile", core.fast},
                             {"ratios", nlohmann::json::object()}};
        for (const auto& [name, value] : core.ratios) entry["ratios"][name] = value;
        if (core.scaling) entry["scaling"] = *core.scaling;
        cores.push_back(std::move(entry));
    }
    nlohmann::json kind{{"kind", result.kind},
                        {"rays", result.rays},
                        {"hit_share", result.hit_share},
                        {"differences_from_reference", result.differences},
                        {"cores", std::move(cores)}};
    if (result.disagreements) {
        kind["embree_disagrees"] = {{"hits", result.disagreements->hits},
                                    {"distances", result.disagreements->distances}};
    }
    all_["inputs"].back()["kinds"].push_back(std::move(kind));
    if (json_) return;

    fmt::print("  {}: {} rays, {:.0f} % hit; {} differ from the reference", result.kind,
               result.rays, 100 * result.hit_share, result.differences);
    if (result.disagreements) {
        fmt::print("; embree: {} other hits, {} other distances", result.disagreements->hits,
                   result.disagreements->distances);
    }
    fmt::print("\n    {:<24}{:>3}{:>9}{:>17}{:>13}{:>13}{:>13}{:>13}{:>9}\n", "core", "thr",
               "Mrays/s", "quartiles", "/ robust-1", "/ robust-8", "/ robust-16", "/ reference",
               "/ 1 thr");
    for (const CoreResult& core : result.cores) {
        fmt::print("    {:<24}{:>3}{:>9.2f}{:>17}", core.core, core.threads, core.rate,
                   fmt::format("{:.2f} - {:.2f}", core.slow, core.fast));
        for (const char* const other : kAgainst) fmt::print("{:>13}", ratio_text(core, other));
        fmt::print("{:>9}\n", core.scaling ? fmt::format("{:.2f}", *core.scaling) : "-");
    }
    std::fflush(stdout);
}

void Report::add(const std::vector<BuildResult>& builds) {
    if (!json_) {
        fmt::print("  build:\n    {:<24}{:>3}{:>10}{:>12}{:>12}{:>11}{:>13}\n", "core", "thr",
                   "seconds", "Mprims/s", "bytes/prim", "MB", "/ robust");
    }
    for (const BuildResult& build : builds) {
        const auto primitives = static_cast<double>(build.primitives);
        const auto bytes = static_cast<double>(build.bytes);
        nlohmann::json entry{
            {"core", build.core},       {"threads", build.threads},
            {"seconds", build.seconds}, {"primitives", build.primitives},
            {"bytes", build.bytes},     {"bytes_per_primitive", bytes / primitives}};
        if (build.ratio) entry["ratio"] = *build.ratio;
        all_["inputs"].back()["builds"].push_back(std::move(entry));
        if (json_) continue;
        fmt::print("    {:<24}{:>3}{:>10.4f}{:>12.2f}{:>12.1f}{:>11.1f}{:>13}\n", build.core,
                   build.threads, build.seconds, primitives / build.seconds * 1e-6,
                   bytes / primitives, bytes * 1e-6,
                   build.ratio ? fmt::format("{:.2f}", *build.ratio) : "-");
    }
    std::fflush(stdout);
}

void Report::end() {
    all_["load_at_end"] = load_now();
    if (json_) {
        fmt::print("{}\n", all_.dump(2));
    } else {
        fmt::print("\nload at the end {}\n", load_now());
    }
}

}  // namespace cobble::bench
