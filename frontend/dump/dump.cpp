// SPDX-License-Identifier: MIT
#include "frontend/dump/dump.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/source/line_index.hpp"
#include "frontend/source/utf8.hpp"

namespace cobble::frontend {
namespace {

constexpr std::size_t kIndentedLevels = 40;
// A node's values are cut off here: sixteen numbers of a matrix fit, a mistake of a million does
// not.
constexpr std::uint32_t kShownTokens = 24;
constexpr std::size_t kShownBytes = 200;

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
            return "unterminated-string";
        case TokenKind::kEndOfFile:
            return "end";
    }
    return "";
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
    return "";
}

class Writer {
  public:
    explicit Writer(const Tokens& tokens) : tokens_(tokens), lines_(tokens.text) {}

    void place(std::uint32_t offset, std::size_t depth) {
        if (depth <= kIndentedLevels) {
            out_.append(2 * depth, ' ');
        } else {
            fmt::format_to(std::back_inserter(out_), "{:{}}[{}] ", "", 2 * kIndentedLevels, depth);
        }
        const source::LineColumn at = lines_.locate(offset);
        fmt::format_to(std::back_inserter(out_), "{}:{} ", at.line, at.column);
    }

    void text(std::string_view text) { out_ += text; }
    void number(double value) { fmt::format_to(std::back_inserter(out_), " {}", value); }

    /// The bytes of the file between two offsets, made printable.
    void bytes(std::uint32_t begin, std::uint32_t end) {
        std::string_view rest = tokens_.text.substr(begin, end - begin);
        const bool cut = rest.size() > kShownBytes;
        rest = rest.substr(0, kShownBytes);
        while (!rest.empty()) {
            const std::size_t length = source::utf8_length(rest);
            const auto byte = static_cast<unsigned char>(rest[0]);
            if (length == 0 || byte < 0x20 || byte == 0x7f) {
                fmt::format_to(std::back_inserter(out_), "\\x{:02X}", byte);
                rest.remove_prefix(1);
            } else {
                out_ += rest.substr(0, length);
                rest.remove_prefix(length);
            }
        }
        if (cut) out_ += "...";
    }

    void token(std::uint32_t token) {
        const ByteRange range = tokens_.range({token});
        bytes(range.begin, range.end);
    }

    void tokens(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            out_ += ' ';
            if (i - begin == kShownTokens) {
                out_ += "...";
                return;
            }
            token(i);
        }
    }

    std::string take() { return std::move(out_); }

  private:
    const Tokens& tokens_;
    source::LineIndex lines_;
    std::string out_;
};

// Where the shown tokens of a node end: a block's at its {.
std::uint32_t head_end(const Tokens& tokens, const CstNode& node) {
    switch (static_cast<NodeKind>(node.kind)) {
        case NodeKind::kFile:
            return node.first_token;
        case NodeKind::kBlock: {
            const TokenId brace = open_brace_of(tokens, node);
            if (brace.valid()) return brace.value + 1;
            const TokenId label = label_of(tokens, node);
            return label.valid() ? label.value + 1 : node.first_token + 1;
        }
        case NodeKind::kNameless:
            return node.first_token + 1;
        default:
            return node.end_token;
    }
}

void write_block(Writer& out, const Tokens& tokens, const Cst& cst, const Ast& ast, BlockNodeId id,
                 std::size_t depth) {
    const BlockNode& block = ast.block(id);
    out.place(tokens.tokens[cst.node(block.cst).first_token].begin, depth);
    out.text(grammar::row(block.row).name);
    if (block.label.valid()) {
        out.text(" ");
        out.token(block.label.value);
    }
    out.text(block.broken ? " broken\n" : "\n");
    for (const FieldNode& field : ast.fields_of(id)) {
        out.place(tokens.tokens[cst.node(field.cst).first_token].begin, depth + 1);
        out.text(grammar::row(field.row).name);
        out.text(" =");
        for (const Value& value : ast.values_of(field)) {
            const TokenKind kind = tokens.kind(value.token);
            if (kind == TokenKind::kNumber || kind == TokenKind::kColor) {
                out.number(value.number);
            } else {
                out.tokens(value.token.value, value.token.value + 1);
            }
        }
        out.text(field.broken ? " broken\n" : "\n");
    }
}

}  // namespace

std::string dump_tokens(const Tokens& tokens) {
    Writer out(tokens);
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const std::uint32_t begin = tokens.tokens[i].begin;
        for (; comment < tokens.comments.size() && tokens.comments[comment].begin < begin;
             ++comment) {
            const ByteRange range = tokens.comments[comment];
            out.place(range.begin, 0);
            out.text("comment ");
            out.bytes(range.begin, range.end);
            out.text("\n");
        }
        out.place(begin, 0);
        out.text(name_of(tokens.kind({i})));
        if (i + 1 < tokens.size()) out.tokens(i, i + 1);
        out.text("\n");
    }
    return out.take();
}

std::string dump_cst(const Tokens& tokens, const Cst& cst) {
    Writer out(tokens);
    std::vector<std::uint32_t> ends;  // of the nodes around the current one
    for (std::uint32_t i = 0; i < cst.nodes.size(); ++i) {
        while (!ends.empty() && ends.back() <= i) ends.pop_back();
        const CstNode& node = cst.nodes[i];
        out.place(tokens.tokens[node.first_token].begin, ends.size());
        out.text(name_of(static_cast<NodeKind>(node.kind)));
        out.tokens(node.first_token, head_end(tokens, node));
        if (node.has_error != 0) out.text(" error");
        if (node.unclosed != 0) out.text(" unclosed");
        out.text("\n");
        ends.push_back(node.end_node);
    }
    return out.take();
}

std::string dump_ast(const Tokens& tokens, const Cst& cst, const Ast& ast) {
    Writer out(tokens);
    struct Open {
        BlockNodeId block;
        std::size_t depth;
    };
    std::vector<Open> waiting;  // the next block last
    for (auto root = ast.roots.rbegin(); root != ast.roots.rend(); ++root) {
        waiting.push_back({*root, 0});
    }
    while (!waiting.empty()) {
        const Open next = waiting.back();
        waiting.pop_back();
        write_block(out, tokens, cst, ast, next.block, next.depth);
        const auto children = ast.children_of(next.block);
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            waiting.push_back({*child, next.depth + 1});
        }
    }
    return out.take();
}

}  // namespace cobble::frontend
