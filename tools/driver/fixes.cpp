// SPDX-License-Identifier: MIT
#include "tools/driver/fixes.hpp"

#include <algorithm>
#include <utility>

namespace cobble::driver {
namespace {

bool applicable(const source::Fix& fix, source::SourceId scene, bool unsafe) {
    if ((!fix.safe && !unsafe) || fix.edits.empty()) return false;
    return std::all_of(fix.edits.begin(), fix.edits.end(),
                       [scene](const source::Edit& edit) { return edit.span.source == scene; });
}

// How often fixes are tried one by one, each at the price of a lint, before what is left stays.
constexpr int kMaxSingleTries = 1000;

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
                                         source::SourceId& scene) {
    Session session(path, text);
    scene = session.scene;
    return lint(session, files, rules);
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
    Fixed result{std::move(text), 0};
    source::SourceId scene;
    auto diagnostics = findings(path, result.text, files, rules, scene);
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
        auto remaining = findings(path, changed, files, rules, scene);
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
