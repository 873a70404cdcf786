// SPDX-License-Identifier: MIT
#include "frontend/check/examples.hpp"

#include <deque>
#include <string>
#include <utility>

namespace cobble::frontend {
namespace {

constexpr std::string_view kSphere =
    "Sphere {\n"
    "    center 0 0 0\n"
    "    radius 1\n"
    "}\n";

/// A view of `text` that stays.
std::string_view kept(std::string text) {
    static std::deque<std::string> texts;  // a deque moves nothing
    return texts.emplace_back(std::move(text));
}

std::string block(std::string_view name, std::string_view members) {
    std::string text(name);
    text += " {\n";
    while (!members.empty()) {
        const std::string_view line = members.substr(0, members.find('\n') + 1);
        text.append("    ").append(line);
        members.remove_prefix(line.size());
    }
    return text + "}\n";
}

std::string joined(std::string_view first, std::string_view second) {
    return std::string(first).append(second);
}

}  // namespace

std::string_view camera_example(std::string_view lines) {
    return kept(
        block("PerspectiveCamera", joined("center 0 0 10\ndirection 0 0 -1\nup 0 1 0\n", lines)));
}

std::string_view transform_example(std::string_view lines) {
    const std::string transform = block("Transform", joined(lines, kSphere));
    return kept(block("Group", joined("MaterialIndex 0\n", transform)));
}

std::string_view object_example(std::string_view materials, std::string_view lines) {
    return kept(block("Materials", materials) + block("Group", joined(lines, kSphere)));
}

}  // namespace cobble::frontend
