// SPDX-License-Identifier: MIT
#include "tests/frontend/editor/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/check/check.hpp"
#include "frontend/editor/colors.hpp"
#include "frontend/editor/completion.hpp"
#include "frontend/editor/hover.hpp"
#include "frontend/editor/inlay.hpp"
#include "frontend/editor/links.hpp"
#include "frontend/editor/outline.hpp"
#include "frontend/editor/references.hpp"
#include "frontend/editor/semantic_tokens.hpp"
#include "frontend/source/line_index.hpp"

namespace cobble::frontend::editor::testing {
namespace {

/// Lines are indented behind the first, so that answers of several lines stay readable.
std::string shown(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c;
        if (c == '\n') result += "        | ";
    }
    return result;
}

class Answers {
  public:
    explicit Answers(const Marked& marked)
        : text_(marked.text), lines_(text_), scene_(check(source::SourceId{0}, text_)) {}

    std::string outline() const {
        std::string out;
        for (const OutlineItem& item : editor::outline(scene_, text_)) {
            out += fmt::format("{}{} [{}] {} name {} role {} end {}\n",
                               std::string(std::size_t{2} * item.depth, ' '), item.name,
                               item.detail, place(item.span), place(item.name_span),
                               static_cast<int>(item.role), item.end);
        }
        for (const Fold& fold : folds(scene_, text_)) {
            out += fmt::format("fold {} {}\n", fold.kind == FoldKind::kBlock ? "block" : "comment",
                               place(fold.span));
        }
        return out;
    }
    std::string tokens() const {
        std::string out;
        for (const SemanticToken& token : semantic_tokens(scene_, text_)) {
            const ByteRange range{token.begin, token.begin + token.length};
            out +=
                fmt::format("{} {} {}", place(range),
                            kSemanticTypeNames[static_cast<std::size_t>(token.type)], piece(range));
            if (token.block != grammar::BlockId::kCount_) {
                out += fmt::format(" in {}", grammar::row(token.block).name);
            }
            out += '\n';
        }
        return out;
    }
    std::string colors() const {
        std::string out;
        for (const ColorValue& color : editor::colors(scene_, text_)) {
            const auto ways = color_presentations(color.r, color.g, color.b);
            out += fmt::format("{} {} -> {:.4f} {:.4f} {:.4f}{}{}, written {} or {}\n",
                               place(color.span), piece(color.span), color.r, color.g, color.b,
                               color.as_hex ? " hex" : "", color.cut_off ? " cut off" : "", ways[0],
                               ways[1]);
        }
        return out;
    }
    std::string links() const {
        constexpr std::string_view kKinds[] = {"none", "image", "mesh", "folder"};
        std::string out;
        for (const PathLink& link : editor::links(scene_, text_)) {
            out += fmt::format("link {} {} {}\n", place(link.span),
                               kKinds[static_cast<std::size_t>(link.kind)], link.path);
        }
        for (const InlayHint& hint : inlay_hints(scene_, text_)) {
            out += fmt::format("hint {} {} for material {}\n", place({hint.offset, hint.offset}),
                               hint.text, hint.material);
        }
        return out;
    }
    std::string selections(std::uint32_t at) const {
        std::string out;
        for (const ByteRange range : editor::selections(scene_, text_, at)) {
            const std::string_view bytes = piece(range);
            std::string line(bytes.substr(0, 30));
            std::ranges::replace(line, '\n', ' ');
            out +=
                fmt::format("  {} \"{}\"{}\n", place(range), line, bytes.size() > 30 ? " ..." : "");
        }
        return out;
    }
    std::string hover(std::uint32_t at) const {
        const auto found = editor::hover(scene_, text_, at);
        if (!found) return "  nothing\n";
        std::string out = fmt::format("  {} {}\n", place(found->span), found->title);
        for (const std::string& paragraph : found->paragraphs) {
            out += fmt::format("      {}\n", shown(paragraph));
        }
        return out;
    }
    std::string completion(std::uint32_t at) const {
        constexpr std::string_view kKinds[] = {"block", "field", "keyword", "material", "value"};
        constexpr std::string_view kPaths[] = {"none", "image", "mesh", "folder"};
        const Completion found = complete(scene_, text_, at);
        std::string out;
        if (found.expects_path.kind != PathKind::kNone) {
            out += fmt::format("  {} path {} after \"{}\"{}\n", place(found.expects_path.span),
                               kPaths[static_cast<std::size_t>(found.expects_path.kind)],
                               found.expects_path.prefix,
                               found.expects_path.quoted ? " in quotes" : "");
        }
        for (const CompletionItem& item : found.items) {
            out += fmt::format("  {} {} {} [{}] {} -> {}\n", place(item.span), item.rank,
                               kKinds[static_cast<std::size_t>(item.kind)], item.label, item.detail,
                               shown(item.snippet.empty() ? item.insert : item.snippet));
        }
        return out.empty() ? "  nothing\n" : out;
    }
    std::string signature(std::uint32_t at) const {
        const Signature found = editor::signature(scene_, text_, at);
        if (!found.found) return "  nothing\n";
        const ByteRange active = found.parameters[found.active];
        return fmt::format("  {} -> {} ({})\n", found.label,
                           found.label.substr(active.begin, active.end - active.begin),
                           found.active);
    }
    std::string references(std::uint32_t at) const {
        std::string out;
        if (const auto found = definition(scene_, text_, at)) {
            out += fmt::format("  from {} to {} in {}\n", place(found->origin),
                               place(found->name_span), place(found->span));
        }
        for (const Reference& reference : editor::references(scene_, text_, at)) {
            out += fmt::format("  {} {} {}\n", reference.is_definition ? "definition" : "use",
                               place(reference.span), piece(reference.span));
        }
        const RenameTarget target = rename_target(scene_, text_, at);
        out += target.refusal.empty()
                   ? fmt::format("  rename {} from {}\n", place(target.span), target.current)
                   : fmt::format("  no rename: {}\n", target.refusal);
        for (const std::string_view name : {"fresh", "Sphere", "no good", "stone"}) {
            const Rename result = rename(scene_, text_, at, name);
            out += fmt::format("  to '{}':", name);
            if (!result.refusal.empty()) out += fmt::format(" refused, {}", result.refusal);
            for (const TextEdit& edit : result.edits) {
                out += fmt::format(" {} \"{}\"", place(edit.span), edit.text);
            }
            out += '\n';
        }
        return out;
    }
    std::string place_of(std::uint32_t at) const {
        const auto where = lines_.locate(at);
        return fmt::format("{}:{}", where.line, where.column);
    }

  private:
    [[nodiscard]] std::string place(ByteRange range) const {
        const auto begin = lines_.locate(range.begin);
        const auto end = lines_.locate(range.end);
        if (begin == end) return fmt::format("{}:{}", begin.line, begin.column);
        if (begin.line == end.line) {
            return fmt::format("{}:{}-{}", begin.line, begin.column, end.column);
        }
        return fmt::format("{}:{}-{}:{}", begin.line, begin.column, end.line, end.column);
    }
    [[nodiscard]] std::string_view piece(ByteRange range) const {
        return text_.substr(range.begin, range.end - range.begin);
    }

    std::string_view text_;
    source::LineIndex lines_;
    CheckedScene scene_;
};

struct WholeFile {
    std::string_view name;
    std::string (Answers::*ask)() const;
};
constexpr WholeFile kWholeFile[] = {{"outline", &Answers::outline},
                                    {"tokens", &Answers::tokens},
                                    {"colors", &Answers::colors},
                                    {"links", &Answers::links}};

struct AtCursor {
    std::string_view name;
    std::string (Answers::*ask)(std::uint32_t) const;
};
constexpr AtCursor kAtCursor[] = {{"selections", &Answers::selections},
                                  {"hover", &Answers::hover},
                                  {"completion", &Answers::completion},
                                  {"signature", &Answers::signature},
                                  {"references", &Answers::references}};

}  // namespace

Marked read_marks(std::string_view marked) {
    constexpr std::string_view kMark = "<|>";
    Marked result;
    while (!marked.empty()) {
        const std::size_t at = marked.find(kMark);
        result.text += marked.substr(0, at);
        if (at == std::string_view::npos) break;
        result.cursors.push_back(static_cast<std::uint32_t>(result.text.size()));
        marked.remove_prefix(at + kMark.size());
    }
    return result;
}

std::string answer(std::string_view question, const Marked& marked) {
    const Answers answers(marked);
    for (const WholeFile& one : kWholeFile) {
        if (one.name == question) return (answers.*one.ask)();
    }
    std::string out;
    for (const AtCursor& one : kAtCursor) {
        if (one.name != question) continue;
        for (const std::uint32_t cursor : marked.cursors) {
            out += fmt::format("at {}\n{}", answers.place_of(cursor), (answers.*one.ask)(cursor));
        }
    }
    return out;
}

}  // namespace cobble::frontend::editor::testing
