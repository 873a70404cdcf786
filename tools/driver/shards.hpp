// SPDX-License-Identifier: MIT
// Shards: parts of one render, made apart from each other, each a picture of full size of which it
// fills only some tiles. Each says in its file what it is a part of, so that joining them can tell
// what is missing and what does not belong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"
#include "tools/driver/render_identity.hpp"

namespace cobble::driver {

/// What a shard's picture file says of itself, as its comment.
struct ShardNote : RenderIdentity {
    std::uint32_t index = 1, count = 1;  ///< part I of N, from 1
    std::uint32_t tile_size = 0;
    std::string picture;  ///< which of a render's pictures: color, depth, ...
    bool complete = false;
};

/// Of `picture` ("color", "depth", "normals", "albedo", "sample-count"; the last has one channel as
/// depth has) of this render. `more` stands for whatever else its pixels depend on. Costs one hash
/// of the scene.
ShardNote shard_note(const ir::Scene& scene, const renderer::Settings& settings,
                     std::string_view picture, std::string_view more, bool complete);

/// One line of at most renderer::kMaxComment bytes, and back; nothing if the text is no such line.
std::string to_text(const ShardNote& note);
std::optional<ShardNote> parse_shard_note(std::string_view text);

struct Merged {
    renderer::Plane32 plane;  ///< of one channel where the render's has one
    std::string problem;      ///< empty if the shards are all of one render
};

/// Joins the shards of one render, in any order: each pixel from the shard in whose tiles it lies.
/// `output` is where the result is to go: it must keep as many bits as they do.
Merged merge_shards(const std::vector<std::string>& paths, const std::string& output);

}  // namespace cobble::driver
