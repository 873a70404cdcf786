// SPDX-License-Identifier: MIT
#include "frontend/editor/members.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::BlockId;
using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Role;

bool is_object(Role role) {
    return role == Role::kObject || role == Role::kGroup || role == Role::kTransform;
}

/// A move that no Motion can repeat, and that cannot stand beside one.
bool is_fixed(const BlockRow& row) {
    return row.role == Role::kMove && !grammar::may_stand_in(row.id, BlockId::kMotion);
}

}  // namespace

Members members_of(const CheckedScene& scene, const Typing& typing) {
    Members members;
    for (NodeId child = scene.cst.first_child(typing.around); child.valid();
         child = scene.cst.next_child(typing.around, child)) {
        const TokenId name{scene.cst.node(child).first_token};
        if (name == typing.word) continue;
        const grammar::WordId word = grammar::find_word(scene.tokens.text_of(name));
        if (const BlockRow* row = grammar::block_named(word)) {
            ++members.blocks[static_cast<std::size_t>(row->id)];
            if (typing.block == nullptr || !grammar::may_stand_in(row->id, typing.block->id)) {
                continue;
            }
            if (row->role != Role::kMaterialIndex) ++members.counted;
            const bool before = scene.tokens.range(name).begin < typing.span.begin;
            members.object |= is_object(row->role);
            members.object_before |= is_object(row->role) && before;
            members.matrix |= is_fixed(*row);
            members.motion_before |= row->role == Role::kMotion && before;
            members.move_behind |=
                (row->role == Role::kMove || row->role == Role::kMotion) && !before;
        } else if (typing.block != nullptr) {
            const FieldRow* field = grammar::field_named(typing.block->id, word);
            if (field != nullptr) ++members.fields[static_cast<std::size_t>(field->id)];
        }
    }
    return members;
}

bool fits(const BlockRow& row, const Typing& typing, const Members& members) {
    const bool there = members.blocks[static_cast<std::size_t>(row.id)] > 0;
    // Each section stands once.
    if (typing.block == nullptr) return grammar::may_stand_at_top(row.id) && !there;
    if (!grammar::may_stand_in(row.id, typing.block->id)) return false;
    if (row.role == Role::kNoise) return !there;
    if (typing.block->role != Role::kTransform) return true;
    // A Transform holds one object, behind everything else.
    if (is_object(row.role)) return !members.object && !members.move_behind;
    if (row.role == Role::kMotion) {
        return !there && !members.object_before && !members.move_behind && !members.matrix;
    }
    if (is_fixed(row) && members.blocks[static_cast<std::size_t>(BlockId::kMotion)] > 0) {
        return false;
    }
    return !members.object_before && !members.motion_before;
}

}  // namespace cobble::frontend::editor
