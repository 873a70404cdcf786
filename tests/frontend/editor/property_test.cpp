// SPDX-License-Identifier: MIT
// What must hold for the editor questions at every offset of every text, whole, cut off or damaged:
// no crash, ranges inside the text, tokens in order, and changes that leave no new error.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/editor/colors.hpp"
#include "frontend/editor/completion.hpp"
#include "frontend/editor/hover.hpp"
#include "frontend/editor/inlay.hpp"
#include "frontend/editor/links.hpp"
#include "frontend/editor/outline.hpp"
#include "frontend/editor/place.hpp"
#include "frontend/editor/references.hpp"
#include "frontend/editor/row_words.hpp"
#include "frontend/editor/semantic_tokens.hpp"
#include "frontend/source/utf8.hpp"
#include "tests/frontend/case_text.hpp"
#include "tests/frontend/editor/answers.hpp"
#include "tests/frontend/format_mutate.hpp"

namespace cobble::frontend::editor {
namespace {

std::vector<std::string> texts_in(const std::string& folder) {
    std::vector<std::string> texts;
    for (const std::string& path : test::files_in(COBBLE_ROOT "/" + folder, ".scene")) {
        texts.push_back(testing::read_marks(test::read_file(path)).text);
    }
    return texts;
}

/// Files that nobody would write, but that editors hold all day.
std::vector<std::string> odd_texts() {
    return {"",
            "\xEF\xBB\xBF",
            "\xEF\xBB\xBF// a\r\n// b\r\nGroup {\r\n    Sphere",
            "{{{}}}}",
            "Group {",
            "Group { MaterialIndex }",
            "Sphere {\n    center 0 0 0\n    ra\n",
            "Materials {\n    Material caf\xC3\xA9 {\n        texture \"\xC3\xA9.png\n    }\n",
            "MaterialIndex MaterialIndex MaterialIndex",
            "Rotate { 0 1 Rotate { Rotate 0 1 0",
            "\"\"\"\"\n\"",
            "//\n//\r//\r\n//",
            "Material Material Material { Material { Noise { color",
            std::string("Group {") + '\0' + " binary",
            "\xFF\xFEG",
            "Materials { Material { texture a`\xFF`b normal caf\xC3\xA9 } }",
            "Group {\n\tSphere { center 1e999 0x3 -inf radius 1.2.3 }\n}"};
}

bool fits(ByteRange range, std::string_view text) {
    return range.begin <= range.end && range.end <= text.size();
}
bool touches(ByteRange range, std::uint32_t offset) {
    return range.begin <= offset && offset <= range.end;
}

std::string why_whole_file_fails(const CheckedScene& scene, std::string_view text) {
    const auto items = outline(scene, text);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const OutlineItem& item = items[i];
        if (!fits(item.span, text) || !fits(item.name_span, text)) return "outline: range";
        if (item.name_span.begin < item.span.begin || item.name_span.end > item.span.end) {
            return "outline: name outside its block";
        }
        if (item.end <= i || item.end > items.size()) return "outline: end";
        if (i + 1 < item.end && items[i + 1].depth <= item.depth) return "outline: depth";
        if (item.end < items.size() && items[item.end].depth > item.depth) return "outline: depth";
        if (i > 0 && item.span.begin < items[i - 1].span.begin) return "outline: order";
        if (item.name.empty()) return "outline: no name";
        if (!source::why_not_text(item.name + item.detail).empty()) return "outline: no text";
    }
    std::uint32_t before = 0;
    for (const Fold& fold : folds(scene, text)) {
        if (!fits(fold.span, text) || fold.span.begin < before) return "folds";
        const auto bytes = text.substr(fold.span.begin, fold.span.end - fold.span.begin);
        if (bytes.find_first_of("\r\n") == std::string_view::npos) return "folds: on one line";
        before = fold.span.begin;
    }
    before = 0;
    for (const SemanticToken& token : semantic_tokens(scene, text)) {
        if (token.length == 0 || token.begin < before) return "tokens: order";
        before = token.begin + token.length;
        if (before > text.size()) return "tokens: range";
        if (text.substr(token.begin, token.length).find_first_of("\r\n") !=
            std::string_view::npos) {
            return "tokens: more than a line";
        }
    }
    before = 0;
    for (const ColorValue& color : colors(scene, text)) {
        if (!fits(color.span, text) || color.span.begin < before) return "colors: range";
        before = color.span.end;
        for (const double component : {color.r, color.g, color.b}) {
            if (!(component >= 0 && component <= 1)) return "colors: component";
        }
    }
    before = 0;
    for (const PathLink& link : links(scene, text)) {
        if (!fits(link.span, text) || link.span.begin < before) return "links: range";
        before = link.span.end;
        if (text.substr(link.span.begin, link.span.end - link.span.begin) != link.path) {
            return "links: text";
        }
    }
    for (const InlayHint& hint : inlay_hints(scene, text)) {
        if (hint.offset > text.size() || hint.text.empty()) return "inlay";
    }
    return {};
}

std::string why_offset_fails(const CheckedScene& scene, std::string_view text, std::uint32_t at) {
    if (const auto found = hover(scene, text, at)) {
        if (!fits(found->span, text) || !touches(found->span, at)) return "hover: range";
        if (found->title.empty() || found->paragraphs.empty()) return "hover: nothing said";
        for (const std::string& paragraph : found->paragraphs) {
            if (paragraph.empty()) return "hover: empty paragraph";
            if (!source::why_not_text(paragraph).empty()) return "hover: no text";
        }
    }
    const auto around = selections(scene, text, at);
    if (around.empty() || around.back() != ByteRange{0, static_cast<std::uint32_t>(text.size())}) {
        return "selections: not up to the file";
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
        if (!fits(around[i], text)) return "selections: range";
        if (at <= text.size() && !touches(around[i], at)) return "selections: offset";
        if (i == 0) continue;
        const ByteRange inner = around[i - 1];
        const ByteRange outer = around[i];
        if (outer.begin > inner.begin || outer.end < inner.end || outer == inner) {
            return "selections: not growing";
        }
    }
    const Completion completion = complete(scene, text, at);
    std::uint32_t rank = 0;
    std::set<std::pair<std::string, CompletionKind>> labels;
    for (const CompletionItem& item : completion.items) {
        if (!fits(item.span, text)) return "completion: range";
        if (at <= text.size() && !touches(item.span, at)) return "completion: offset";
        if (item.rank < rank) return "completion: order";
        rank = item.rank;
        if (item.label.empty() || item.insert.empty()) return "completion: empty";
        if (!labels.insert({item.label, item.kind}).second) return "completion: twice";
    }
    if (!fits(completion.expects_path.span, text)) return "completion: path";
    const Signature help = signature(scene, text, at);
    if (help.found && help.active >= help.parameters.size()) return "signature";
    for (std::size_t i = 0; i < help.parameters.size(); ++i) {
        const ByteRange range = help.parameters[i];
        if (help.label.substr(range.begin, range.end - range.begin) != help.components[i]) {
            return "signature: parameter";
        }
    }
    const auto place = definition(scene, text, at);
    const auto all = references(scene, text, at);
    if (place.has_value() != !all.empty()) return "references: definition";
    if (place && (!touches(place->origin, at) || !fits(place->span, text))) return "definition";
    for (const Reference& reference : all) {
        if (!fits(reference.span, text)) return "references: range";
    }
    const RenameTarget target = rename_target(scene, text, at);
    if (target.refusal.empty() && target.current.empty()) return "rename: no current name";
    const Rename renamed = rename(scene, text, at, "quite_new");
    if (renamed.refusal.empty() == renamed.edits.empty()) return "rename: neither nor";
    std::uint32_t end = 0;
    for (const TextEdit& edit : renamed.edits) {
        if (!fits(edit.span, text) || edit.span.begin < end) return "rename: edits";
        end = edit.span.end;
    }
    return {};
}

std::string changed(std::string text, const std::vector<TextEdit>& edits) {
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        text.replace(edit->span.begin, edit->span.end - edit->span.begin, edit->text);
    }
    return text;
}

/// How often each code is reported, errors and warnings alike.
std::map<std::string_view, int> findings(std::string_view text) {
    std::map<std::string_view, int> counts;
    for (const auto& diagnostic : check(source::SourceId{0}, text).diagnostics) {
        ++counts[diagnostic.code->code];
    }
    return counts;
}

void check_everywhere(const std::string& text) {
    const CheckedScene scene = check(source::SourceId{0}, text);
    const std::string whole = why_whole_file_fails(scene, text);
    CAPTURE(text);
    CHECK(whole == "");
    // Past the end too: an editor may be a change ahead.
    for (std::uint32_t at = 0; at <= text.size() + 2; ++at) {
        const std::string why = why_offset_fails(scene, text, at);
        if (why.empty()) continue;
        CAPTURE(at);
        FAIL_CHECK(why);
        return;
    }
}

TEST_CASE("every offset of every scene can be asked about") {
    const auto scenes = texts_in("scenes");
    REQUIRE(scenes.size() >= 10);
    for (const std::string& text : scenes) check_everywhere(text);
}

TEST_CASE("every offset of broken files can be asked about") {
    for (const std::string& text : odd_texts()) check_everywhere(text);
    for (const char* folder : {"tests/frontend/cases", "tests/frontend/editor/cases"}) {
        for (const std::string& text : texts_in(folder)) {
            // Huge cases are there for other reasons.
            if (text.size() < 5000) check_everywhere(text);
        }
    }
}

TEST_CASE("a file can be asked about while it is typed") {
    for (const std::string& text : texts_in("tests/frontend/editor/cases")) {
        for (std::uint32_t end = 0; end <= text.size(); ++end) {
            const std::string typed = text.substr(0, end);
            const CheckedScene scene = check(source::SourceId{0}, typed);
            CAPTURE(typed);
            REQUIRE(why_whole_file_fails(scene, typed) == "");
            REQUIRE(why_offset_fails(scene, typed, end) == "");
            REQUIRE(why_offset_fails(scene, typed, end / 2) == "");
        }
    }
}

TEST_CASE("damaged scenes can be asked about") {
    const auto texts = texts_in("scenes/basics");
    const int runs = frontend::testing::wanted_runs(1000);
    for (int run = 0; run < runs; ++run) {
        auto random = frontend::testing::random_of(run);
        const std::string text = frontend::testing::damaged(texts, random);
        const CheckedScene scene = check(source::SourceId{0}, text);
        CAPTURE(run);
        CAPTURE(text);
        REQUIRE(why_whole_file_fails(scene, text) == "");
        for (int i = 0; i < 20; ++i) {
            const auto at = static_cast<std::uint32_t>(random.below(text.size() + 1));
            CAPTURE(at);
            REQUIRE(why_offset_fails(scene, text, at) == "");
        }
    }
}

TEST_CASE("renaming leaves every finding as it was") {
    int renamed = 0;
    std::vector<std::string> texts = texts_in("scenes/basics");
    for (const std::string& text : texts_in("tests/frontend/editor/cases")) texts.push_back(text);
    for (const std::string& text : texts) {
        const CheckedScene scene = check(source::SourceId{0}, text);
        const auto before = findings(text);
        for (std::uint32_t i = 0; i < scene.tokens.size(); ++i) {
            const std::uint32_t at = scene.tokens.range({i}).begin;
            const Rename result = rename(scene, text, at, "quite_new");
            if (!result.refusal.empty()) continue;
            ++renamed;
            const std::string after = changed(text, result.edits);
            CAPTURE(after);
            auto now = findings(after);
            // Of two things of one label, one has another now.
            for (const auto& [code, count] : before) {
                if (code == "duplicate-label" && now[code] < count) now[code] = count;
            }
            REQUIRE(now == before);
            // And what meant the thing still does.
            const CheckedScene then = check(source::SourceId{0}, after);
            REQUIRE(then.material_of_block == scene.material_of_block);
        }
    }
    CHECK(renamed >= 50);
}

TEST_CASE("what completion writes may stand there") {
    // What another line of the file must follow up on: its own count, a Motion with the same moves,
    // an object in a fresh Transform, a MaterialIndex before the first object.
    const std::set<std::string_view> follow_up = {
        "wrong-count", "motion-differs",  "transform-without-object",
        "empty-group", "unused-material", "object-before-material"};
    int written = 0;
    for (const std::string& text : texts_in("scenes/basics")) {
        const CheckedScene scene = check(source::SourceId{0}, text);
        auto before = findings(text);
        for (std::uint32_t i = 0; i < scene.tokens.size(); ++i) {
            if (!scene.tokens.first_on_line({i}) && i + 1 < scene.tokens.size()) continue;
            const std::uint32_t at = scene.tokens.range({i}).begin;
            for (const CompletionItem& item : complete(scene, text, at).items) {
                ++written;
                const std::string after = changed(text, {{item.span, item.insert + "\n"}});
                for (const auto& [code, count] : findings(after)) {
                    if (count <= before[code] || follow_up.contains(code)) continue;
                    CAPTURE(item.label);
                    CAPTURE(at);
                    CAPTURE(after);
                    FAIL_CHECK(code);
                    return;
                }
            }
        }
    }
    CHECK(written >= 1000);
}

TEST_CASE("a sample has as many values as its field takes") {
    for (const grammar::FieldRow& field : grammar::fields()) {
        CAPTURE(field.name);
        const std::string values = sample_value(field);
        const auto blanks = std::count(values.begin(), values.end(), ' ');
        CHECK(blanks + 1 == grammar::arity(field.type));
        CHECK(components(field).size() == static_cast<std::size_t>(blanks + 1));
    }
}

TEST_CASE("nesting without end is no danger") {
    constexpr std::uint32_t kLevels = 100'000;
    std::string text;
    for (std::uint32_t i = 0; i < kLevels; ++i) text += "Group{";
    const auto size = static_cast<std::uint32_t>(text.size());
    for (const bool closed : {false, true}) {
        if (closed) text.append(kLevels, '}');
        const CheckedScene scene = check(source::SourceId{0}, text);
        CHECK(why_whole_file_fails(scene, text) == "");
        for (const std::uint32_t at : {0U, size / 2, size - 1, size}) {
            CHECK(why_offset_fails(scene, text, at) == "");
        }
        CHECK(outline(scene, text).size() == kLevels);
        CHECK(complete(scene, text, size).items.size() >= 7);
    }
}

}  // namespace
}  // namespace cobble::frontend::editor
