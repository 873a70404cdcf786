// SPDX-License-Identifier: MIT
#include "frontend/format/proof.hpp"

#include <fmt/format.h>

#include "frontend/format/writer.hpp"

namespace cobble::frontend {
namespace {

bool same_node(const CstNode& a, const CstNode& b) {
    return a.kind == b.kind && a.has_error == b.has_error && a.unclosed == b.unclosed &&
           a.first_token == b.first_token && a.end_token == b.end_token && a.end_node == b.end_node;
}

std::string_view comment_text(const Tokens& tokens, std::size_t index) {
    const ByteRange range = tokens.comments[index];
    std::string_view text = tokens.text.substr(range.begin, range.end - range.begin);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// True if a line end, or the start of the file, stands between the comment and what is before it.
bool on_own_line(const Tokens& tokens, std::size_t index) {
    const std::uint32_t start = tokens.text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    std::uint32_t at = tokens.comments[index].begin;
    while (at > start && is_blank(tokens.text[at - 1])) --at;
    return at == start || is_line_end(tokens.text[at - 1]);
}

}  // namespace

std::string token_difference(const Tokens& before, const Tokens& after) {
    if (before.size() != after.size()) {
        return fmt::format("{} tokens became {}", before.size(), after.size());
    }
    if (before.comments.size() != after.comments.size()) {
        return fmt::format("{} comments became {}", before.comments.size(), after.comments.size());
    }
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < before.size(); ++i) {
        const TokenId id{i};
        const ByteRange old_range{before.tokens[i].begin, end_of(before, i)};
        const ByteRange new_range{after.tokens[i].begin, end_of(after, i)};
        while (comment < before.comments.size() &&
               before.comments[comment].begin < old_range.begin) {
            if (after.comments[comment].begin >= new_range.begin ||
                comment_text(before, comment) != comment_text(after, comment) ||
                on_own_line(before, comment) != on_own_line(after, comment)) {
                return fmt::format("the comment at byte {} changed or moved",
                                   before.comments[comment].begin);
            }
            ++comment;
        }
        if (comment < after.comments.size() && after.comments[comment].begin < new_range.begin) {
            return fmt::format("the comment at byte {} moved", before.comments[comment].begin);
        }
        if (before.kind(id) != after.kind(id) ||
            before.text.substr(old_range.begin, old_range.end - old_range.begin) !=
                after.text.substr(new_range.begin, new_range.end - new_range.begin)) {
            return fmt::format("the token at byte {} changed", old_range.begin);
        }
    }
    return {};
}

std::string tree_difference(const Cst& before, const Cst& after) {
    if (before.nodes.size() != after.nodes.size()) {
        return fmt::format("{} nodes became {}", before.nodes.size(), after.nodes.size());
    }
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
        if (!same_node(before.nodes[i], after.nodes[i])) {
            return fmt::format("node {} at token {} changed", i, before.nodes[i].first_token);
        }
    }
    return {};
}

}  // namespace cobble::frontend
