// SPDX-License-Identifier: MIT
// From one object of the file to a shape of ir::Scene: baked into world space where that changes
// nothing that can be seen, else an instance.
//
// | shape    | baked if                                                                          |
// |----------|-----------------------------------------------------------------------------------|
// | sphere   | its frame scales evenly, and turns only if no texture coordinates are read        |
// | plane    | at rest                                                                           |
// | triangle | always; a mirroring frame swaps two corners, so that the front stays the front    |
// | box      | at rest, and its frame keeps the axes and their directions                        |
// | mesh     | at rest, and no other object shares it                                            |
//
// Moving spheres and triangles have one key per time; all else that moves is an instance.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "frontend/ast/views.hpp"
#include "ir/lower/frames.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Two unit tangents of a plane with this unit normal: u (x) and v (y) such that u x v = normal.
/// Steeper than 45 degrees (a wall): v points up (+y as far as it can) and u to the right as seen
/// from the front. Flatter: u along +x, and v along -z on a floor and +z on a ceiling, as far as
/// they can; so a picture lies upright before a camera that looks along -z.
std::array<math::Vec3d, 2> plane_tangents(math::Vec3d normal);

/// Lowers objects into `scene`, one after the other.
class ShapeBuilder {
  public:
    ShapeBuilder(const frontend::CheckedScene& checked, const Frames& frames, Scene& scene)
        : checked_(checked), frames_(frames), scene_(scene), placed_(frames.size()) {}

    /// Adds the shape of a Sphere, Plane, Triangle or Box and fills in the kind, shape and
    /// placement of `object`. False if the block lacks what it needs, or the shape leaves the
    /// range of doubles.
    bool add(frontend::BlockNodeId block, bool reads_uv, Object& object);

    /// Places a mesh: baked (which changes it) if it is `sole` and at rest, else as an instance.
    bool place_mesh(std::uint32_t mesh, bool sole, frontend::BlockNodeId block, Object& object);

    /// The frame's placements, made at its first use. Nothing if it has no inverse at some key.
    std::optional<Keys> placement(std::uint32_t frame);

    /// After the last object: adds the chord error of instances, once per frame for all of them.
    void finish();

    /// The largest condition number among the frame's inverses; 0 before it is placed.
    [[nodiscard]] double condition(std::uint32_t frame) const { return placed_[frame].condition; }

  private:
    struct Placed {
        Keys keys;
        bool tried = false;
        double condition = 0;
        bool mirrors = false;
        std::optional<std::pair<math::Vec3d, math::Vec3d>> moving_bounds;
    };

    bool sphere(const frontend::BlockView& view, std::uint32_t frame, bool reads_uv, Object& out);
    bool plane(const frontend::BlockView& view, std::uint32_t frame, Object& out);
    bool triangle(const frontend::BlockView& view, std::uint32_t frame, Object& out);
    bool box(const frontend::BlockView& view, std::uint32_t frame, Object& out);
    bool sphere_instance(math::Vec3d center, double radius, std::uint32_t frame, Object& out);
    /// False once moving objects would have too many keys of their own: those that follow share
    /// their frame's placements instead.
    bool within_budget(std::uint32_t keys);
    void bake(Mesh& mesh, const Placement& place, bool mirrors);
    void note_chord(double distance);
    /// An instance of a moving frame lies in the box [low, high] of the frame.
    void note_instance(std::uint32_t frame, math::Vec3d low, math::Vec3d high);

    const frontend::CheckedScene& checked_;
    const Frames& frames_;
    Scene& scene_;
    std::vector<Placed> placed_;  ///< per frame
    std::vector<std::optional<std::pair<math::Vec3d, math::Vec3d>>> mesh_bounds_;
    std::size_t own_keys_ = 0;
    // Of at most 192 bytes each (a placement): 800 MB.
    static constexpr std::size_t kMaxOwnKeys = std::size_t{1} << 22;
};

}  // namespace cobble::ir
