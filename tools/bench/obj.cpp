// SPDX-License-Identifier: MIT
// Megabytes of OBJ text a second, one thread, beside tinyobjloader on the same text in one run.
//
//   bench_obj [--json] [--megabytes N]
//
// The text is a wavy sheet with texture coordinates and normals, numbers of six decimals as
// modelling programs write them. Each figure is the best of three passes over text in memory.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/assets/obj/obj_file.hpp"
#include "ir/math/elementary.hpp"
#include "tools/bench/report.hpp"
#include "tools/bench/timing.hpp"

namespace {

namespace ir = cobble::ir;

/// A grid of n x n vertices; some 180 bytes each with its normal, coordinates and two faces.
std::string sheet(unsigned n) {
    std::string text = "# a wavy sheet\n";
    auto out = std::back_inserter(text);
    for (unsigned y = 0; y < n; ++y) {
        for (unsigned x = 0; x < n; ++x) {
            const double u = static_cast<double>(x) / n;
            const double v = static_cast<double>(y) / n;
            const auto a = cobble::math::sincos(20 * u);
            const auto b = cobble::math::sincos(30 * v);
            fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", 100 * u - 50, a.sin * b.sin,
                           100 * v - 50);
            fmt::format_to(out, "vt {:.6f} {:.6f}\n", u, v);
            fmt::format_to(out, "vn {:.6f} {:.6f} {:.6f}\n", a.cos * b.sin, 1.0, a.sin * b.cos);
        }
    }
    for (unsigned y = 0; y + 1 < n; ++y) {
        for (unsigned x = 0; x + 1 < n; ++x) {
            const unsigned a = y * n + x + 1;
            const unsigned b = a + 1;
            const unsigned c = a + n;
            const unsigned d = c + 1;
            fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a, c, b);
            fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", b, c, d);
        }
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("OBJ reading, beside tinyobjloader");
    bool json = false;
    double megabytes = 50;
    app.add_flag("--json", json, "print JSON");
    app.add_option("--megabytes", megabytes, "size of the text")->check(CLI::Range(1.0, 1000.0));
    CLI11_PARSE(app, argc, argv);

    // Bytes per vertex depend little on the size; measured on a small sheet.
    const double per_vertex = static_cast<double>(sheet(200).size()) / (200.0 * 200.0);
    const auto n = static_cast<unsigned>(std::sqrt(megabytes * 1e6 / per_vertex));
    const std::string text = sheet(n);
    const double size = static_cast<double>(text.size()) / 1e6;

    using cobble::bench::best_seconds;
    constexpr int kPasses = 3;
    ir::ObjFile file;
    const double ours = best_seconds(0, kPasses, [&] {
        file = ir::read_obj(text, ir::ObjRules::kStandard, 1U << 28);
        return 0;
    });
    std::size_t their_faces = 0;
    const double theirs = best_seconds(0, kPasses, [&] {
        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warning;
        std::string error;
        std::istringstream in(text);
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in);
        their_faces = shapes.empty() ? 0 : shapes[0].mesh.num_face_vertices.size();
        return 0;
    });
    if (file.problem_count > 0 || file.faces.size() != their_faces) {
        fmt::print(stderr, "the readers disagree: {} and {} faces\n", file.faces.size(),
                   their_faces);
        return 1;
    }
    ir::Mesh mesh;
    mesh.positions = file.positions;
    mesh.faces = file.faces;
    const double normals = best_seconds(0, kPasses, [&] {
        ir::compute_normals(mesh, ir::NormalRule::kCreaseAngle, 60);
        return 0;
    });

    if (json) {
        const nlohmann::ordered_json result{
            {"megabytes", size},
            {"faces", file.faces.size()},
            {"cobble_mb_per_s", size / ours},
            {"tinyobjloader_mb_per_s", size / theirs},
            {"ratio", theirs / ours},
            {"crease_normals_faces_per_s", static_cast<double>(file.faces.size()) / normals}};
        std::cout << result.dump(2) << '\n';
        return 0;
    }
    constexpr auto kSpeed = cobble::bench::at_least(300);
    fmt::print("== Meshes: {:.1f} MB of OBJ text in memory, {} faces, one thread\n\n", size,
               file.faces.size());
    fmt::print("{:<28}{:>8.0f} MB/s  {:.1f} times as fast as tinyobjloader  {}\n", "cobble",
               size / ours, theirs / ours, kSpeed.verdict(size / ours));
    fmt::print("{:<28}{:>8.0f} MB/s\n", "tinyobjloader", size / theirs);
    fmt::print("{:<28}{:>8.2f} million faces/s\n\n", "normals by crease angle",
               static_cast<double>(file.faces.size()) / normals / 1e6);
    return 0;
}
