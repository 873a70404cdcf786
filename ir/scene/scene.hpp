// SPDX-License-Identifier: MIT
// The checked scene as flat arrays: what lowering produces and the renderer consumes.
//
// Units: world units, radians, display colours. Every record has an index, an optional label and a
// span, so that a hit can name the line that made it. Nothing here is NaN, infinite or out of
// range.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/span.hpp"
#include "ir/math/affine.hpp"
#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"
#include "ir/scene/ids.hpp"

namespace cobble::ir {

using Color = math::Vec3d;

/// Which published program's meaning a scene is given.
enum class Compat : std::uint8_t {
    kNone,     ///< Cobble's own meaning
    kA4,       ///< the course's ray caster of 2012
    kA5,       ///< its ray tracer
    kFa2016,   ///< the edition of 2016
    kProject,  ///< the project that this one grew from
};

struct Camera {
    math::Vec3d center;
    math::Vec3d forward;  ///< unit
    math::Vec3d up;       ///< unit, perpendicular to forward
    math::Vec3d right;    ///< unit: forward x up
    math::Vec3d up_as_written;
    double angle = 0;           ///< full vertical opening, radians
    double aperture = 0;        ///< lens diameter
    double focus_distance = 0;  ///< along forward; 0 if aperture is 0
    std::uint32_t blades = 0;   ///< 0: round
    double shutter_open = 0;
    double shutter_close = 1;
    std::string label;
    source::Span span;
};

struct Light {
    enum class Kind : std::uint8_t { kPoint, kDirectional };
    Kind kind = Kind::kPoint;
    math::Vec3d position;   ///< kPoint
    math::Vec3d direction;  ///< kDirectional: unit, the way the light travels
    Color color;
    double falloff = 0;  ///< kPoint
    double radius = 0;   ///< kPoint
    double angle = 0;    ///< kDirectional: full angular diameter, radians
    std::string label;
    source::Span span;
};

struct Background {
    Color color{0.5, 0.5, 0.5};
    Color ambient;  ///< already 1 1 1 where the scene has no lights
    CubeMapId cube_map;
    source::Span span;  ///< invalid if the scene has no Background
};

struct Noise {
    Color color1, color2;
    std::uint32_t octaves = 0;
    double frequency = 1;
    double amplitude = 1;
};

enum class TextureFilter : std::uint8_t { kBilinear, kNearest };

struct Material {
    Color diffuse{1, 1, 1};
    Color specular;
    double shininess = 0;
    double refraction_index = 0;
    ImageId texture;
    ImageId normal_map;
    ImageId bump_map;
    CubeMapId cube_map;
    TextureFilter texture_filter = TextureFilter::kBilinear;
    math::Vec2d texture_scale{1, 1};
    bool has_noise = false;
    Noise noise;
    /// The one-colour picture that `diffuse` stands for, where lowering could put it there.
    ImageId folded_texture;
    bool substituted = false;  ///< broken in the file: shown as a magenta checker
    std::string label;
    source::Span span;
};

/// A stretch of Scene::transforms: one entry for a thing at rest, K + 1 (K a power of two) for one
/// that moves, at equal steps of shutter time from 0 to 1.
struct Keys {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0: baked into the shape's own coordinates
};

/// An instance's place: both ways, each composed in double.
struct Placement {
    math::Affined object_to_world;
    math::Affined world_to_object;
};

enum class ShapeKind : std::uint8_t { kSphere, kPlane, kTriangle, kBox, kMesh };

/// The block that makes an object.
constexpr std::string_view block_name(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::kSphere:
            return "Sphere";
        case ShapeKind::kPlane:
            return "Plane";
        case ShapeKind::kTriangle:
            return "Triangle";
        case ShapeKind::kBox:
            return "Box";
        case ShapeKind::kMesh:
            return "TriangleMesh";
    }
    return "?";
}

/// One object of the file, in textual order. Its index is its part of a hit's identity: the answer
/// to a ray is the smallest (t, object, face).
struct Object {
    ShapeKind kind = ShapeKind::kSphere;
    std::uint32_t shape = 0;  ///< into the array of its kind
    MaterialId material;
    Keys placement;  ///< count 0: the shape is in world space ("baked")
    std::string label;
    source::Span span;
};

/// At rest: one key. Moving: centre and radius per key, linear between.
struct Sphere {
    struct Key {
        math::Vec3d center;
        double radius = 0;
    };
    std::vector<Key> keys;
};

/// The points p with p . normal = offset; `normal` is unit. Texture coordinates are affine in the
/// point: u = u_axis . p + u_offset, v likewise.
struct Plane {
    math::Vec3d normal;
    double offset = 0;
    math::Vec3d u_axis, v_axis;
    double u_offset = 0, v_offset = 0;
};

/// At rest: one key. Moving: three vertices per key, linear between.
struct Triangle {
    std::vector<std::array<math::Vec3d, 3>> keys;
};

struct Box {
    math::Vec3d min, max;
};

/// Everything the renderer needs to know.
struct Scene {
    Compat compat = Compat::kNone;
    source::SourceId source;
    Camera camera;
    Background background;
    std::vector<Light> lights;
    std::vector<Material> materials;
    std::vector<Object> objects;

    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Triangle> triangles;
    std::vector<Box> boxes;
    std::vector<Mesh> meshes;
    std::vector<Placement> placements;  ///< what Keys point into

    std::vector<Image> images;
    std::vector<CubeMap> cube_maps;

    /// No point of a moving object strays further than this from its true path where that was
    /// measured, halfway between keys; world units.
    double motion_chord_error = 0;
};

}  // namespace cobble::ir
