// SPDX-License-Identifier: MIT
#include "tools/driver/checkpoint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ir/output/sha256.hpp"
#include "renderer/picture/picture_io.hpp"
#include "tools/driver/disk_file_source.hpp"
#include "tools/driver/numbers.hpp"

namespace cobble::driver {
namespace {

constexpr std::string_view kMagic = "cobble checkpoint ";
constexpr std::uint32_t kFormat = 1;
constexpr std::size_t kDigestBytes = ir::Sha256::Digest().size();
// Three times as long as the first line ever is.
constexpr std::size_t kMaxLine = 1024;
// A state of as many pixels as a picture may have: the floats and doubles of all its planes.
constexpr std::uint64_t kMaxBytes = renderer::kMaxPixels * 256;

ir::Sha256::Digest digest_of(std::string_view bytes) {
    ir::Sha256 hash;
    hash.add(bytes.data(), bytes.size());
    return hash.finish();
}

std::string shard_text(const CheckpointNote& note) {
    return note.count == 1 ? "all of it" : fmt::format("shard {}/{}", note.index, note.count);
}

// Why what `second` says it is of is not the render that `first` is of, or "".
std::string difference(const CheckpointNote& first, const CheckpointNote& second) {
    std::vector<Property> properties = properties_of(first, second);
    const auto add = [&properties](std::string_view name, std::string a, std::string b) {
        properties.push_back({name, std::move(a), std::move(b)});
    };
    add("part of the picture", shard_text(first), shard_text(second));
    add("tile size", std::to_string(first.tile_size), std::to_string(second.tile_size));
    add("list of pictures", first.pictures, second.pictures);
    return first_difference(properties);
}

// What the first line says; false if it is none that this program writes.
bool read_line(std::string_view line, CheckpointNote& note, std::uint64_t& state_bytes) {
    WordValues values = parse_words(line);
    std::vector<std::uint32_t> part;
    if (!read_identity(values, note) || !parse_numbers(values["shard"], '/', 2, part) ||
        !parse_number(values["tiles"], note.tile_size) ||
        !parse_number(values["state"], state_bytes)) {
        return false;
    }
    note.index = part[0];
    note.count = part[1];
    note.pictures = values["pictures"];
    return true;
}

}  // namespace

CheckpointNote checkpoint_note(const ir::Scene& scene, const renderer::Settings& settings) {
    CheckpointNote note;
    static_cast<RenderIdentity&>(note) = identify(scene, settings, {});
    note.index = settings.shard_index + 1;
    note.count = settings.shard_count;
    note.tile_size = settings.shard_count > 1 ? settings.tile_size : 0;
    note.pictures = "color";
    if (settings.want_depth) note.pictures += ",depth";
    if (settings.want_normals) note.pictures += ",normals";
    if (settings.want_albedo) note.pictures += ",albedo";
    if (settings.want_sample_count) note.pictures += ",sample-count";
    return note;
}

std::string encode_checkpoint(const CheckpointNote& note, std::string_view state) {
    std::string bytes = fmt::format("{}{}{} shard {}/{} tiles {} pictures {} state {}\n", kMagic,
                                    kFormat, words_of(note), note.index, note.count, note.tile_size,
                                    note.pictures, state.size());
    bytes.reserve(bytes.size() + state.size() + kDigestBytes);
    bytes += state;
    for (const std::uint8_t byte : digest_of(bytes)) bytes += static_cast<char>(byte);
    return bytes;
}

Checkpoint decode_checkpoint(std::string_view bytes, const CheckpointNote& note) {
    Checkpoint result;
    const auto refuse = [&result](std::string problem) {
        result.problem = std::move(problem);
        return result;
    };
    const std::string_view begin = bytes.substr(0, kMagic.size());
    if (begin != kMagic.substr(0, begin.size())) return refuse("it is no checkpoint of a render");
    const std::size_t line_end = bytes.substr(0, kMaxLine).find('\n');
    if (line_end == std::string_view::npos) {
        return refuse(bytes.size() < kMaxLine ? "it is cut off in its first line"
                                              : "it is damaged in its first line");
    }
    std::string_view line = bytes.substr(0, line_end);
    line.remove_prefix(kMagic.size());
    const std::size_t number_end = std::min(line.find(' '), line.size());
    const std::string_view format = line.substr(0, number_end);
    line.remove_prefix(std::min(number_end + 1, line.size()));
    std::uint32_t number = 0;
    if (parse_number(format, number) && number > kFormat) {
        return refuse(fmt::format("its format is {}, of a later version of cobble", number));
    }
    CheckpointNote found;
    std::uint64_t state_bytes = 0;
    if (number != kFormat || !read_line(line, found, state_bytes) || state_bytes > kMaxBytes) {
        return refuse("it is damaged in its first line");
    }
    const std::uint64_t there = bytes.size() - line_end - 1;
    if (there < kDigestBytes || there - kDigestBytes < state_bytes) {
        return refuse(fmt::format("it is cut off: {} of its {} bytes are there", bytes.size(),
                                  line_end + 1 + state_bytes + kDigestBytes));
    }
    const std::string_view summed = bytes.substr(0, bytes.size() - kDigestBytes);
    const ir::Sha256::Digest digest = digest_of(summed);
    const bool sound = std::equal(digest.begin(), digest.end(), bytes.end() - kDigestBytes,
                                  [](std::uint8_t a, char b) { return static_cast<char>(a) == b; });
    if (!sound || there - kDigestBytes != state_bytes) {
        return refuse("it is damaged: its contents do not match its checksum");
    }
    if (std::string other = difference(note, found); !other.empty()) {
        return refuse("it is of another render: " + other);
    }
    result.state = summed.substr(line_end + 1);
    return result;
}

Checkpoint read_checkpoint(const std::string& path, const CheckpointNote& note) {
    Checkpoint result;
    DiskFileSource disk;
    const source::ReadResult file = disk.read(path, kMaxBytes);
    result.missing = file.status == source::ReadStatus::kMissing;
    if (result.missing) return result;
    if (file.status == source::ReadStatus::kOk) {
        result = decode_checkpoint(file.bytes, note);
    } else {
        result.problem = file.reason;
    }
    if (!result.problem.empty()) {
        result.problem = fmt::format("cannot resume from {}: {}", path, result.problem);
    }
    return result;
}

}  // namespace cobble::driver
