// SPDX-License-Identifier: MIT
// Any bytes as a mesh, by both sets of rules: every face that is kept can be used.
#include <cmath>
#include <cstdint>
#include <string>

#include "ir/assets/obj/obj_file.hpp"
#include "tests/fuzz/expect.hpp"

namespace {

using namespace cobble;
using fuzz::expect;

bool finite(double a, double b, double c) {
    return std::isfinite(a) && std::isfinite(b) && std::isfinite(c);
}

void read(const std::string& text, ir::ObjRules rules) {
    constexpr std::uint64_t kMaxFaces = 10'000;
    const ir::ObjFile file = ir::read_obj(text, rules, kMaxFaces);
    expect(file.faces.size() <= kMaxFaces, "the limit of faces holds");
    expect(file.problems.size() <= ir::kMaxObjProblems, "the list of problems is short");
    expect(file.problem_count >= file.problems.size(), "problems are counted");
    for (const auto& p : file.positions) expect(finite(p.x, p.y, p.z), "positions are finite");
    for (const auto& n : file.normals) expect(finite(n.x, n.y, n.z), "normals are finite");
    for (const auto& t : file.uvs) expect(finite(t.x, t.y, 0), "coordinates are finite");
    const auto in_range = [](std::uint32_t index, std::size_t count) {
        return index == ir::Mesh::kNone || index < count;
    };
    for (const ir::Mesh::Face& face : file.faces) {
        for (const ir::Mesh::Corner& corner : face.corners) {
            expect(corner.position < file.positions.size(), "a corner has a vertex");
            expect(in_range(corner.normal, file.normals.size()), "its normal is there");
            expect(in_range(corner.uv, file.uvs.size()), "its coordinates are there");
        }
    }
    for (const ir::ObjProblem& problem : file.problems) {
        expect(problem.code != nullptr && !problem.message.empty(), "a problem says something");
        expect(problem.begin <= problem.end && problem.end <= text.size(),
               "a problem lies in the text");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    read(text, ir::ObjRules::kStandard);
    read(text, ir::ObjRules::kPublished);
    return 0;
}
