// SPDX-License-Identifier: MIT
// From a checked scene to ir::Scene. Input: a CheckedScene and a file source for its assets.
// Output: the scene and the diagnostics of its meshes, images and nested transforms. Invariant: no
// file is read twice; no size is believed before it is checked; a scene that is returned can be
// rendered.
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/source/diagnostic.hpp"
#include "frontend/source/file_source.hpp"
#include "frontend/source/source_map.hpp"
#include "ir/scene/effects.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

struct Limits {
    std::uint64_t file_bytes = std::uint64_t{2} << 30;    ///< of any one asset
    std::uint64_t image_pixels = std::uint64_t{1} << 28;  ///< width times height
    std::uint64_t mesh_faces = std::uint64_t{1} << 28;
    /// Of all assets of a scene together, kept in memory: pixels, vertices and faces of meshes, and
    /// their text. What does not fit is left out like a missing file. Not the peak: arrays double
    /// as a mesh is read, and making its normals takes memory of its own, so that a mesh may take
    /// twice for a while what is kept of it (one polygon of 24 million corners: 1.0 GB kept, 2.15).
    std::uint64_t asset_bytes = std::uint64_t{2} << 30;
};

/// In pixels; as it is without `--size`.
struct PictureSize {
    std::uint32_t width = 640;
    std::uint32_t height = 480;
};

struct LowerOptions {
    Compat compat = Compat::kNone;
    bool casting = false;      ///< Compat::kProject with `-casting`: its ray caster's mesh normals
    bool decode_srgb = false;  ///< `--transfer srgb`: display inputs become linear
    bool judge_float = true;   ///< warn of what float cannot resolve: off for renders in double
    PictureSize size;          ///< whose pixels are meant where it does so
    Limits limits;
};

struct Lowered {
    Scene scene;
    /// False if there is nothing to render: no camera, or no usable object of any kind.
    bool renderable = false;
    bool has_camera = false;
    /// Of assets, and of transforms that only together go wrong; in order of the scene's spans.
    std::vector<source::Diagnostic> diagnostics;
};

/// Asset paths are resolved against the scene's own path in `sources`; assets are added to it.
/// What is broken is left out or substituted: whether to render such a scene is the caller's
/// choice.
Lowered lower(const frontend::CheckedScene& checked, source::SourceMap& sources,
              source::FileSource& files, const LowerOptions& options = {});

/// Lint's third part: reads and checks every asset, keeps none of the pixels.
std::vector<source::Diagnostic> check_assets(const frontend::CheckedScene& checked,
                                             source::SourceMap& sources, source::FileSource& files,
                                             const LowerOptions& options = {});

}  // namespace cobble::ir
