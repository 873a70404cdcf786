// SPDX-License-Identifier: MIT
// Arguments that are missing or given twice.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/names/describe.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kMissingArgument{
    "missing-argument",
    source::Severity::kError,
    "a block lacks an argument that it needs",
    "Some arguments have no sensible default: a camera must know where it looks, a sphere how "
    "large it is. Without one of them the block is left out of the picture.",
    "Lights {\n"
    "    DirectionalLight {\n"
    "        color 0.9 0.9 0.9\n"
    "    }\n"
    "}\n",
    "Add the argument. The note lists everything that the block takes."};

const source::DiagnosticCode kExpectedArgument{
    "light-incomplete",
    source::Severity::kWarning,
    "a PointLight has no place or no colour",
    "A PointLight without `position` stands at the origin and one without `color` is black. "
    "Published programs accept both, but neither is likely to be meant.",
    "Lights {\n"
    "    PointLight {\n"
    "        color 1 1 1\n"
    "    }\n"
    "}\n",
    "Write `position` and `color`, even where they are `0 0 0`."};

const source::DiagnosticCode kDuplicateArgument{
    "duplicate-argument",
    source::Severity::kError,
    "an argument is given twice",
    "The block takes this argument once, and it is not clear which of the two is meant.",
    camera_example("angle 30\n"
                   "angle 45\n"),
    "Remove one of the two."};

const source::DiagnosticCode kOverriddenArgument{
    "overridden-argument",
    source::Severity::kWarning,
    "an argument is given twice and the last wins",
    "In Background, PointLight and materials a repeated argument replaces the earlier one, as it "
    "does in the published programs. The earlier one has no effect.",
    "Materials {\n"
    "    Material {\n"
    "        diffuseColor 1 0 0\n"
    "        diffuseColor 0 1 0\n"
    "    }\n"
    "}\n",
    "Remove the earlier one."};

/// One bit per field of a block, in the order of the vocabulary.
struct BlockFacts {
    std::uint8_t first = 0;  ///< FieldId of bit 0
    std::uint32_t required = 0;
    std::uint32_t expected = 0;
    std::uint32_t twice = 0;
};

std::array<BlockFacts, grammar::kBlockCount> make_facts() {
    std::array<BlockFacts, grammar::kBlockCount> facts;
    for (const grammar::BlockRow& block : grammar::blocks()) {
        BlockFacts& fact = facts[static_cast<std::size_t>(block.id)];
        const auto rows = grammar::fields_of(block.id);
        if (!rows.empty()) fact.first = static_cast<std::uint8_t>(rows.front().id);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::uint32_t bit = std::uint32_t{1} << i;
            if (rows[i].presence == grammar::Presence::kRequired) fact.required |= bit;
            if (rows[i].presence == grammar::Presence::kExpected) fact.expected |= bit;
            if (rows[i].repeat == grammar::Repeat::kTwice) fact.twice |= bit;
        }
    }
    return facts;
}

const BlockFacts& facts_of(grammar::BlockId block) {
    static const auto facts = make_facts();
    return facts[static_cast<std::size_t>(block)];
}

std::uint32_t bit_of(const BlockFacts& facts, const FieldNode& field) {
    return std::uint32_t{1} << (static_cast<std::uint8_t>(field.row) - facts.first);
}

/// The names of the fields in `mask` that no complaint of the parser accounts for.
std::vector<std::string_view> unexplained(const CheckContext& context, BlockNodeId id,
                                          std::uint32_t mask) {
    std::vector<std::string_view> names;
    for (const grammar::FieldRow& field : grammar::fields_of(context.block(id).row)) {
        if ((mask & 1U) != 0 && !context.explained(id, field.name)) names.push_back(field.name);
        mask >>= 1U;
    }
    return names;
}

void report_duplicate(CheckContext& context, BlockNodeId id, const FieldNode& first,
                      const FieldNode& again) {
    const grammar::FieldRow& row = grammar::row(again.row);
    const bool last_wins = row.repeat == grammar::Repeat::kLastWins;
    const std::string_view block = context.name(id);
    const bool same =
        context.text(context.value_span(first)) == context.text(context.value_span(again));
    if (last_wins) {
        auto& diagnostic = context.report(
            kOverriddenArgument, context.name_span(again),
            fmt::format("'{}' of {} is given again and replaces the earlier one", row.name, block));
        diagnostic.related.push_back(
            {context.name_span(first), fmt::format("this '{}' has no effect", row.name)});
        if (!again.broken) {
            diagnostic.fixes.push_back({fmt::format("remove the earlier '{}'", row.name),
                                        true,
                                        {{context.removal_span(first.cst), ""}}});
        }
        return;
    }
    const bool twice = row.repeat == grammar::Repeat::kTwice;
    auto& diagnostic =
        context.report(kDuplicateArgument, context.name_span(again),
                       twice ? fmt::format("{} takes '{}' twice at most", block, row.name)
                             : fmt::format("'{}' of {} is given twice", row.name, block));
    diagnostic.related.push_back(
        {context.name_span(first), fmt::format("'{}' is already given here", row.name)});
    // If both say the same it does not matter which one goes.
    diagnostic.fixes.push_back({fmt::format("remove this '{}'", row.name),
                                same && !twice,
                                {{context.removal_span(again.cst), ""}}});
}

}  // namespace

void check_missing_arguments(CheckContext& context, BlockNodeId id) {
    const BlockNode& block = context.block(id);
    const BlockFacts& facts = facts_of(block.row);
    std::uint32_t missing = facts.required | facts.expected;
    if (missing == 0) return;
    const grammar::Layout layout = context.row(id).layout;
    if (layout == grammar::Layout::kInline || layout == grammar::Layout::kPositional) return;
    for (const FieldNode& field : context.ast().fields_of(id)) missing &= ~bit_of(facts, field);
    if (missing == 0 || !context.reliable(id)) return;

    const auto required = unexplained(context, id, missing & facts.required);
    if (!required.empty()) {
        auto& diagnostic = context.report(
            kMissingArgument, context.name_span(id),
            fmt::format("missing argument{} {} in {}", required.size() == 1 ? "" : "s",
                        quoted_list(required), context.name(id)));
        diagnostic.notes.push_back(what_it_takes(block.row));
    }
    for (const std::string_view name : unexplained(context, id, missing & facts.expected)) {
        auto& diagnostic =
            context.report(kExpectedArgument, context.name_span(id),
                           fmt::format("{} has no '{}', which is then {}", context.name(id), name,
                                       grammar::find_field(block.row, name)->fallback));
        diagnostic.notes.push_back(what_it_takes(block.row));
    }
}

void check_duplicate_arguments(CheckContext& context, BlockNodeId id) {
    const grammar::Layout layout = context.row(id).layout;
    if (layout == grammar::Layout::kInline || layout == grammar::Layout::kPositional) return;
    const BlockFacts& facts = facts_of(context.block(id).row);
    const auto fields = context.ast().fields_of(id);
    std::uint32_t seen = 0;
    std::uint32_t seen_twice = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::uint32_t bit = bit_of(facts, fields[i]);
        if ((seen & bit) == 0) {
            seen |= bit;
            continue;
        }
        if ((facts.twice & bit) != 0 && (seen_twice & bit) == 0) {
            seen_twice |= bit;
            continue;
        }
        // The one that this one replaces: the nearest before it.
        std::size_t before = i - 1;
        while (fields[before].row != fields[i].row) --before;
        report_duplicate(context, id, fields[before], fields[i]);
    }
}

void check_repeated_noise(CheckContext& context, BlockNodeId id) {
    BlockNodeId before;
    for (const BlockNodeId child : context.ast().children_of(id)) {
        if (context.block(child).row != grammar::BlockId::kNoise) continue;
        if (before.valid()) {
            auto& diagnostic = context.report(
                kOverriddenArgument, context.name_span(child),
                fmt::format("Noise of {} is given again and replaces the earlier one",
                            context.name(id)));
            diagnostic.related.push_back({context.name_span(before), "this Noise has no effect"});
            if (!context.block(child).broken) {
                diagnostic.fixes.push_back(
                    {"remove the earlier Noise",
                     true,
                     {{context.removal_span(context.block(before).cst), ""}}});
            }
        }
        before = child;
    }
}

}  // namespace cobble::frontend
