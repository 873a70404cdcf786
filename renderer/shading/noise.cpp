// SPDX-License-Identifier: MIT
#include "renderer/shading/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {
namespace {

/// The permutation of the reference implementation.
constexpr std::array<std::uint8_t, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

std::uint32_t permute(std::uint32_t i) { return kPermutation[i & 255U]; }

/// 6 t^5 - 15 t^4 + 10 t^3: first and second derivative vanish at both ends.
double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// The dot product of (x, y, z) with one of the twelve edge directions of a cube, four of them
/// taken twice.
double gradient(std::uint32_t hash, double x, double y, double z) {
    const std::uint32_t h = hash & 15U;
    const double first = h < 8 ? x : y;
    const double second = h < 4 ? y : (h == 12 || h == 14) ? x : z;
    return ((h & 1U) == 0 ? first : -first) + ((h & 2U) == 0 ? second : -second);
}

/// A coordinate split into its lattice cell, modulo 256, and the place inside, in [0, 1).
struct Cell {
    std::uint32_t index = 0;
    double fraction = 0;
};

Cell cell_of(double x) {
    const double floor = std::floor(x);
    // Exact: 256 is a power of two, and the difference has no more bits than `floor`.
    const double index = floor - 256 * std::floor(floor / 256);
    return {static_cast<std::uint32_t>(index), x - floor};
}

}  // namespace

double perlin_noise(math::Vec3d point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return 0;
    const Cell cx = cell_of(point.x);
    const Cell cy = cell_of(point.y);
    const Cell cz = cell_of(point.z);
    const double x = cx.fraction;
    const double y = cy.fraction;
    const double z = cz.fraction;
    const double u = fade(x);
    const double v = fade(y);
    const double w = fade(z);

    // Hash of the cell's corner (i, j, k).
    const auto corner = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return permute(permute(permute(cx.index + i) + cy.index + j) + cz.index + k);
    };
    const auto edge = [&](std::uint32_t j, std::uint32_t k) {
        const double yj = y - j;
        const double zk = z - k;
        return math::lerp(gradient(corner(0, j, k), x, yj, zk),
                          gradient(corner(1, j, k), x - 1, yj, zk), u);
    };
    return math::lerp(math::lerp(edge(0, 0), edge(1, 0), v), math::lerp(edge(0, 1), edge(1, 1), v),
                      w);
}

double octave_noise(math::Vec3d point, std::uint32_t octaves) {
    constexpr std::uint32_t kMostOctaves = 53;
    double sum = 0;
    double scale = 1;
    for (std::uint32_t i = 0; i < std::min(octaves, kMostOctaves); ++i) {
        sum += perlin_noise(point * scale) / scale;
        scale *= 2;
    }
    return sum;
}

double marble(const ir::Noise& noise, math::Vec3d point) {
    const double phase =
        noise.frequency * point.x + noise.amplitude * octave_noise(point, noise.octaves);
    // Finite numbers in a scene can still multiply to infinity, whose sine is nothing: its mean.
    return std::isfinite(phase) ? (1 + math::sin(phase)) / 2 : 0.5;
}

ir::Color marble_color(const ir::Noise& noise, math::Vec3d point) {
    const double m = marble(noise, point);
    return m * noise.color1 + (1 - m) * noise.color2;
}

}  // namespace cobble::renderer
