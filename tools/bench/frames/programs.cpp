// SPDX-License-Identifier: MIT
#include "tools/bench/frames/programs.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

namespace cobble::bench {

namespace {

/// The number behind the last `label` in `text`, and behind `then` after it.
std::optional<double> number_after(std::string_view text, std::string_view label,
                                   std::string_view then = "") {
    const auto at = text.rfind(label);
    if (at == std::string_view::npos) return {};
    const auto next = text.find(then, at + label.size());
    if (next == std::string_view::npos) return {};
    return std::strtod(text.data() + next + then.size(), nullptr);
}

unsigned same_size(const ScenePlan& /*plan*/) { return 1; }

unsigned side_of(const ScenePlan& plan) { return plan.samples == 1 ? 1 : 4; }

Program cobble_program(const std::string& executable, bool reference) {
    Program program;
    program.name = reference ? "cobble-reference" : "cobble";
    program.executable = executable;
    program.write = write_cobble_scene;
    program.command = [executable, reference](const auto& scene, const auto& picture,
                                              const ScenePlan& plan, unsigned threads) {
        std::vector<std::string> command{executable,  "render",
                                         scene,       "-o",
                                         picture,     "--quiet",
                                         "--size",    fmt::format("{}x{}", plan.width, plan.height),
                                         "--samples", std::to_string(plan.samples),
                                         "--threads", std::to_string(threads),
                                         "--bounces", std::to_string(kGlassBounces),
                                         "--stats",   picture + ".json"};
        if (plan.picture.glass) command.emplace_back("--no-shadows");
        if (reference) command.emplace_back("--reference");
        return command;
    };
    program.phases = [](const ChildResult& /*result*/,
                        const std::string& picture) -> std::optional<Phases> {
        std::ifstream file(picture + ".json");
        const auto stats = nlohmann::json::parse(file, nullptr, false);
        if (!stats.is_object() || !stats.contains("phases")) return {};
        Phases phases;
        for (const auto& phase : stats["phases"]) {
            const std::string name = phase["name"];
            const double seconds = phase["seconds"];
            if (name == "prepare") {
                phases.prepare += seconds;
            } else if (name == "render") {
                phases.render += seconds;
                phases.render_cpu = phase.value("processor_seconds", 0.0);
            } else if (name != "write") {
                phases.parse += seconds;
            }
        }
        if (stats.contains("rays")) phases.camera_rays = stats["rays"].value("camera", 0.0);
        return phases;
    };
    program.enlargement = same_size;
    return program;
}

/// Sixteen samples are a picture four times as wide and high: its own methods of sampling look at
/// the neighbours first, and leave out what they deem smooth (+AM1 +R4 +A0.0 -J, which leaves out
/// the least, traces 1 or 17 rays a pixel, at the same speed).
Program povray_program(const std::string& executable) {
    Program program;
    program.name = "povray";
    program.executable = executable;
    program.write = write_povray_scene;
    program.command = [executable](const auto& scene, const auto& picture, const ScenePlan& plan,
                                   unsigned threads) {
        const unsigned side = side_of(plan);
        return std::vector<std::string>{executable,
                                        "+I" + scene,
                                        "+O" + picture,
                                        fmt::format("+W{}", plan.width * side),
                                        fmt::format("+H{}", plan.height * side),
                                        "-A",
                                        "-D",
                                        "+FN8",
                                        "File_Gamma=1.0",
                                        fmt::format("+WT{}", threads)};
    };
    program.phases = [](const ChildResult& result,
                        const std::string& /*picture*/) -> std::optional<Phases> {
        const auto parse = number_after(result.text, "Parse Time:", "(");
        const auto trace = number_after(result.text, "Trace Time:", "(");
        if (!parse || !trace) return {};
        Phases phases{*parse, number_after(result.text, "Bounding Time:", "(").value_or(0), *trace,
                      number_after(result.text, "Trace Time:", "thread(s) with"),
                      number_after(result.text, "Pixels:")};
        return phases;
    };
    program.enlargement = side_of;
    return program;
}

Program tachyon_program(const std::string& executable) {
    Program program;
    program.name = "tachyon";
    program.executable = executable;
    program.refracts = false;
    program.write = write_tachyon_scene;
    program.command = [executable](const auto& scene, const auto& picture, const ScenePlan& plan,
                                   unsigned threads) {
        std::vector<std::string> command{executable,
                                         scene,
                                         "-o",
                                         picture,
                                         "-format",
                                         "PNG",
                                         "-numthreads",
                                         std::to_string(threads),
                                         "-res",
                                         std::to_string(plan.width),
                                         std::to_string(plan.height)};
        // Without shadows, and without what else that leaves out, none of which we ask for.
        if (plan.picture.glass) command.emplace_back("-mediumshade");
        return command;
    };
    program.phases = [](const ChildResult& result,
                        const std::string& /*picture*/) -> std::optional<Phases> {
        const auto trace = number_after(result.text, "Ray Tracing Time:");
        if (!trace) return {};
        return Phases{number_after(result.text, "Scene Parsing Time:").value_or(0),
                      number_after(result.text, "Preprocessing Time:").value_or(0),
                      *trace,
                      {},
                      {}};
    };
    program.enlargement = same_size;
    return program;
}

#ifdef COBBLE_BENCH_EMBREE
Program embree_program(const std::string& self) {
    Program program;
    program.name = "embree-packets";
    program.executable = self;
    program.renders_glass = false;
    // It makes the scene itself.
    program.write = [](const Input& input, const ScenePlan& /*plan*/) { return input.name; };
    program.command = [self](const auto& scene, const auto& picture, const ScenePlan& plan,
                             unsigned threads) {
        return std::vector<std::string>{self,
                                        "--embree-renders",
                                        scene,
                                        "--to",
                                        picture,
                                        "--width",
                                        std::to_string(plan.width),
                                        "--height",
                                        std::to_string(plan.height),
                                        "--samples",
                                        std::to_string(plan.samples),
                                        "--threads",
                                        std::to_string(threads)};
    };
    program.phases = [](const ChildResult& result,
                        const std::string& /*picture*/) -> std::optional<Phases> {
        const auto render = number_after(result.text, "render");
        if (!render) return {};
        return Phases{number_after(result.text, "parse").value_or(0),
                      number_after(result.text, "prepare").value_or(0), *render,
                      number_after(result.text, "processor"),
                      number_after(result.text, "camera rays")};
    };
    program.enlargement = same_size;
    return program;
}
#endif

}  // namespace

std::string phases_text(const Phases& phases) {
    return fmt::format("parse {} prepare {} render {} processor {} camera rays {}\n", phases.parse,
                       phases.prepare, phases.render, phases.render_cpu.value_or(0),
                       phases.camera_rays.value_or(0));
}

std::vector<Program> find_programs(const ProgramPaths& paths) {
    std::vector<Program> found;
    const auto add = [&found](Program program) {
        if (is_installed(program.executable)) found.push_back(std::move(program));
    };
    add(cobble_program(paths.cobble, false));
#ifdef COBBLE_BENCH_EMBREE
    add(embree_program(paths.self));
#endif
    add(povray_program(paths.povray));
    add(tachyon_program(paths.tachyon));
    add(cobble_program(paths.cobble, true));
    return found;
}

}  // namespace cobble::bench
