// SPDX-License-Identifier: MIT
// Valid files mean the same to this reader and to tinyobjloader.
#include <doctest/doctest.h>

#include <tiny_obj_loader.h>  // in double, as its library is built

#include <filesystem>
#include <random>
#include <sstream>

#include "ir/assets/obj/obj_file.hpp"
#include "tests/support/corpus.hpp"
#include "tests/support/disk.hpp"

using namespace cobble;
using namespace cobble::ir;

namespace {

void compare(const std::string& text) {
    const ObjFile ours = read_obj(text, ObjRules::kStandard, 1U << 24);
    REQUIRE(ours.problem_count == 0);

    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    std::istringstream in(text);
    // Its triangulation chooses diagonals of quads by length; cut fans here instead.
    REQUIRE(
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in, nullptr, false));

    REQUIRE(ours.positions.size() * 3 == attributes.vertices.size());
    REQUIRE(ours.uvs.size() * 2 == attributes.texcoords.size());
    REQUIRE(ours.normals.size() * 3 == attributes.normals.size());
    for (std::size_t i = 0; i < ours.positions.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            // Its own number parser is off by some units in the last place.
            REQUIRE(ours.positions[i][k] ==
                    doctest::Approx(attributes.vertices[3 * i + k]).epsilon(1e-14));
        }
    }
    for (std::size_t i = 0; i < ours.uvs.size(); ++i) {
        REQUIRE(ours.uvs[i].x == doctest::Approx(attributes.texcoords[2 * i]).epsilon(1e-14));
        REQUIRE(ours.uvs[i].y == doctest::Approx(attributes.texcoords[2 * i + 1]).epsilon(1e-14));
    }

    std::size_t at = 0;
    const auto same = [](std::uint32_t index, int theirs) {
        return theirs < 0 ? index == Mesh::kNone : index == static_cast<std::uint32_t>(theirs);
    };
    for (const auto& shape : shapes) {
        std::size_t first = 0;
        for (const auto count : shape.mesh.num_face_vertices) {
            for (std::size_t k = 2; k < count; ++k) {
                REQUIRE(at < ours.faces.size());
                const auto& corners = ours.faces[at++].corners;
                const std::array<std::size_t, 3> theirs{first, first + k - 1, first + k};
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto& index = shape.mesh.indices[theirs[c]];
                    REQUIRE(same(corners[c].position, index.vertex_index));
                    REQUIRE(same(corners[c].uv, index.texcoord_index));
                    REQUIRE(same(corners[c].normal, index.normal_index));
                }
            }
            first += count;
        }
    }
    REQUIRE(at == ours.faces.size());
}

}  // namespace

TEST_CASE("random valid files agree with tinyobjloader") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-100, 100);
    for (int round = 0; round < 60; ++round) {
        std::ostringstream out;
        out.precision(round % 17 + 1);
        const char* const end = round % 3 == 0 ? "\r\n" : "\n";
        const int vertices = 4 + static_cast<int>(random() % 60);
        const bool has_uv = round % 2 == 0;
        const bool has_normal = round % 4 < 2;
        out << "# test" << end << "mtllib none.mtl" << end << "o thing" << end;
        for (int i = 0; i < vertices; ++i) {
            out << "v " << coordinate(random) << ' ' << coordinate(random) << '\t'
                << coordinate(random) << end;
            if (has_uv) out << "vt " << coordinate(random) << ' ' << coordinate(random) << end;
            if (has_normal) {
                out << "vn " << coordinate(random) << ' ' << coordinate(random) << ' '
                    << coordinate(random) << end;
            }
        }
        for (int f = 0; f < 100; ++f) {
            if (f % 25 == 0) out << "g part" << f << end << "usemtl m" << end << "s off" << end;
            out << "f";
            const int corners = 3 + static_cast<int>(random() % 4);
            for (int c = 0; c < corners; ++c) {
                const int i = static_cast<int>(random() % static_cast<unsigned>(vertices));
                const int index = random() % 2 == 0 ? i + 1 : i - vertices;
                out << ' ' << index;
                if (has_uv) out << '/' << index;
                if (has_normal) out << (has_uv ? "/" : "//") << index;
            }
            out << (f == 99 && round % 5 == 0 ? "" : end);
        }
        CAPTURE(round);
        compare(out.str());
    }
}

TEST_CASE("published meshes agree with tinyobjloader" * doctest::test_suite("corpus")) {
    const std::filesystem::path corpus = test::corpus_or_skip();
    if (corpus.empty()) return;
    int meshes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
        if (entry.path().extension() != ".obj") continue;
        CAPTURE(entry.path().string());
        compare(test::file_text(entry.path()));
        ++meshes;
    }
    CHECK(meshes > 0);
}
