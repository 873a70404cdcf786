// SPDX-License-Identifier: MIT
// Pictures have one sequence of bits on every compiler and machine: their hashes are written down
// in golden.expected. A change of meaning changes them: COBBLE_UPDATE=1 writes them anew.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>

#include "tests/render/everything.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

/// FNV-1a, 64 bits, over the floats' bytes from the lowest.
class Hash {
  public:
    void add(const renderer::Plane32& plane) {
        for (const float value : plane.values) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            for (int i = 0; i < 4; ++i) {
                state_ = (state_ ^ (bits >> (8 * i) & 255U)) * 0x100000001b3U;
            }
        }
    }
    [[nodiscard]] std::string text() const {
        std::ostringstream out;
        out << std::hex << std::setw(16) << std::setfill('0') << state_;
        return out.str();
    }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

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
            Hash hash;
            hash.add(r.picture.color);
            hash.add(r.picture.depth);
            hash.add(r.picture.normals);
            hash.add(r.picture.albedo);
            out << (exact ? "double " : "float ") << name << ' ' << hash.text() << '\n';
        }
    }
    return out.str();
}

}  // namespace

TEST_CASE("pictures have the bits that are written down") {
    const std::string path = std::string(COBBLE_ROOT) + "/tests/render/golden.expected";
    const std::string now = hashes(renderer::Acceleration::kBvh);
    if (std::getenv("COBBLE_UPDATE") != nullptr) std::ofstream(path, std::ios::binary) << now;
    std::ifstream in(path, std::ios::binary);
    const std::string expected{std::istreambuf_iterator<char>(in), {}};
    CHECK(now == expected);
    CHECK(hashes(renderer::Acceleration::kFast) == expected);
}
