// SPDX-License-Identifier: MIT
#include "frontend/editor/outline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/editor/materials.hpp"
#include "frontend/editor/place.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::Role;
using grammar::ValueType;

/// Which type of field says most about a block, from 0 on.
int rank_of(ValueType type, Role role) {
    switch (type) {
        case ValueType::kImagePath:
        case ValueType::kMeshPath:
        case ValueType::kFolderPath:
            return 0;
        case ValueType::kColor:
            return role == Role::kObject ? 4 : 1;
        case ValueType::kNumber:
            return 2;
        case ValueType::kVector3:
            return 3;
        default:
            return 5;
    }
}

const FieldNode* key_field(const CheckedScene& scene, BlockNodeId id) {
    const Role role = grammar::row(scene.ast.block(id).row).role;
    const FieldNode* best = nullptr;
    int best_rank = 5;
    for (const FieldNode& field : scene.ast.fields_of(id)) {
        const int rank = rank_of(grammar::row(field.row).type, role);
        if (field.broken || rank >= best_rank) continue;
        best = &field;
        best_rank = rank;
    }
    return best;
}

std::string members_text(const CheckedScene& scene, BlockNodeId id) {
    std::string moves;
    std::size_t others = 0;
    std::size_t named = 0;
    for (const BlockNodeId child : scene.ast.children_of(id)) {
        const grammar::BlockRow& row = grammar::row(scene.ast.block(child).row);
        if (row.role == Role::kMove) {
            // More of them make the line no clearer.
            constexpr std::size_t kMost = 4;
            if (++named <= kMost) {
                if (!moves.empty()) moves += ", ";
                moves += row.name;
            } else if (named == kMost + 1) {
                moves += ", ...";
            }
        } else if (row.role != Role::kMaterialIndex) {
            ++others;
        }
    }
    if (!moves.empty()) return moves;
    return fmt::format("{} member{}", others, others == 1 ? "" : "s");
}

std::string detail_of(const CheckedScene& scene, BlockNodeId id) {
    const BlockNode& block = scene.ast.block(id);
    const grammar::BlockRow& row = grammar::row(block.row);
    std::string detail;
    const auto add = [&detail](std::string_view more) {
        if (!detail.empty() && !more.empty()) detail += ", ";
        detail += more;
    };
    if (block.label.valid()) add(row.name);
    if (const std::uint32_t index = material_index(scene, id); index != CheckedScene::kNoMaterial) {
        add(fmt::format("number {}", index));
    }
    if (id.value < scene.material_of_block.size()) {
        const std::uint32_t material = scene.material_of_block[id.value];
        if (material != CheckedScene::kNoMaterial) {
            const std::string_view label = label_text(scene, scene.materials[material]);
            add(label.empty() ? fmt::format("material {}", material) : std::string(label));
        }
    }
    if (row.layout == grammar::Layout::kList) {
        add(members_text(scene, id));
    } else if (const FieldNode* field = key_field(scene, id)) {
        add(fmt::format("{} {}", grammar::row(field->row).name, values_text(scene, *field)));
    }
    return detail;
}

bool is_listed(Role role) { return role != Role::kMaterialIndex && role != Role::kMove; }

/// Where lines end, for asking whether two offsets share a line.
class LineEnds {
  public:
    explicit LineEnds(std::string_view text) {
        for (std::size_t at = text.find_first_of("\r\n"); at != std::string_view::npos;
             at = text.find_first_of("\r\n", at + 1)) {
            // The LF of a CRLF ends no line of its own.
            if (text[at] == '\n' && at > 0 && text[at - 1] == '\r') continue;
            ends_.push_back(static_cast<std::uint32_t>(at));
        }
    }
    [[nodiscard]] std::uint32_t line_of(std::uint32_t offset) const {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(ends_, offset) - ends_.begin());
    }

  private:
    std::vector<std::uint32_t> ends_;
};

/// True if nothing but blanks stands before a comment on its line.
bool stands_alone(std::string_view text, std::uint32_t begin) {
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
    if (begin == 3 && text.starts_with("\xEF\xBB\xBF")) return true;
    return begin == 0 || text[begin - 1] == '\n' || text[begin - 1] == '\r';
}

void add_comment_folds(const CheckedScene& scene, std::string_view text, const LineEnds& lines,
                       std::vector<Fold>& found) {
    const auto& comments = scene.tokens.comments;
    for (std::size_t i = 0; i < comments.size();) {
        std::size_t end = i + 1;
        if (stands_alone(text, comments[i].begin)) {
            while (end < comments.size() && stands_alone(text, comments[end].begin) &&
                   lines.line_of(comments[end].begin) ==
                       lines.line_of(comments[end - 1].begin) + 1) {
                ++end;
            }
        }
        if (end - i >= 2) {
            found.push_back({{comments[i].end, comments[end - 1].end}, FoldKind::kComment});
        }
        i = end;
    }
}

}  // namespace

std::vector<OutlineItem> outline(const CheckedScene& scene, std::string_view) {
    std::vector<OutlineItem> items;
    std::vector<std::uint32_t> open;  // items that may still get descendants
    const auto& blocks = scene.ast.blocks;
    std::vector<std::uint32_t> depths(blocks.size(), 0);
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        const BlockNode& block = blocks[i];
        const grammar::BlockRow& row = grammar::row(block.row);
        depths[i] = block.parent.valid() ? depths[block.parent.value] + 1 : 0;
        if (!is_listed(row.role)) continue;
        const auto index = static_cast<std::uint32_t>(items.size());
        while (!open.empty() && items[open.back()].depth >= depths[i]) {
            items[open.back()].end = index;
            open.pop_back();
        }
        const TokenId name{scene.cst.node(block.cst).first_token};
        OutlineItem item;
        item.name = block.label.valid() ? scene.tokens.word_of(block.label) : row.name;
        item.detail = detail_of(scene, {i});
        item.role = row.role;
        item.block = {i};
        item.span = bytes_of(scene, block.cst);
        item.name_span = scene.tokens.range(block.label.valid() ? block.label : name);
        item.depth = depths[i];
        items.push_back(std::move(item));
        open.push_back(index);
    }
    for (const std::uint32_t index : open) {
        items[index].end = static_cast<std::uint32_t>(items.size());
    }
    return items;
}

std::vector<Fold> folds(const CheckedScene& scene, std::string_view text) {
    std::vector<Fold> found;
    if (scene.tokens.text.empty()) return found;
    const LineEnds lines(text);
    for (const CstNode& node : scene.cst.nodes) {
        if (static_cast<NodeKind>(node.kind) != NodeKind::kBlock) continue;
        const TokenId brace = open_brace_of(scene.tokens, node);
        if (!brace.valid()) continue;
        // A block without its } folds up to its last member.
        const TokenId last{node.end_token - 1};
        const std::uint32_t begin = scene.tokens.range(brace).end;
        const std::uint32_t end =
            node.unclosed != 0 ? scene.tokens.range(last).end : scene.tokens.range(last).begin;
        if (end <= begin || lines.line_of(begin) == lines.line_of(end)) continue;
        found.push_back({{begin, end}, FoldKind::kBlock});
    }
    add_comment_folds(scene, text, lines, found);
    std::ranges::stable_sort(found, {}, [](const Fold& fold) { return fold.span.begin; });
    return found;
}

std::vector<ByteRange> selections(const CheckedScene& scene, std::string_view text,
                                  std::uint32_t offset) {
    const auto size = static_cast<std::uint32_t>(text.size());
    offset = std::min(offset, size);
    std::vector<ByteRange> ranges;  // from the smallest
    const auto add = [&ranges, offset](ByteRange range) {
        if (range.begin > offset || range.end < offset) return;
        if (!ranges.empty()) {
            const ByteRange inner = ranges.back();
            if (range.begin > inner.begin || range.end < inner.end || range == inner) return;
        }
        ranges.push_back(range);
    };
    const TokenId token = token_at(scene, offset);
    std::vector<NodeId> path;
    if (token.valid()) {
        add(scene.tokens.range(token));
        path = path_to(scene, token);
    } else {
        for (const ByteRange comment : scene.tokens.comments) {
            if (comment.begin > offset) break;
            add(comment);
        }
        // In white space: what is around the gap holds the next token or the last one.
        const TokenId next = token_from(scene, offset);
        const Gap gap = gap_before(scene, next);
        path = path_to(scene, TokenId{scene.cst.node(gap.around).first_token});
        if (gap.before.valid() && gap.around == path.back()) path.push_back(gap.before);
    }
    for (auto node = path.rbegin(); node != path.rend(); ++node) {
        const CstNode& record = scene.cst.node(*node);
        const NodeKind kind = scene.cst.kind(*node);
        if (kind == NodeKind::kField && record.end_token > record.first_token + 1) {
            add({scene.tokens.range({record.first_token + 1}).begin,
                 scene.tokens.range({record.end_token - 1}).end});
        } else if (kind == NodeKind::kBlock) {
            const TokenId brace = open_brace_of(scene.tokens, record);
            if (brace.valid() && record.unclosed == 0) {
                add({scene.tokens.range(brace).end,
                     scene.tokens.range({record.end_token - 1}).begin});
            }
        }
        if (kind != NodeKind::kFile) add(bytes_of(scene, *node));
    }
    add({0, size});
    return ranges;
}

}  // namespace cobble::frontend::editor
