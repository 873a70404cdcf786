// SPDX-License-Identifier: MIT
// Pictures have one sequence of bits on every compiler and machine: their hashes are written down
// in golden.expected. A change of meaning changes them: COBBLE_UPDATE=1 writes them anew.
#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "tests/render/everything.hpp"
#include "tests/support/golden.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

std::string hashes(renderer::Acceleration core) {
    SceneBuilder b = everything();
    std::ostringstream out;
    for (const bool exact : {false, true}) {
        for (const auto& [name, filter] : {std::pair{"box", renderer::PixelFilter::kBox},
                                           {"tent", renderer::PixelFilter::kTent},
                                           {"gaussian", renderer::PixelFilter::kGaussian}}) {
            renderer::Settings s = settings(48, 36, 4);
            s.precision = exact ? renderer::Precision::kDouble : renderer::Precision::kFloat;
            s.filter = filter;
            s.acceleration = core;
            s.want_depth = s.want_normals = s.want_albedo = true;
            const Rendered r = render(b.scene(), s);
            BitsHash hash;
            hash.add(r.picture.color.values);
            hash.add(r.picture.depth.values);
            hash.add(r.picture.normals.values);
            hash.add(r.picture.albedo.values);
            out << (exact ? "double " : "float ") << name << ' ' << hash.text() << '\n';
        }
    }
    return out.str();
}

}  // namespace

TEST_CASE("pictures have the bits that are written down") {
    check_golden("tests/render/golden.expected", hashes(renderer::Acceleration::kBvh));
    check_golden("tests/render/golden.expected", hashes(renderer::Acceleration::kFast));
}
