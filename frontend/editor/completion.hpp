// SPDX-License-Identifier: MIT
// What may be written at an offset, and which value of a field an offset is in.
//
// Input: a checked scene, its text and the byte offset of the cursor; the file is half typed more
// often than not. Output: only what may stand there: blocks that fit and are not there already,
// fields that the block takes and does not have yet, words and materials where a value is one, and
// placeholders where numbers are due. Nothing in comments, where a label goes, and in blocks that
// nobody knows. Cost: the siblings along the path to the offset, and one pass over the materials
// where a material is due.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/editor/links.hpp"

namespace cobble::frontend::editor {

enum class CompletionKind : std::uint8_t { kBlock, kField, kKeyword, kMaterial, kValue };

struct CompletionItem {
    std::string label;
    CompletionKind kind;
    std::string detail;         ///< one line, plain
    std::string documentation;  ///< Markdown
    std::string insert;         ///< plain text that replaces `span`
    std::string snippet;        ///< the same with tab stops; empty if there are none
    std::uint32_t rank = 0;     ///< smaller first; items come in this order
    ByteRange span;             ///< what is replaced: the word at the cursor, or nothing there
};

/// A path is due, which is the caller's to list: this phase reads no files.
struct ExpectedPath {
    PathKind kind = PathKind::kNone;
    std::string prefix;  ///< what is written of it before the cursor, without a quote
    ByteRange span;      ///< the whole path without quotes, to be replaced
    bool quoted = false;
};

struct Completion {
    std::vector<CompletionItem> items;
    ExpectedPath expects_path;
};

/// Before values, a label or a brace on its line a name is completed to itself, not to a whole
/// field or block. Lines of an inserted text after its first are indented as if the first were not:
/// clients add the indentation of the line.
Completion complete(const CheckedScene& scene, std::string_view text, std::uint32_t offset);

/// The field or inline block whose values surround an offset.
struct Signature {
    std::string label;                    ///< "center x y z"
    std::vector<ByteRange> parameters;    ///< of each component, within `label`
    std::vector<std::string> components;  ///< "x", "y", "z"
    std::uint32_t active = 0;             ///< the component that the offset is in, or that is next
    std::string documentation;            ///< Markdown
    bool found = false;                   ///< false: no field is there, and all else is empty
};

/// `active` stays at the last component for values too many.
Signature signature(const CheckedScene& scene, std::string_view text, std::uint32_t offset);

}  // namespace cobble::frontend::editor
