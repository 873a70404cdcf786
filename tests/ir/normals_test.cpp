// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/assets/obj/obj_file.hpp"

using namespace cobble::ir;
using cobble::math::Vec3d;

namespace {

Mesh mesh_of(const std::string& text) {
    ObjFile file = read_obj(text, ObjRules::kStandard, 1U << 20);
    REQUIRE(file.problem_count == 0);
    Mesh mesh;
    mesh.positions = file.positions;
    mesh.faces = file.faces;
    return mesh;
}

constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";

std::size_t flat_faces(const Mesh& mesh) {
    std::size_t count = 0;
    for (const auto& face : mesh.faces) {
        const auto& c = face.corners;
        const bool flat = c[0].normal == Mesh::kNone;
        CHECK((c[1].normal == Mesh::kNone) == flat);
        CHECK((c[2].normal == Mesh::kNone) == flat);
        count += flat ? 1 : 0;
    }
    return count;
}

/// A prism with `sides` sides around the y axis, its caps included.
std::string prism(int sides) {
    std::ostringstream text;
    std::ostringstream top;
    for (int i = 0; i < sides; ++i) {
        const double a = 2 * M_PI * i / sides;
        for (int y = 0; y < 2; ++y) {
            text << "v " << std::cos(a) << ' ' << y << ' ' << -std::sin(a) << '\n';
        }
    }
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        text << "f " << 2 * i + 1 << ' ' << 2 * j + 1 << ' ' << 2 * j + 2 << ' ' << 2 * i + 2
             << '\n';
        top << ' ' << 2 * i + 2;
    }
    text << "f" << top.str() << '\n';
    return text.str();
}

}  // namespace

TEST_CASE("the edges of a cube are sharp up to 90 degrees and smooth beyond") {
    for (const double angle : {0.0, 60.0, 90.0}) {
        Mesh mesh = mesh_of(kCube);
        compute_normals(mesh, NormalRule::kCreaseAngle, angle);
        CHECK(flat_faces(mesh) == 12);
        CHECK(mesh.normals.empty());
    }
    Mesh mesh = mesh_of(kCube);
    compute_normals(mesh, NormalRule::kCreaseAngle, 91);
    CHECK(flat_faces(mesh) == 0);
    REQUIRE(mesh.normals.size() == 8);
    // Weighted by angles, the diagonals of the sides leave no trace.
    for (const auto& face : mesh.faces) {
        for (const auto& corner : face.corners) {
            const Vec3d outward = mesh.positions[corner.position] - Vec3d{0.5, 0.5, 0.5};
            const Vec3d expected = normalize(outward);
            CHECK(length(mesh.normals[corner.normal] - expected) < 1e-15);
        }
    }
}

TEST_CASE("a round wall is smooth and its rim is sharp") {
    Mesh mesh = mesh_of(prism(24));
    compute_normals(mesh, NormalRule::kCreaseAngle, 60);
    CHECK(flat_faces(mesh) == 22);  // the top
    CHECK(mesh.normals.size() == 48);
    for (const auto& normal : mesh.normals) {
        CHECK(std::fabs(normal.y) < 1e-6);
        CHECK(length(normal) == doctest::Approx(1));
    }
}

TEST_CASE("vertices at one place count as one") {
    // Two squares that meet at 45 degrees along doubled vertices.
    Mesh mesh = mesh_of(
        "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nv 0 0 0\nv 1 0 0\nv 1 -1 1\nv 0 -1 1\n"
        "f 1 2 3 4\nf 8 7 6 5\n");
    compute_normals(mesh, NormalRule::kCreaseAngle, 60);
    CHECK(flat_faces(mesh) == 0);
    const auto& first = mesh.faces[0].corners[0];
    const auto& second = mesh.faces[3].corners[2];
    CHECK(mesh.positions[first.position] == mesh.positions[second.position]);
    CHECK(first.normal == second.normal);
    compute_normals(mesh, NormalRule::kCreaseAngle, 40);
    CHECK(flat_faces(mesh) == 4);
}

TEST_CASE("faces that only touch in a vertex stay apart") {
    Mesh mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0.1\nv -1 0 0\nv 0 -1 0.1\nf 1 2 3\nf 1 4 5\n");
    compute_normals(mesh, NormalRule::kCreaseAngle, 180);
    CHECK(flat_faces(mesh) == 2);
}

TEST_CASE("degenerate faces neither give nor get normals") {
    Mesh mesh =
        mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 1 1 0.2\nf 1 2 3\nf 1 2 4\nf 2 5 3\n");
    for (const auto rule :
         {NormalRule::kCreaseAngle, NormalRule::kSumOfCrosses, NormalRule::kSumOfUnits}) {
        compute_normals(mesh, rule, 180);
        for (const auto& normal : mesh.normals) {
            CHECK(std::isfinite(normal.x));
            CHECK(std::isfinite(normal.y));
            CHECK(std::isfinite(normal.z));
        }
    }
}

TEST_CASE("a million faces on one edge are no million squared steps") {
    std::string text = "v 0 0 0\nv 0 1 0\n";
    constexpr int kFaces = 100000;
    for (int i = 0; i < kFaces; ++i) {
        text += "v " + std::to_string(1 + i % 97) + " " + std::to_string(i) + " 0\n";
    }
    for (int i = 0; i < kFaces; ++i) text += "f 1 2 " + std::to_string(i + 3) + "\n";
    Mesh mesh = mesh_of(text);
    compute_normals(mesh, NormalRule::kCreaseAngle, 180);
    CHECK(mesh.faces.size() == kFaces);
}

TEST_CASE("published rules weigh faces by area or not at all") {
    const char* const roof = "v 0 0 0\nv 1 0 0\nv 0 0 -3\nv 0 1 0\nf 1 2 3\nf 1 4 2\n";
    Mesh mesh = mesh_of(roof);
    compute_normals(mesh, NormalRule::kSumOfCrosses, 0);
    // 3 along +y and 1 along -z.
    CHECK(length(mesh.normals[0] - normalize(Vec3d{0, 3, -1})) < 1e-15);
    compute_normals(mesh, NormalRule::kSumOfUnits, 0);
    CHECK(length(mesh.normals[0] - normalize(Vec3d{0, 1, -1})) < 1e-15);
    compute_normals(mesh, NormalRule::kFlat, 0);
    CHECK(flat_faces(mesh) == 2);
}

TEST_CASE("normals do not depend on the size of the mesh") {
    for (const double scale : {1e-200, 1e-30, 1e30, 1e200}) {
        Mesh mesh = mesh_of(kCube);
        for (auto& p : mesh.positions) p *= scale;
        compute_normals(mesh, NormalRule::kCreaseAngle, 180);
        CHECK(flat_faces(mesh) == 0);
        CHECK(mesh.normals.size() == 8);
    }
}
