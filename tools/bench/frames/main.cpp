// SPDX-License-Identifier: MIT
// Whole pictures: Cobble beside POV-Ray, Tachyon and the least of a renderer over Embree, each as
// far as it is installed.
#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/bench/frames/race.hpp"
#include "tools/bench/frames/summary.hpp"
#include "tools/bench/machine.hpp"
#ifdef COBBLE_BENCH_EMBREE
#include "renderer/picture/picture_io.hpp"
#include "tools/bench/frames/embree_renderer.hpp"
#endif

namespace {

using namespace cobble::bench;

struct Options {
    std::vector<std::string> pictures, programs;
    std::vector<unsigned> samples{16}, threads{1, 2};
    unsigned width = 1024, height = 768;
    std::size_t passes = 3;
    bool cpu = false;
    ProgramPaths paths;
    std::string keep;
    bool json = false;
};

std::string description() {
    std::string text =
        "Renders the same pictures with Cobble and, as far as they are installed, POV-Ray, "
        "Tachyon\n"
        "and the least of a renderer over Embree (packets of 16; it was there when this was "
        "built).\n"
        "Programs take turns; figures are medians over passes. Seconds are wall time but for cpu,\n"
        "which is all threads' processor time; parse is reading the scene (Embree: filling\n"
        "buffers). With --cpu, \"r. cpu\" is the processor time of rendering, what others disturb\n"
        "least on a shared machine: as Cobble and the renderer over Embree say, without writing "
        "the\n"
        "picture, else all beyond that for a picture of 16 x 16 pixels, so rendering and writing,\n"
        "of which writing is a few per cent. \"rays\" is how many the camera sent through a pixel, "
        "where\n"
        "the program says (POV-Ray's picture is four times as wide and high instead).\n"
        "\"x cobble\" is how many times as long as Cobble a program renders, \"by cpu\" the same "
        "by\n"
        "that time, and \"differs\" how far its picture is from Cobble's, as the mean over all\n"
        "channels from 0 to 1.\n\nPictures:\n";
    for (const PictureName& picture : picture_names()) {
        text += fmt::format("  {:<12}{}\n", picture.name, picture.what);
    }
    return text;
}

#ifdef COBBLE_BENCH_EMBREE
int render_for_parent(const std::string& picture, const std::string& to, const Options& options) {
    ScenePlan plan;
    plan.width = options.width;
    plan.height = options.height;
    plan.samples = options.samples.front();
    const EmbreeFrame frame =
        render_with_embree(make_picture(picture), plan, options.threads.front());
    fmt::print("{}", phases_text({frame.make_seconds, frame.prepare_seconds, frame.render_seconds,
                                  frame.render_cpu, frame.camera_rays}));
    const auto encoded =
        cobble::renderer::encode(frame.color, cobble::renderer::PictureFormat::kPng);
    return write_text(to, encoded.bytes) ? 0 : 1;
}
#endif

void print_header(const std::string& title, unsigned samples, unsigned threads) {
    fmt::print("\n{}; {} a pixel, {} thread{}\n", title, samples, threads, threads == 1 ? "" : "s");
    fmt::print("  {:<18}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>7}{:>10}{:>10}{:>9}\n", "program",
               "parse", "prepare", "render", "whole", "cpu", "r. cpu", "MB", "rays", "x cobble",
               "by cpu", "differs");
}

std::string text_of(const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

void print_row(const FrameResult& r) {
    if (r.failed) {
        fmt::print("  {:<18}  failed\n", r.program);
    } else {
        fmt::print(
            "  {:<18}{:>9.3f}{:>9.3f}{:>9.3f}{:>9.3f}{:>9.3f}{:>9}{:>9.0f}{:>7}{:>10}{:>10}{:>9}\n",
            r.program, r.phases.parse, r.phases.prepare, r.phases.render, r.wall, r.cpu,
            text_of(render_cpu(r), 3), r.peak_mb, text_of(r.rays_a_pixel, 0),
            text_of(r.times_cobble, 2), text_of(r.times_cobble_cpu, 2), text_of(r.difference, 4));
    }
    std::fflush(stdout);
}

void print_ratios(const std::vector<Ratio>& ratios) {
    if (ratios.empty()) return;
    fmt::print("\nrender time, as ratios\n  {:<55}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "", "a pixel",
               "threads", "by wall", "by cpu", "aim");
    for (const Ratio& r : ratios) {
        fmt::print("  {:<55}{:>9}{:>9}{:>9.2f}{:>9}{:>9}\n", r.what, r.samples, r.threads,
                   r.by_wall, text_of(r.by_cpu, 2), text_of(r.wanted, 2));
    }
}

nlohmann::json json_of(const FrameResult& r) {
    nlohmann::json entry{{"picture", r.picture},
                         {"program", r.program},
                         {"samples", r.samples},
                         {"threads", r.threads},
                         {"failed", r.failed}};
    if (r.failed) return entry;
    entry["seconds"] = {{"parse", r.phases.parse},
                        {"prepare", r.phases.prepare},
                        {"render", r.phases.render},
                        {"whole", r.wall},
                        {"cpu", r.cpu}};
    entry["passes"] = r.renders.size();
    entry["peak_megabytes"] = r.peak_mb;
    if (r.times_cobble) entry["times_cobble"] = *r.times_cobble;
    if (const auto cpu = render_cpu(r)) entry["seconds"]["render_cpu"] = *cpu;
    if (r.times_cobble_cpu) entry["times_cobble_cpu"] = *r.times_cobble_cpu;
    if (r.difference) entry["difference"] = *r.difference;
    if (r.rays_a_pixel) entry["rays_a_pixel"] = *r.rays_a_pixel;
    return entry;
}

nlohmann::json json_of(const Ratio& r) {
    nlohmann::json entry{
        {"what", r.what}, {"samples", r.samples}, {"threads", r.threads}, {"ratio", r.by_wall}};
    if (r.by_cpu) entry["ratio_by_cpu"] = *r.by_cpu;
    if (r.wanted) entry["aim"] = *r.wanted;
    return entry;
}

int race_all(const Options& options, const std::string& folder) {
    std::vector<Program> programs = find_programs(options.paths);
    std::erase_if(programs, [&](const Program& p) {
        return !options.programs.empty() &&
               std::find(options.programs.begin(), options.programs.end(), p.name) ==
                   options.programs.end();
    });
    if (programs.empty()) {
        fmt::print(stderr, "bench_frames: none of the programs is there\n");
        return 2;
    }
    const std::string load = load_now();
    if (!options.json) fmt::print("{}, load {}\n", processor(), load);
    std::vector<FrameResult> all;
    for (const PictureName& picture : picture_names()) {
        if (std::find(options.pictures.begin(), options.pictures.end(), picture.name) ==
            options.pictures.end()) {
            continue;
        }
        const Input input = make_picture(picture.name);
        for (const unsigned samples : options.samples) {
            const ScenePlan plan{picture, options.width, options.height, samples, folder};
            for (const unsigned threads : options.threads) {
                const auto results = race(
                    input, plan, {threads, options.passes, options.cpu && threads == 1}, programs);
                all.insert(all.end(), results.begin(), results.end());
                if (options.json) continue;
                print_header(std::string(picture.name) + ": " + input.title, samples, threads);
                for (const FrameResult& result : results) print_row(result);
            }
        }
    }
    const std::vector<Ratio> ratios = ratios_of(all);
    if (!options.json) {
        print_ratios(ratios);
        fmt::print("\nload at the end {}\n", load_now());
    } else {
        nlohmann::json out{{"processor", processor()},         {"load_at_begin", load},
                           {"load_at_end", load_now()},        {"width", options.width},
                           {"height", options.height},         {"results", nlohmann::json::array()},
                           {"ratios", nlohmann::json::array()}};
        for (const FrameResult& r : all) out["results"].push_back(json_of(r));
        for (const Ratio& r : ratios) out["ratios"].push_back(json_of(r));
        fmt::print("{}\n", out.dump(2));
    }
    return std::any_of(all.begin(), all.end(), [](const FrameResult& r) { return r.failed; }) ? 1
                                                                                              : 0;
}

/// In a folder of its own, or in the one that is to be kept.
int race_in_folder(const Options& options) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (!options.keep.empty()) {
        fs::create_directories(options.keep, error);
        return race_all(options, options.keep);
    }
    std::string folder = (fs::temp_directory_path() / "bench_frames-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        fmt::print(stderr, "bench_frames: cannot make a folder for the scenes\n");
        return 2;
    }
    const int status = race_all(options, folder);
    fs::remove_all(folder, error);
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    std::vector<std::string> all_pictures;
    for (const PictureName& picture : picture_names()) all_pictures.emplace_back(picture.name);
    options.pictures = all_pictures;
    options.paths.cobble = COBBLE_PROGRAM;
    options.paths.self = "/proc/self/exe";

    CLI::App app{description()};
    app.add_option("--pictures", options.pictures, "some of the pictures, with commas between")
        ->delimiter(',')
        ->check(CLI::IsMember(all_pictures));
    app.add_option("--programs", options.programs,
                   "some of cobble, embree-packets, povray, tachyon, cobble-reference; the first "
                   "of these that runs is what others are compared with")
        ->delimiter(',');
    app.add_option("--samples", options.samples, "rays a pixel, 1 or 16 or 1,16")
        ->delimiter(',')
        ->check(CLI::IsMember({1U, 16U}));
    app.add_option("--threads", options.threads, "numbers of threads, with commas between")
        ->delimiter(',')
        ->check(CLI::Range(1U, 256U));
    app.add_option("--width", options.width)->check(CLI::Range(16U, 4096U));
    app.add_option("--height", options.height)->check(CLI::Range(16U, 4096U));
    app.add_option("--passes", options.passes, "how often each program runs")
        ->check(CLI::Range(1U, 1000U));
    app.add_flag("--cpu", options.cpu, "also the processor time of rendering alone, on one thread");
    app.add_option("--keep", options.keep, "a folder for scenes and pictures, which then stay");
    app.add_option("--cobble", options.paths.cobble, "the program to measure");
    app.add_option("--povray", options.paths.povray);
    app.add_option("--tachyon", options.paths.tachyon);
    app.add_flag("--json", options.json, "JSON instead of a table");
#ifdef COBBLE_BENCH_EMBREE
    std::string embree_renders;
    std::string to;
    app.add_option("--embree-renders", embree_renders)->group("");
    app.add_option("--to", to)->group("");
#endif
    CLI11_PARSE(app, argc, argv);
#ifdef COBBLE_BENCH_EMBREE
    if (!embree_renders.empty()) return render_for_parent(embree_renders, to, options);
#endif
    return race_in_folder(options);
}
