// SPDX-License-Identifier: MIT
#include "tools/driver/shards.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

#include "renderer/tile/tiles.hpp"
#include "tools/driver/numbers.hpp"
#include "tools/driver/pictures.hpp"

namespace cobble::driver {
namespace {

constexpr std::string_view kPrefix = "cobble shard ";
renderer::Settings settings_of(const ShardNote& note) {
    renderer::Settings settings;
    settings.width = note.width;
    settings.height = note.height;
    settings.crop = note.window;
    settings.tile_size = note.tile_size;
    settings.shard_index = note.index - 1;
    settings.shard_count = note.count;
    return settings;
}

std::string name_of(const ShardNote& note) {
    return fmt::format("shard {}/{}", note.index, note.count);
}

std::string size_of(std::uint32_t width, std::uint32_t height) {
    return fmt::format("{}x{}", width, height);
}

// Why `second` is no shard of the render that `first` is one of, or "".
std::string difference(const ShardNote& first, const ShardNote& second) {
    std::vector<Property> properties{
        {"number of shards", std::to_string(first.count), std::to_string(second.count)},
        {"kind of picture", first.picture, second.picture},
        {"tile size", std::to_string(first.tile_size), std::to_string(second.tile_size)}};
    for (Property& property : properties_of(first, second)) {
        properties.push_back(std::move(property));
    }
    return first_difference(properties);
}

// Why a file cannot be a part of any whole, or "".
std::string objection(const std::string& path, const ReadPicture& picture,
                      const std::optional<ShardNote>& note, const std::string& output) {
    if (!picture.problem.empty()) return picture.problem;
    if (!note) {
        return path +
               " does not say which shard of a render it is, as `cobble render --shard` writes";
    }
    if (!note->complete)
        return fmt::format("{} is {} of a render that was interrupted", path, name_of(*note));
    const renderer::Crop& window = note->window;
    if (picture.plane.width != window.x1 - window.x0 ||
        picture.plane.height != window.y1 - window.y0) {
        return fmt::format("{} is {}, and was rendered as {}", path,
                           size_of(picture.plane.width, picture.plane.height),
                           size_of(window.x1 - window.x0, window.y1 - window.y0));
    }
    if (picture.eight_bit == keeps_bytes(output)) return {};
    return picture.eight_bit
               ? fmt::format("{} keeps 8 bits a channel: join it to a .png, .bmp or .tga file",
                             path)
               : fmt::format(
                     "{} keeps more than 8 bits a channel: join it to a .pfm, .hdr or .exr file",
                     path);
}

// "" if all shards are there.
std::string missing(const std::map<std::uint32_t, std::string>& shards, std::uint32_t count) {
    // Files may claim to be one of billions: only those are named that come first.
    constexpr std::size_t kEnough = 3;
    const std::uint64_t left = count - shards.size();
    if (left == 0) return {};
    std::string names;
    std::size_t named = 0;
    for (std::uint32_t i = 1; named < std::min<std::uint64_t>(left, kEnough); ++i) {
        if (shards.contains(i)) continue;
        names += fmt::format("{}{}/{}", named == 0 ? "" : ", ", i, count);
        ++named;
    }
    if (left == 1) return fmt::format("shard {} is missing", names);
    const bool all = left <= kEnough;
    return fmt::format("shards {}{} are missing", names,
                       all ? "" : fmt::format(" and {} more", left - named));
}

void copy_tiles(const ShardNote& note, const renderer::Plane32& from, renderer::Plane32& to) {
    const renderer::Settings settings = settings_of(note);
    for (const renderer::Tile& tile : renderer::make_tiles(settings)) {
        for (std::uint64_t i = 0; i < tile.pixels(); ++i) {
            const std::size_t pixel =
                std::size_t{tile.y(i) - note.window.y0} * to.width + (tile.x(i) - note.window.x0);
            // What was read has three equal channels where there was one.
            for (std::size_t c = 0; c < to.channels; ++c) {
                to.values[pixel * to.channels + c] = from.values[pixel * from.channels + c];
            }
        }
    }
}

}  // namespace

ShardNote shard_note(const ir::Scene& scene, const renderer::Settings& settings,
                     std::string_view picture, std::string_view more, bool complete) {
    ShardNote note;
    static_cast<RenderIdentity&>(note) = identify(scene, settings, more);
    note.index = settings.shard_index + 1;
    note.count = settings.shard_count;
    note.tile_size = settings.tile_size;
    note.picture = picture;
    note.complete = complete;
    return note;
}

std::string to_text(const ShardNote& note) {
    return fmt::format("{}{}/{} tiles {} picture {}{} complete {}", kPrefix, note.index, note.count,
                       note.tile_size, note.picture, words_of(note), note.complete ? "yes" : "no");
}

std::optional<ShardNote> parse_shard_note(std::string_view text) {
    if (!text.starts_with(kPrefix)) return std::nullopt;
    text.remove_prefix(kPrefix.size());
    const std::size_t end = std::min(text.find(' '), text.size());
    std::vector<std::uint32_t> part;
    WordValues values = parse_words(text.substr(std::min(end + 1, text.size())));
    ShardNote note;
    if (!parse_numbers(text.substr(0, end), '/', 2, part) || part[0] < 1 || part[0] > part[1] ||
        !read_identity(values, note) || !parse_number(values["tiles"], note.tile_size)) {
        return std::nullopt;
    }
    note.index = part[0];
    note.count = part[1];
    note.picture = values["picture"];
    note.complete = values["complete"] == "yes";
    return note;
}

Merged merge_shards(const std::vector<std::string>& paths, const std::string& output) {
    Merged merged;
    const auto refuse = [&merged](std::string problem) {
        merged.plane = {};
        merged.problem = std::move(problem);
        return merged;
    };
    ShardNote first;
    std::map<std::uint32_t, std::string> shards;  // path by number
    for (const std::string& path : paths) {
        const ReadPicture shard = read_picture(path);
        const std::optional<ShardNote> note = parse_shard_note(shard.comment);
        if (std::string problem = objection(path, shard, note, output); !problem.empty()) {
            return refuse(std::move(problem));
        }
        if (shards.empty()) {
            first = *note;
            const bool one_channel = note->picture == "depth" || note->picture == "sample-count";
            merged.plane = {shard.plane.width, shard.plane.height, one_channel ? 1U : 3U, {}};
            merged.plane.values.resize(std::size_t{shard.plane.width} * shard.plane.height *
                                       merged.plane.channels);
        } else if (std::string other = difference(first, *note); !other.empty()) {
            return refuse(
                fmt::format("{} is no shard of the same render as {}: {}", path, paths[0], other));
        }
        const auto [twin, is_new] = shards.emplace(note->index, path);
        if (!is_new) {
            return refuse(twin->second == path ? path + " is named twice"
                                               : fmt::format("{} and {} are both {}", twin->second,
                                                             path, name_of(*note)));
        }
        copy_tiles(*note, shard.plane, merged.plane);
    }
    if (std::string problem = missing(shards, first.count); !problem.empty()) {
        return refuse(std::move(problem));
    }
    return merged;
}

}  // namespace cobble::driver
