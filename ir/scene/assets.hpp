// SPDX-License-Identifier: MIT
// Images and meshes as the scene refers to them. Each file is loaded once, however often named.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "frontend/source/span.hpp"
#include "ir/math/vec.hpp"
#include "ir/scene/ids.hpp"

namespace cobble::ir {

/// What an image's numbers mean; decides whether a transfer function applies to them.
enum class ColorTag : std::uint8_t {
    kDisplay,  ///< 8-bit pictures: display values, as published scenes use them
    kLinear,   ///< HDR pictures: light
    kData,     ///< normal and height maps: never decoded
};

/// A picture in memory, rows from the top, three channels interleaved. Exactly one of `bytes`
/// (8-bit files, value / 255) and `floats` (HDR files) is filled, with 3 width height entries.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    ColorTag tag = ColorTag::kDisplay;
    std::vector<std::uint8_t> bytes;
    std::vector<float> floats;
    bool missing = false;   ///< stands for a file that could not be read: a magenta checker
    bool constant = false;  ///< every texel has the same value
    std::string path;       ///< as resolved
    source::SourceId source;
};

/// Six square images of one size.
struct CubeMap {
    /// Order of the faces, as the published programs load them.
    enum Face : std::uint8_t { kLeft, kRight, kUp, kDown, kFront, kBack };
    std::array<ImageId, 6> faces;
    source::Span span;  ///< the path in the scene
};

/// Triangles that share vertices. Normals are final: the file's, or computed as the scene's
/// `creaseAngle` and compatibility mode ask.
struct Mesh {
    struct Corner {
        std::uint32_t position;
        std::uint32_t normal;  ///< kNone (then at all corners of its face): flat
        std::uint32_t uv;      ///< kNone (likewise): no texture coordinates
    };
    static constexpr std::uint32_t kNone = 0xffffffffU;
    struct Face {
        std::array<Corner, 3> corners;
    };

    std::vector<math::Vec3d> positions;
    std::vector<math::Vec3d> normals;         ///< unit length
    std::vector<math::Vec2d> uvs;             ///< v = 0 is the bottom row of a texture
    std::vector<Face> faces;                  ///< degenerate ones are kept: indices are ids
    std::vector<std::uint32_t> face_offsets;  ///< byte of the OBJ file that made each face
    std::string path;
    source::SourceId source;
};

}  // namespace cobble::ir
