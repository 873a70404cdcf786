// SPDX-License-Identifier: MIT
#include "tools/driver/fixes.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

namespace cobble::driver {
namespace {

bool applicable(const source::Fix& fix, source::SourceId scene, bool unsafe) {
    if ((!fix.safe && !unsafe) || fix.edits.empty()) return false;
    return std::all_of(fix.edits.begin(), fix.edits.end(),
                       [scene](const source::Edit& edit) { return edit.span.source == scene; });
}

// How often everything is fixed at once; fixes that make room for others seldom need three turns.
constexpr int kMaxTurns = 20;
// How often fixes are tried one by one, each at the price of a lint, before what is left stays.
constexpr int kMaxSingleTries = 200;

// Two insertions at one place touch as well: their order would be a guess.
bool touch(source::Span a, source::Span b) {
    return (a.begin < b.end && b.begin < a.end) || a.begin == b.begin;
}

std::string apply_edits(std::string_view text, std::vector<const source::Edit*> edits) {
    std::sort(edits.begin(), edits.end(),
              [](const auto* a, const auto* b) { return a->span.begin < b->span.begin; });
    std::string result;
    std::size_t at = 0;
    for (const source::Edit* edit : edits) {
        result += text.substr(at, edit->span.begin - at);
        result += edit->text;
        at = edit->span.end;
    }
    return result += text.substr(at);
}

std::vector<source::Diagnostic> findings(const std::string& path, const std::string& text,
                                         source::FileSource& files, const SeverityRules& rules,
                                         source::SourceId& scene, Session::Fixes fixes) {
    Session session(path, text, fixes);
    scene = session.scene;
    return lint(session, files, rules);
}

// True if there are fewer findings than before, and of no code more: together the fixes helped.
bool better(const std::vector<source::Diagnostic>& before,
            const std::vector<source::Diagnostic>& after) {
    std::map<std::string_view, std::ptrdiff_t> change;
    for (const auto& diagnostic : before) --change[diagnostic.code->code];
    for (const auto& diagnostic : after) ++change[diagnostic.code->code];
    return after.size() < before.size() &&
           std::all_of(change.begin(), change.end(), [](const auto& c) { return c.second <= 0; });
}

}  // namespace

std::string apply_fixes(std::string_view text, source::SourceId scene,
                        const std::vector<source::Diagnostic>& diagnostics, bool unsafe,
                        std::size_t& count) {
    // Edits taken so far, sorted by place and apart from each other.
    std::vector<const source::Edit*> taken;
    const auto before = [](const source::Edit* a, const source::Edit* b) {
        return a->span.begin < b->span.begin;
    };
    for (const source::Diagnostic& diagnostic : diagnostics) {
        const auto fix = std::find_if(
            diagnostic.fixes.begin(), diagnostic.fixes.end(),
            [scene, unsafe](const source::Fix& f) { return applicable(f, scene, unsafe); });
        if (fix == diagnostic.fixes.end()) continue;
        std::vector<const source::Edit*> edits;
        for (const source::Edit& edit : fix->edits) edits.push_back(&edit);
        std::sort(edits.begin(), edits.end(), before);
        bool fits = true;
        for (std::size_t i = 0; i < edits.size(); ++i) {
            if (i > 0 && touch(edits[i - 1]->span, edits[i]->span)) fits = false;
            const auto next = std::lower_bound(taken.begin(), taken.end(), edits[i], before);
            if (next != taken.end() && touch((*next)->span, edits[i]->span)) fits = false;
            if (next != taken.begin() && touch((*(next - 1))->span, edits[i]->span)) fits = false;
        }
        if (!fits) continue;
        const auto middle = static_cast<std::ptrdiff_t>(taken.size());
        taken.insert(taken.end(), edits.begin(), edits.end());
        // Diagnostics come in order, so that this mostly finds everything sorted already.
        if (middle > 0 && !before(taken[static_cast<std::size_t>(middle) - 1], edits.front())) {
            std::inplace_merge(taken.begin(), taken.begin() + middle, taken.end(), before);
        }
        ++count;
    }
    return apply_edits(text, std::move(taken));
}

Fixed fix_until_stable(const std::string& path, std::string text, source::FileSource& files,
                       const SeverityRules& rules, bool unsafe) {
    Fixed result{std::move(text), 0, false};
    source::SourceId scene;
    // All fixes of the file at once, checked together: one lint a turn, however many they are.
    auto diagnostics =
        findings(path, result.text, files, rules, scene, Session::Fixes::kUnverified);
    for (int turn = 0; turn < kMaxTurns; ++turn) {
        std::size_t count = 0;
        std::string changed = apply_fixes(result.text, scene, diagnostics, unsafe, count);
        if (count == 0) break;
        auto remaining = findings(path, changed, files, rules, scene, Session::Fixes::kUnverified);
        if (!better(diagnostics, remaining)) {
            // From here on there may be more than can be counted.
            result.too_many = remaining.size() >= source::kMostFindings;
            break;
        }
        result.text = std::move(changed);
        result.applied += count;
        diagnostics = std::move(remaining);
    }
    if (result.too_many) return result;
    // What is left has fixes that do not go together: only those that help by themselves.
    diagnostics = findings(path, result.text, files, rules, scene, Session::Fixes::kVerified);
    // Each turn lowers the number of findings, or else steps over one of them: so this ends.
    std::size_t first = 0;  // findings before this one have no fix that helps
    bool all_at_once = true;
    int tries = 0;
    while (first < diagnostics.size() && tries < kMaxSingleTries) {
        const std::size_t last = all_at_once ? diagnostics.size() : first + 1;
        const std::vector<source::Diagnostic> batch(
            diagnostics.begin() + static_cast<std::ptrdiff_t>(first),
            diagnostics.begin() + static_cast<std::ptrdiff_t>(last));
        std::size_t count = 0;
        std::string changed = apply_fixes(result.text, scene, batch, unsafe, count);
        if (count == 0) {
            if (all_at_once) break;
            ++first;
            continue;
        }
        if (!all_at_once) ++tries;
        auto remaining = findings(path, changed, files, rules, scene, Session::Fixes::kVerified);
        if (remaining.size() < diagnostics.size()) {
            result.text = std::move(changed);
            result.applied += count;
            diagnostics = std::move(remaining);
            first = 0;
            all_at_once = true;
        } else if (all_at_once) {
            all_at_once = false;
        } else {
            ++first;
        }
    }
    return result;
}

}  // namespace cobble::driver
