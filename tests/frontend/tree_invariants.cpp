// SPDX-License-Identifier: MIT
#include "tests/frontend/tree_invariants.hpp"

#include <fmt/format.h>

#include <vector>

namespace cobble::test {
namespace {

using namespace frontend;

// White space and comments between two tokens; the rest becomes '?'.
std::string gap(const Tokens& tokens, std::uint32_t begin, std::uint32_t end,
                std::size_t& comment) {
    std::string result;
    while (begin < end) {
        if (comment < tokens.comments.size() && tokens.comments[comment].begin == begin) {
            const ByteRange range = tokens.comments[comment++];
            result += tokens.text.substr(range.begin, range.end - range.begin);
            begin = range.end;
            continue;
        }
        const char byte = tokens.text[begin];
        const bool mark = begin < 3 && tokens.text.starts_with("\xEF\xBB\xBF");
        const bool white = std::string_view(" \t\r\n\v\f").find(byte) != std::string_view::npos;
        result += mark || white ? byte : '?';
        ++begin;
    }
    return result;
}

class TreeWalk {
  public:
    TreeWalk(const Tokens& tokens, const Cst& cst) : tokens_(tokens), cst_(cst) {}

    std::string fault() {
        const auto count = static_cast<std::uint32_t>(cst_.nodes.size());
        const CstNode& file = cst_.nodes[0];
        if (file.first_token != 0 || file.end_token != tokens_.size()) return "file's tokens";
        if (file.end_node != count) return "file's nodes";
        ends_.push_back(0);
        for (std::uint32_t i = 1; i < count; ++i) {
            const CstNode& node = cst_.nodes[i];
            while (cst_.nodes[ends_.back()].end_node <= i) leave();
            const CstNode& parent = cst_.nodes[ends_.back()];
            if (node.end_node <= i || node.end_node > parent.end_node) return at(i, "end_node");
            if (node.first_token < reached_) return at(i, "overlaps what is before it");
            if (node.first_token >= node.end_token) return at(i, "is empty");
            if (node.end_token > parent.end_token) return at(i, "reaches out of its parent");
            if (std::string own = own_fault(i); !own.empty()) return own;
            const NodeKind kind = static_cast<NodeKind>(node.kind);
            const bool nests = kind == NodeKind::kBlock || kind == NodeKind::kNameless;
            if (!nests && node.end_node != i + 1) return at(i, "has children");
            // Tokens between the parent's head, its children and its } belong to no node.
            const std::uint32_t expected = is_first(i) ? head_end(ends_.back()) : reached_;
            if (node.first_token != expected) return at(i, "leaves tokens out before it");
            ends_.push_back(i);
            reached_ = node.first_token;
            if (!nests || node.end_node == i + 1) reached_ = nests ? head_end(i) : node.end_token;
        }
        while (!ends_.empty()) leave();
        return fault_;
    }

  private:
    static std::string at(std::uint32_t node, std::string_view what) {
        return fmt::format("node {} {}", node, what);
    }

    bool is_first(std::uint32_t node) const { return ends_.back() + 1 == node; }

    std::uint32_t head_end(std::uint32_t index) const {
        const CstNode& node = cst_.nodes[index];
        if (index == 0) return 0;
        const TokenId brace = open_brace_of(tokens_, node);
        if (brace.valid()) return brace.value + 1;
        if (node.end_node == index + 1) return node.end_token;
        const TokenId label = label_of(tokens_, node);
        return label.valid() ? label.value + 1 : node.first_token + 1;
    }

    void leave() {
        const CstNode& node = cst_.nodes[ends_.back()];
        const NodeKind kind = static_cast<NodeKind>(node.kind);
        const bool nests = kind == NodeKind::kBlock || kind == NodeKind::kNameless;
        const bool closed = tokens_.kind({node.end_token - 1}) == TokenKind::kCloseBrace;
        const std::uint32_t due = ends_.back() == 0 || (nests && closed && node.unclosed == 0 &&
                                                        reached_ < node.end_token)
                                      ? node.end_token - 1
                                      : node.end_token;
        if (fault_.empty() && reached_ != due) fault_ = at(ends_.back(), "leaves tokens out");
        reached_ = node.end_token;
        ends_.pop_back();
    }

    std::string own_fault(std::uint32_t index) const {
        const CstNode& node = cst_.nodes[index];
        const TokenKind first = tokens_.kind({node.first_token});
        const bool error = node.has_error != 0;
        switch (static_cast<NodeKind>(node.kind)) {
            case NodeKind::kFile:
                return at(index, "is a second file");
            case NodeKind::kBlock:
                if (first != TokenKind::kWord) return at(index, "has no name");
                if (!open_brace_of(tokens_, node).valid() && !error) return at(index, "lacks {");
                if (node.unclosed != 0 && !error) return at(index, "is unclosed without error");
                break;
            case NodeKind::kField:
                if (first != TokenKind::kWord) return at(index, "has no name");
                break;
            case NodeKind::kNumbers:
                break;
            case NodeKind::kStrayClose:
                if (first != TokenKind::kCloseBrace || !error) return at(index, "is no stray }");
                break;
            case NodeKind::kNameless:
                if (first != TokenKind::kOpenBrace || !error) return at(index, "is not nameless");
                break;
            case NodeKind::kStrayValue:
            case NodeKind::kUnknown:
                if (!error) return at(index, "is no error");
                break;
        }
        return "";
    }

    const Tokens& tokens_;
    const Cst& cst_;
    std::vector<std::uint32_t> ends_;  // the nodes around the current one
    std::uint32_t reached_ = 0;        // the first token that no node has had yet
    std::string fault_;
};

}  // namespace

std::string rebuilt(const Tokens& tokens) {
    std::string result;
    std::uint32_t at = 0;
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const ByteRange range = tokens.range({i});
        if (range.begin < at) return "tokens overlap";
        result += gap(tokens, at, range.begin, comment);
        result += tokens.text_of({i});
        at = range.end;
    }
    return result;
}

std::string tree_fault(const Tokens& tokens, const Cst& cst) {
    return TreeWalk(tokens, cst).fault();
}

}  // namespace cobble::test
