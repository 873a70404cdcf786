// SPDX-License-Identifier: MIT
// What tells one render from another, for files that hold a part of one: shards and checkpoints.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"

namespace cobble::driver {

/// Two renders with one identity have the same pixels.
struct RenderIdentity {
    std::uint32_t width = 0, height = 0;
    renderer::Crop window;  ///< the pixels of it that are rendered
    std::string scene;      ///< hash of all that the scene means
    std::uint32_t samples = 0;
    std::uint64_t seed = 0;
    std::string settings;  ///< hash of all other settings that pixels depend on
    std::string version;   ///< of the program
};

/// `more` stands for whatever else the pixels depend on. Costs one hash of the scene.
RenderIdentity identify(const ir::Scene& scene, const renderer::Settings& settings,
                        std::string_view more);

/// One of the things in which two renders can differ: its name, and how each says it. Hashes tell
/// people nothing: for them the name is the whole sentence.
struct Property {
    std::string_view name;
    std::string first, second;
    bool hash = false;
};

/// All of an identity, what tells most first.
std::vector<Property> properties_of(const RenderIdentity& first, const RenderIdentity& second);

/// The first difference, as "its seed is 2, not 1", which `second` has and `first` has not; or "".
std::string first_difference(const std::vector<Property>& properties);

/// An identity as words: " of 640x480 at 0,0,640,480 scene ... version 0.1.0".
std::string words_of(const RenderIdentity& identity);

using WordValues = std::map<std::string_view, std::string_view>;

/// Names and values in turn, with one space between words; all of it refers to `text`.
WordValues parse_words(std::string_view text);

/// False if one is missing or wrong; others may come with later versions.
bool read_identity(WordValues& values, RenderIdentity& identity);

}  // namespace cobble::driver
