// SPDX-License-Identifier: MIT
// What every object is made of. `MaterialIndex` is one state of the whole file, in textual order
// and across groups, as in the published programs; labels work beside numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "frontend/ast/reporter.hpp"
#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/names/suggest.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kMaterialOutOfRange{
    "material-index-out-of-range",
    source::Severity::kError,
    "there is no material of this number",
    "Materials are numbered from 0 in the order in which they stand, so that the last of three is "
    "number 2.",
    object_example("Material {\n"
                   "}\n",
                   "MaterialIndex 1\n"),
    "Write a number below the count of materials, or give the material a label and write that."};

const source::DiagnosticCode kUnknownMaterial{
    "unknown-material",
    source::Severity::kError,
    "no material has this label",
    "`MaterialIndex` takes a number or the label of a material.",
    object_example("Material stone {\n"
                   "}\n",
                   "MaterialIndex stoen\n"),
    "Write the label as it stands behind the material's name, in the same case."};

const source::DiagnosticCode kObjectBeforeMaterial{
    "object-before-material",
    source::Severity::kError,
    "an object stands before any MaterialIndex",
    "An object is made of what the last `MaterialIndex` before it says, and there is none. "
    "Published programs stop there.",
    object_example("Material {\n"
                   "}\n",
                   ""),
    "Write `MaterialIndex 0` before the first object."};

const source::DiagnosticCode kUnusedMaterial{"unused-material",
                                             source::Severity::kWarning,
                                             "no object is made of this material",
                                             "It has no effect on the picture.",
                                             "Materials {\n"
                                             "    Material {\n"
                                             "        diffuseColor 1 0 0\n"
                                             "    }\n"
                                             "}\n"
                                             "Group {\n"
                                             "}\n",
                                             "Remove it if it is the last one (otherwise the "
                                             "numbers of those behind it change), or use it."};

/// Walks the file once and keeps the state that MaterialIndex sets.
class Resolver {
  public:
    explicit Resolver(CheckContext& context) : context_(context) {}

    void run() {
        find_materials();
        context_.scene.material_of_block.assign(context_.ast().blocks.size(),
                                                CheckedScene::kNoMaterial);
        used_.assign(context_.scene.materials.size(), false);
        named_ = used_;
        for (std::uint32_t i = 0; i < context_.ast().blocks.size(); ++i) {
            const BlockNode& block = context_.ast().blocks[i];
            if (block.row == grammar::BlockId::kMaterialIndex) {
                set_material(BlockNodeId{i});
            } else if (grammar::row(block.row).role == grammar::Role::kObject) {
                use_material(BlockNodeId{i});
            }
        }
        report_before_material();
        report_unused();
    }

  private:
    void find_materials() {
        for (const BlockNodeId root : context_.ast().roots) {
            if (context_.block(root).row != grammar::BlockId::kMaterials) continue;
            // Of two lists, which is an error, the last counts, as in the published programs.
            certain_ = !section_.valid() && context_.strange_members(root) == 0;
            section_ = root;
        }
        if (context_.ast().structure_broken) certain_ = false;
        if (!section_.valid()) {
            if (context_.explained(BlockNodeId{}, "Materials")) certain_ = false;
            return;
        }
        for (const BlockNodeId child : context_.ast().children_of(section_)) {
            if (context_.row(child).role != grammar::Role::kMaterial) continue;
            const auto index = static_cast<std::uint32_t>(context_.scene.materials.size());
            context_.scene.materials.push_back(child);
            const TokenId label = context_.block(child).label;
            if (!label.valid()) continue;
            if (by_label_.try_emplace(context_.tokens().word_of(label), index).second) {
                labels_.push_back(context_.tokens().word_of(label));
            }
        }
    }

    void set_material(BlockNodeId id) {
        any_index_ = true;
        current_ = CheckedScene::kNoMaterial;
        const auto fields = context_.ast().fields_of(id);
        if (fields.empty() || fields[0].broken || fields[0].value_count != 1 ||
            context_.block(id).broken) {
            all_resolved_ = false;
            return;
        }
        const Value& value = context_.ast().values_of(fields[0])[0];
        if (context_.tokens().kind(value.token) == TokenKind::kNumber) {
            set_by_number(value);
        } else {
            set_by_label(value);
        }
        if (current_ == CheckedScene::kNoMaterial) all_resolved_ = false;
    }

    void set_by_number(const Value& value) {
        const std::size_t count = context_.scene.materials.size();
        if (value.number >= 0 && value.number < static_cast<double>(count) &&
            std::floor(value.number) == value.number) {
            current_ = static_cast<std::uint32_t>(value.number);
            named_[current_] = true;
            return;
        }
        if (!certain_) return;
        // Without any materials every index is wrong, and one finding says so.
        if (count == 0 && reported_none_) return;
        reported_none_ = count == 0;
        const source::Span place = context_.span(value.token);
        auto& diagnostic =
            context_.report(kMaterialOutOfRange, place,
                            fmt::format("there is no material {}", context_.shown(place)));
        if (count == 0) {
            diagnostic.notes.emplace_back("the scene has no materials");
        } else {
            diagnostic.notes.push_back(
                count == 1 ? std::string("there is one material, number 0")
                           : fmt::format("there are {} materials, 0 to {}", count, count - 1));
            diagnostic.related.push_back(
                {context_.name_span(section_), "the materials stand here"});
        }
    }

    void set_by_label(const Value& value) {
        const std::string_view label = context_.tokens().word_of(value.token);
        const auto found = by_label_.find(label);
        if (found != by_label_.end()) {
            current_ = found->second;
            named_[current_] = true;
            return;
        }
        if (!certain_) return;
        const source::Span place = context_.span(value.token);
        auto& diagnostic = context_.report(kUnknownMaterial, place,
                                           fmt::format("no material is called {}", quoted(label)));
        const std::string_view near = suggestion(label);
        if (!near.empty()) {
            diagnostic.notes.push_back(fmt::format("did you mean '{}'?", near));
            diagnostic.fixes.push_back(
                {fmt::format("write '{}'", near), false, {{place, std::string(near)}}});
        } else if (labels_.empty()) {
            diagnostic.notes.emplace_back("no material has a label");
        }
    }

    std::string_view suggestion(std::string_view label) {
        if (labels_.size() > comparisons_left_) return {};
        comparisons_left_ -= labels_.size();
        return nearest_name(label, labels_);
    }

    void use_material(BlockNodeId id) {
        if (any_index_) {
            if (current_ == CheckedScene::kNoMaterial) return;
            context_.scene.material_of_block[id.value] = current_;
            used_[current_] = true;
            return;
        }
        if (context_.block(id).broken) return;
        if (!first_bare_.valid()) first_bare_ = id;
        ++bare_count_;
    }

    /// True if something in the groups around an object was meant to say what it is made of: a
    /// misspelt MaterialIndex, or a material where older dialects had it, in the Group itself.
    [[nodiscard]] bool material_was_meant(BlockNodeId object) const {
        for (BlockNodeId at = context_.block(object).parent; at.valid();
             at = context_.block(at).parent) {
            if (context_.explained(at, "MaterialIndex")) return true;
            for (const BlockNodeId child : context_.ast().children_of(at)) {
                if (context_.row(child).role == grammar::Role::kMaterial) return true;
            }
        }
        return false;
    }

    void report_before_material() {
        if (!first_bare_.valid() || context_.ast().structure_broken) return;
        if (material_was_meant(first_bare_)) return;
        auto& diagnostic = context_.report(
            kObjectBeforeMaterial, context_.name_span(first_bare_),
            fmt::format("{} stands before any MaterialIndex", context_.name(first_bare_)));
        if (bare_count_ > 1) {
            diagnostic.notes.push_back(fmt::format("so do{} {} more object{}",
                                                   bare_count_ == 2 ? "es" : "", bare_count_ - 1,
                                                   bare_count_ == 2 ? "" : "s"));
        }
        if (context_.scene.materials.empty()) return;
        diagnostic.notes.emplace_back(
            "write 'MaterialIndex' and the number or label of a material before it, in its Group");
        // On a line of its own if the object stands on one.
        const source::Span name = context_.name_span(first_bare_);
        const TokenId token{context_.scene.cst.node(context_.block(first_bare_).cst).first_token};
        std::string text = "MaterialIndex 0";
        if (context_.tokens().first_on_line(token)) {
            std::uint32_t begin = name.begin;
            const std::string_view file = context_.tokens().text;
            while (begin > 0 && (file[begin - 1] == ' ' || file[begin - 1] == '\t')) --begin;
            text += '\n';
            text += file.substr(begin, name.begin - begin);
        } else {
            text += ' ';
        }
        // Which material is meant is a guess; inside a Transform there is no place for it.
        const BlockNodeId parent_block = context_.block(first_bare_).parent;
        if (parent_block.valid() && context_.block(parent_block).row == grammar::BlockId::kGroup) {
            diagnostic.fixes.push_back({"put 'MaterialIndex 0' before it",
                                        false,
                                        {{{name.source, name.begin, name.begin}, text}}});
        }
    }

    /// True if objects may stand where they are not seen: in a block of no known name, or in a
    /// Group that is missing as a whole.
    [[nodiscard]] bool objects_may_hide() const {
        const auto is_group = [this](BlockNodeId root) {
            return context_.block(root).row == grammar::BlockId::kGroup;
        };
        if (std::ranges::none_of(context_.ast().roots, is_group)) return true;
        if (context_.scene.diagnostics.empty()) return false;
        return std::ranges::any_of(context_.scene.cst.nodes, [this](const CstNode& node) {
            const auto kind = static_cast<NodeKind>(node.kind);
            if (kind == NodeKind::kNameless) return true;
            if (kind != NodeKind::kBlock || node.has_error == 0) return false;
            const TokenId name{node.first_token};
            return grammar::find_block(context_.tokens().text_of(name)) == nullptr;
        });
    }

    void report_unused() {
        // An index that means nothing may have meant any of them.
        if (!certain_ || !all_resolved_ || first_bare_.valid()) return;
        // Where an error may have kept an object from being seen, being named is being used.
        const bool errors =
            !context_.scene.diagnostics.empty() || context_.count(source::Severity::kError) > 0;
        if (errors) {
            for (std::size_t i = 0; i < used_.size(); ++i) used_[i] = used_[i] || named_[i];
        }
        if (std::ranges::find(used_, false) == used_.end() || objects_may_hide()) return;
        for (std::size_t i = 0; i < used_.size(); ++i) {
            const BlockNodeId material = context_.scene.materials[i];
            if (used_[i] || context_.block(material).broken) continue;
            const TokenId label = context_.block(material).label;
            context_.report(kUnusedMaterial, context_.name_span(material),
                            label.valid() ? fmt::format("material {}, '{}', is not used", i,
                                                        context_.tokens().word_of(label))
                                          : fmt::format("material {} is not used", i));
        }
    }

    CheckContext& context_;
    BlockNodeId section_;
    bool certain_ = true;  ///< the list of materials is what its author meant
    std::unordered_map<std::string_view, std::uint32_t> by_label_;
    std::vector<std::string_view> labels_;
    /// Suggestions end when this many labels have been looked at, which takes about 0.1 s:
    /// thousands of unknown labels against thousands of known ones would take minutes.
    std::size_t comparisons_left_ = 1000000;
    std::vector<bool> used_;   ///< an object is made of it
    std::vector<bool> named_;  ///< a MaterialIndex means it

    bool any_index_ = false;
    bool all_resolved_ = true;
    bool reported_none_ = false;
    std::uint32_t current_ = CheckedScene::kNoMaterial;
    BlockNodeId first_bare_;  ///< the first object before any MaterialIndex
    std::uint32_t bare_count_ = 0;
};

}  // namespace

void resolve_materials(CheckContext& context) { Resolver(context).run(); }

}  // namespace cobble::frontend
