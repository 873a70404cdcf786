// SPDX-License-Identifier: MIT
// What the editor questions answer, as text: for the expectations beside the case files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::frontend::editor::testing {

/// A text with its cursors: every `<|>` is taken out, and stands for an offset.
struct Marked {
    std::string text;
    std::vector<std::uint32_t> cursors;
};

Marked read_marks(std::string_view marked);

/// The answers to one question ("outline", "hover", ...) about a text and its cursors; empty for a
/// question that there is not.
std::string answer(std::string_view question, const Marked& marked);

}  // namespace cobble::frontend::editor::testing
