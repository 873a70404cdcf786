// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ir/math/elementary.hpp"
#include "tools/bench/inputs/input.hpp"
#include "tools/bench/inputs/random.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

constexpr int kSide = 280;

/// Columns of cubes: in column (x, z) those from bottom to top, both included.
class World {
  public:
    World() : tops_(kSide * kSide), bottoms_(kSide * kSide) {
        Random random(9);
        for (int z = 0; z < kSide; ++z) {
            for (int x = 0; x < kSide; ++x) {
                const double hill = 7 * math::sin(0.045 * x + 1) * math::sin(0.06 * z) +
                                    3 * math::sin(0.13 * x - 0.17 * z);
                const int rough = random.unit() < 0.25 ? 1 : 0;
                const int rock = random.unit() < 0.004 ? 4 : 0;
                tops_[index(x, z)] = static_cast<int>(hill + 20) - 20 + rough + rock;
            }
        }
        for (int z = 0; z < kSide; ++z) {
            for (int x = 0; x < kSide; ++x) {
                // Down to the lowest neighbour, so that no hole shows at a step.
                int low = tops_[index(x, z)] - 2;
                for (const auto& [dx, dz] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                    if (!inside(x + dx, z + dz)) continue;
                    const int other = tops_[index(x + dx, z + dz)];
                    low = other < low ? other : low;
                }
                bottoms_[index(x, z)] = low;
            }
        }
    }

    [[nodiscard]] bool solid(int x, int y, int z) const {
        return inside(x, z) && y >= bottoms_[index(x, z)] && y <= tops_[index(x, z)];
    }

    template <typename Visit>
    void each_block(Visit visit) const {
        for (int z = 0; z < kSide; ++z) {
            for (int x = 0; x < kSide; ++x) {
                for (int y = bottoms_[index(x, z)]; y <= tops_[index(x, z)]; ++y) visit(x, y, z);
            }
        }
    }

  private:
    static bool inside(int x, int z) { return x >= 0 && z >= 0 && x < kSide && z < kSide; }
    static std::size_t index(int x, int z) { return static_cast<std::size_t>(z * kSide + x); }

    std::vector<int> tops_, bottoms_;
};

Vec3d corner_of(int x, int y, int z) {
    return {static_cast<double>(x) - kSide / 2, static_cast<double>(y),
            static_cast<double>(z) - kSide / 2};
}

/// Two triangles for each face that borders on air; corners are shared.
ir::Mesh visible_faces(const World& world) {
    ir::Mesh mesh;
    std::unordered_map<std::uint64_t, std::size_t> seen;
    const auto corner = [&](int x, int y, int z) {
        const auto key = static_cast<std::uint64_t>(x) << 40 |
                         static_cast<std::uint64_t>(y + 1000) << 20 | static_cast<std::uint64_t>(z);
        const auto [place, fresh] = seen.try_emplace(key, mesh.positions.size());
        if (fresh) mesh.positions.push_back(corner_of(x, y, z));
        return place->second;
    };
    world.each_block([&](int x, int y, int z) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                std::array<int, 3> next{x, y, z};
                next[axis] += 2 * side - 1;
                if (world.solid(next[0], next[1], next[2])) continue;
                // Counter-clockwise seen from the upper side.
                constexpr std::array<std::array<int, 2>, 4> kAround{
                    {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
                std::array<std::size_t, 4> quad{};
                for (std::size_t i = 0; i < 4; ++i) {
                    std::array<int, 3> at{x, y, z};
                    at[axis] += side;
                    at[(axis + 1) % 3] += kAround[i][0];
                    at[(axis + 2) % 3] += kAround[i][1];
                    quad[i] = corner(at[0], at[1], at[2]);
                }
                if (side == 0) std::swap(quad[1], quad[3]);
                add_face(mesh, quad[0], quad[1], quad[2]);
                add_face(mesh, quad[0], quad[2], quad[3]);
            }
        }
    });
    return mesh;
}

ir::Scene world_scene() {
    ir::Scene scene = empty_scene({60, 90, 40});
    aim_camera(scene, {-60, 34, 120}, {10, 0, 0}, 45 * math::kPi / 180);
    return scene;
}

}  // namespace

Input block_input(bool as_boxes) {
    const World world;
    ir::Scene triangles = world_scene();
    triangles.meshes.push_back(visible_faces(world));
    add_object(triangles, ir::ShapeKind::kMesh, 0);
    const std::size_t faces = triangles.meshes[0].faces.size();

    Input input;
    if (!as_boxes) {
        input.title = fmt::format("blocks as {} triangles", faces);
        input.scene = std::move(triangles);
        return input;
    }
    input.scene = world_scene();
    world.each_block([&](int x, int y, int z) {
        const Vec3d low = corner_of(x, y, z);
        input.scene.boxes.push_back({low, low + Vec3d{1, 1, 1}});
        add_object(input.scene, ir::ShapeKind::kBox, input.scene.boxes.size() - 1);
    });
    input.title = fmt::format("{} boxes; peers: {} triangles", input.scene.boxes.size(), faces);
    input.triangles = std::move(triangles);
    return input;
}

}  // namespace cobble::bench
