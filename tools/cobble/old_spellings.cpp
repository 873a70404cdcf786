// SPDX-License-Identifier: MIT
#include "tools/cobble/old_spellings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "tools/cobble/option_values.hpp"

namespace cobble {
namespace {

struct Spelling {
    std::string_view old;
    std::size_t values;
    std::vector<std::string> (*rewrite)(const std::string* values);
    /// Several values that become one: what they must be, in words, and whether they are.
    std::string_view wants = {};
    bool (*fits)(const std::string* values) = nullptr;
};

using Words = std::vector<std::string>;

// A path for a positional argument: one that begins with a dash is no option.
std::string as_path(const std::string& path) {
    return path.size() > 1 && path.starts_with('-') ? "./" + path : path;
}

const Spelling kSpellings[] = {
    {"-input", 1, [](const std::string* v) { return Words{as_path(v[0])}; }},
    {"-output", 1, [](const std::string* v) { return Words{"--output=" + v[0]}; }},
    {"-size", 2, [](const std::string* v) { return Words{"--size=" + v[0] + "x" + v[1]}; },
     "a width and a height in pixels, such as 640 480",
     [](const std::string* v) { return parse_size(v[0] + "x" + v[1]).has_value(); }},
    {"-depth", 3,
     [](const std::string* v) {
         return Words{"--depth-range=" + v[0] + "," + v[1], "--depth=" + v[2]};
     },
     "MIN MAX FILE with MIN below MAX, such as 2 10 depth.png",
     [](const std::string* v) { return parse_depth_range(v[0] + "," + v[1]).has_value(); }},
    {"-normals", 1, [](const std::string* v) { return Words{"--normals=" + v[0]}; }},
    {"-bounces", 1, [](const std::string* v) { return Words{"--bounces=" + v[0]}; }},
    {"-shadows", 0, [](const std::string*) { return Words{"--original-shadows"}; }},
    {"-jitter", 0, [](const std::string*) { return Words{"--original-jitter"}; }},
    {"-filter", 0, [](const std::string*) { return Words{"--original-filter"}; }},
    {"-casting", 0, [](const std::string*) { return Words{"--original-casting"}; }},
    {"-blurry", 1, [](const std::string* v) { return Words{"--original-blurry=" + v[0]}; }},
    {"-pixelated", 0, [](const std::string*) { return Words{"--original-pixelated"}; }},
};

const Spelling* find(std::string_view word) {
    const auto* found =
        std::find_if(std::begin(kSpellings), std::end(kSpellings),
                     [word](const Spelling& spelling) { return spelling.old == word; });
    return found == std::end(kSpellings) ? nullptr : found;
}

bool is_option(std::string_view argument, std::string_view name) {
    return argument == name ||
           (argument.starts_with(name) && argument.substr(name.size()).starts_with('='));
}

bool has_option(const std::vector<std::string>& arguments, std::string_view name) {
    return std::any_of(arguments.begin(), arguments.end(),
                       [name](const std::string& a) { return is_option(a, name); });
}

}  // namespace

std::string rewrite_old_spellings(std::vector<std::string>& arguments) {
    if (arguments.empty()) return {};
    const bool original = find(arguments.front()) != nullptr;
    if (!original && arguments.front() != "render") return {};

    std::vector<std::string> result;
    if (original) result.emplace_back("render");
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        // After "--" everything is a path.
        if (arguments[i] == "--") {
            result.insert(result.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i),
                          arguments.end());
            break;
        }
        const Spelling* spelling = find(arguments[i]);
        if (spelling == nullptr) {
            result.push_back(arguments[i]);
            continue;
        }
        if (arguments.size() - i - 1 < spelling->values) {
            return fmt::format("'{}' wants {} value{}", spelling->old, spelling->values,
                               spelling->values == 1 ? "" : "s");
        }
        if (spelling->fits != nullptr && !spelling->fits(arguments.data() + i + 1)) {
            std::string found;
            for (std::size_t k = 1; k <= spelling->values; ++k) {
                found += (k == 1 ? "" : " ") + arguments[i + k];
            }
            return fmt::format("'{}' wants {}, not '{}'", spelling->old, spelling->wants, found);
        }
        for (std::string& piece : spelling->rewrite(arguments.data() + i + 1)) {
            result.push_back(std::move(piece));
        }
        i += spelling->values;
    }
    if (original) {
        // Only where the user says nothing, as no option may be given twice.
        std::vector<std::string> defaults;
        if (!has_option(result, "--size")) defaults.emplace_back("--size=100x100");
        if (!has_option(result, "--compat")) defaults.emplace_back("--compat=project");
        result.insert(result.begin() + 1, defaults.begin(), defaults.end());
    }
    arguments = std::move(result);
    return {};
}

}  // namespace cobble
