// SPDX-License-Identifier: MIT
// Whole pictures by the program itself, one thread: rays of all kinds a second, shading included,
// in float and in double.
//
//   bench_pictures [--json]
//
// 240x160 pixels, 4 samples; what `cobble render --stats` says of its render phase.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tools/bench/timing.hpp"

namespace {

/// The program's statistics of one scene; exits if it cannot render it.
nlohmann::json stats_of(const std::string& scene, const char* precision) {
    const cobble::bench::TemporaryFile picture("", ".pfm");
    const cobble::bench::TemporaryFile stats("", ".json");
    if (!cobble::bench::run_process({COBBLE_PROGRAM, "render", scene, "-o", picture.path(),
                                     "--stats", stats.path(), "--precision", precision, "--size",
                                     "240x160", "--samples", "4", "--threads", "1", "--quiet"})) {
        fmt::print(stderr, "cobble render {} failed\n", scene);
        std::exit(1);
    }
    return nlohmann::json::parse(std::ifstream(stats.path()));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"rays a second of whole pictures, one thread"};
    bool json = false;
    app.add_flag("--json", json, "the programs' statistics as one JSON array");
    CLI11_PARSE(app, argc, argv);

    auto all = nlohmann::json::array();
    if (!json) {
        fmt::print("== Pictures: 240x160, 4 samples, one thread, shading included\n\n");
        fmt::print("{:<28}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}{:>9}{:>10}\n", "thousand rays", "camera",
                   "shadow", "mirrored", "refract.", "Mrays/s", "Mrays/s", "float :", "prepare");
        fmt::print("{:<28}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}{:>9}{:>10}\n", "", "", "", "", "",
                   "float", "double", "double", "ms, float");
    }
    for (const char* name : {"basics/phong", "basics/mirror_glass", "basics/depth_of_field",
                             "village/village", "village/night"}) {
        const std::string scene = fmt::format("{}/scenes/{}.scene", COBBLE_ROOT, name);
        const nlohmann::json in_float = stats_of(scene, "float");
        const nlohmann::json in_double = stats_of(scene, "double");
        if (json) {
            all.push_back({{"scene", name}, {"float", in_float}, {"double", in_double}});
            continue;
        }
        const auto thousand = [&](const char* kind) {
            return in_float["rays"][kind].get<double>() / 1000;
        };
        const double fast = in_float["rays_per_second"].get<double>() * 1e-6;
        const double exact = in_double["rays_per_second"].get<double>() * 1e-6;
        double preparing = 0;
        for (const auto& phase : in_float["phases"]) {
            if (phase["name"] != "render" && phase["name"] != "write") {
                preparing += phase["seconds"].get<double>() * 1e3;
            }
        }
        fmt::print("{:<28}{:>9.0f}{:>9.0f}{:>9.0f}{:>9.0f}{:>9.2f}{:>11.2f}{:>9.1f}{:>10.1f}\n",
                   name, thousand("camera"), thousand("shadow"), thousand("reflected"),
                   thousand("refracted"), fast, exact, fast / exact, preparing);
    }
    if (json) fmt::print("{}\n", all.dump(2));
    fmt::print("{}", json ? "" : "\n");
    return 0;
}
