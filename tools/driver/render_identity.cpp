// SPDX-License-Identifier: MIT
#include "tools/driver/render_identity.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "ir/hash.hpp"
#include "ir/output/sha256.hpp"
#include "tools/driver/numbers.hpp"

namespace cobble::driver {
namespace {

// 64 bits of a hash tell renders apart; the whole of it would not fit a picture's comment.
constexpr std::size_t kHashDigits = 16;

std::string hash_of(const std::string& text) {
    ir::Sha256 hash;
    hash.add(text.data(), text.size());
    return ir::to_hex(hash.finish()).substr(0, kHashDigits);
}

std::string size_of(const RenderIdentity& identity) {
    return fmt::format("{}x{}", identity.width, identity.height);
}

std::string text_of(const renderer::Crop& crop) {
    return fmt::format("{},{},{},{}", crop.x0, crop.y0, crop.x1, crop.y1);
}

}  // namespace

RenderIdentity identify(const ir::Scene& scene, const renderer::Settings& settings,
                        std::string_view more) {
    RenderIdentity identity;
    identity.width = settings.width;
    identity.height = settings.height;
    identity.window = renderer::window_of(settings);
    identity.scene = ir::hash(scene).substr(0, kHashDigits);
    identity.samples = settings.samples;
    identity.seed = settings.seed;
    // The crop, samples and seed are part of it too: to differ in those is told by its own name.
    identity.settings = hash_of(fmt::format("{}{} {}", renderer::fingerprint(settings),
                                            static_cast<int>(scene.compat), more));
    identity.version = COBBLE_VERSION;
    return identity;
}

std::vector<Property> properties_of(const RenderIdentity& first, const RenderIdentity& second) {
    return {{"size", size_of(first), size_of(second)},
            {"crop", text_of(first.window), text_of(second.window)},
            {"it shows another scene", first.scene, second.scene, true},
            {"number of samples", std::to_string(first.samples), std::to_string(second.samples)},
            {"seed", std::to_string(first.seed), std::to_string(second.seed)},
            {"version of cobble", first.version, second.version},
            {"it has other options", first.settings, second.settings, true}};
}

std::string first_difference(const std::vector<Property>& properties) {
    for (const Property& property : properties) {
        if (property.first == property.second) continue;
        if (property.hash) return std::string(property.name);
        return fmt::format("its {} is {}, not {}", property.name, property.second, property.first);
    }
    return {};
}

std::string words_of(const RenderIdentity& identity) {
    return fmt::format(" of {} at {} scene {} samples {} seed {} settings {} version {}",
                       size_of(identity), text_of(identity.window), identity.scene,
                       identity.samples, identity.seed, identity.settings, identity.version);
}

WordValues parse_words(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    WordValues values;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) values[words[i]] = words[i + 1];
    return values;
}

bool read_identity(WordValues& values, RenderIdentity& identity) {
    std::vector<std::uint32_t> size;
    std::vector<std::uint32_t> window;
    const bool read = parse_numbers(values["of"], 'x', 2, size) &&
                      parse_numbers(values["at"], ',', 4, window) &&
                      parse_number(values["samples"], identity.samples) &&
                      parse_number(values["seed"], identity.seed);
    if (!read || window[0] >= window[2] || window[1] >= window[3] || window[2] > size[0] ||
        window[3] > size[1]) {
        return false;
    }
    identity.width = size[0];
    identity.height = size[1];
    identity.window = {window[0], window[1], window[2], window[3]};
    identity.scene = values["scene"];
    identity.settings = values["settings"];
    identity.version = values["version"];
    return true;
}

}  // namespace cobble::driver
