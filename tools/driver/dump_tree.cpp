// SPDX-License-Identifier: MIT
#include "tools/driver/dump_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "frontend/source/line_index.hpp"
#include "grammar/vocabulary.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using frontend::ByteRange;
using frontend::NodeId;
using frontend::NodeKind;
using frontend::TokenId;
using frontend::TokenKind;

// Deeper nesting than anyone writes, and lines stay short: a million levels are no square.
constexpr std::size_t kMaxIndent = 40;
// As much of a long token or list as tells what it is.
constexpr std::size_t kMaxText = 200;
constexpr std::uint32_t kMaxTokens = 20;

std::string_view name_of(TokenKind kind) {
    switch (kind) {
        case TokenKind::kOpenBrace:
            return "open";
        case TokenKind::kCloseBrace:
            return "close";
        case TokenKind::kNumber:
            return "number";
        case TokenKind::kColor:
            return "color";
        case TokenKind::kWord:
            return "word";
        case TokenKind::kString:
            return "string";
        case TokenKind::kUnterminatedString:
            return "unterminated";
        case TokenKind::kEndOfFile:
            return "end";
    }
    return "?";
}

std::string_view name_of(NodeKind kind) {
    switch (kind) {
        case NodeKind::kFile:
            return "file";
        case NodeKind::kBlock:
            return "block";
        case NodeKind::kField:
            return "field";
        case NodeKind::kNumbers:
            return "numbers";
        case NodeKind::kStrayValue:
            return "stray-value";
        case NodeKind::kStrayClose:
            return "stray-close";
        case NodeKind::kNameless:
            return "nameless";
        case NodeKind::kUnknown:
            return "unknown";
    }
    return "?";
}

std::string indent(std::size_t depth) {
    if (depth <= kMaxIndent) return std::string(2 * depth, ' ');
    return fmt::format("{}({}) ", std::string(2 * kMaxIndent, ' '), depth);
}

std::string shortened(std::string_view text) {
    const bool cut = text.size() > kMaxText;
    return printable(text.substr(0, kMaxText)) + (cut ? "..." : "");
}

// The tokens [first, end), the first few of them.
std::string words(const frontend::Tokens& tokens, std::uint32_t first, std::uint32_t end) {
    std::string text;
    for (std::uint32_t i = first; i < end; ++i) {
        if (i - first == kMaxTokens || text.size() > kMaxText) return text + " ...";
        text += " " + shortened(tokens.text_of(TokenId{i}));
    }
    return text;
}

// Positions of ever later offsets, without a look back: lines can be as long as the file.
class Walker {
  public:
    explicit Walker(std::string_view text) : text_(text) {
        if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
    }
    source::LineColumn operator()(std::uint32_t offset) {
        while (at_ < offset) {
            const CodePoint point = next_code_point(text_.substr(at_));
            if (point.bytes == 0 || at_ + point.bytes > offset) break;
            const bool pair = point.value == '\r' && text_.substr(at_ + 1).starts_with('\n');
            if (point.value == '\n' || (point.value == '\r' && !pair)) {
                place_ = {place_.line + 1, 1};
            } else {
                ++place_.column;
            }
            at_ += point.bytes;
        }
        return place_;
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    source::LineColumn place_;
};

}  // namespace

void dump_tokens(const frontend::CheckedScene& scene, const DumpSink& sink) {
    const frontend::Tokens& tokens = scene.tokens;
    Walker place(tokens.text);
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const TokenId id{i};
        const ByteRange range = tokens.range(id);
        for (; comment < tokens.comments.size() && tokens.comments[comment].begin < range.begin;
             ++comment) {
            const ByteRange at = tokens.comments[comment];
            const auto where = place(at.begin);
            if (!sink(fmt::format("{}:{} comment {}\n", where.line, where.column,
                                  shortened(tokens.text.substr(at.begin, at.end - at.begin))))) {
                return;
            }
        }
        const auto where = place(range.begin);
        const std::string text = shortened(tokens.text_of(id));
        if (!sink(fmt::format("{}:{} {}{}{}\n", where.line, where.column, name_of(tokens.kind(id)),
                              text.empty() ? "" : " ", text))) {
            return;
        }
    }
}

void dump_cst(const frontend::CheckedScene& scene, const DumpSink& sink) {
    const auto& nodes = scene.cst.nodes;
    std::vector<std::uint32_t> ends;  // of the open nodes
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        while (!ends.empty() && ends.back() <= i) ends.pop_back();
        const frontend::CstNode& node = nodes[i];
        // A node's own words end where its first child begins.
        const bool parent = i + 1 < node.end_node;
        std::uint32_t end = parent ? nodes[i + 1].first_token : node.end_token;
        if (scene.cst.kind(NodeId{i}) == NodeKind::kFile) end = node.first_token;
        const std::string line =
            fmt::format("{}{}{}{}{}\n", indent(ends.size()), name_of(scene.cst.kind(NodeId{i})),
                        node.has_error != 0 ? " error" : "", node.unclosed != 0 ? " unclosed" : "",
                        words(scene.tokens, node.first_token, end));
        if (!sink(line)) return;
        ends.push_back(node.end_node);
    }
}

void dump_ast(const frontend::CheckedScene& scene, const DumpSink& sink) {
    const frontend::Ast& ast = scene.ast;
    struct Open {
        frontend::BlockNodeId id;
        std::size_t depth;
    };
    std::vector<Open> open;
    for (auto root = ast.roots.rbegin(); root != ast.roots.rend(); ++root) {
        open.push_back({*root, 0});
    }
    while (!open.empty()) {
        const Open at = open.back();
        open.pop_back();
        const frontend::BlockNode& block = ast.block(at.id);
        std::string line = indent(at.depth) + std::string(grammar::row(block.row).name);
        if (block.label.valid()) line += " " + shortened(scene.tokens.text_of(block.label));
        if (at.id.value < scene.material_of_block.size()) {
            const std::uint32_t material = scene.material_of_block[at.id.value];
            if (material != frontend::CheckedScene::kNoMaterial) {
                line += fmt::format(" (material {})", material);
            }
        }
        line += block.broken ? " broken\n" : "\n";
        for (const frontend::FieldNode& field : ast.fields_of(at.id)) {
            line += indent(at.depth + 1) + std::string(grammar::row(field.row).name);
            const auto values = ast.values_of(field);
            for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), kMaxTokens); ++i) {
                const TokenId token = values[i].token;
                const bool word = grammar::is_word(grammar::row(field.row).type) ||
                                  !token.valid() || scene.tokens.kind(token) == TokenKind::kWord;
                line += word && token.valid() ? " " + shortened(scene.tokens.text_of(token))
                                              : fmt::format(" {}", values[i].number);
            }
            line += field.broken ? " broken\n" : "\n";
        }
        if (!sink(line)) return;
        const auto children = ast.children_of(at.id);
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            open.push_back({*child, at.depth + 1});
        }
    }
}

}  // namespace cobble::driver
