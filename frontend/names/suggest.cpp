// SPDX-License-Identifier: MIT
#include "frontend/names/suggest.hpp"

#include <algorithm>
#include <array>

namespace cobble::frontend {
namespace {

// Longer words are paths or junk, and the tables below are fixed arrays.
constexpr std::size_t kLongestWord = 64;
constexpr std::size_t kMostEdits = 3;

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
constexpr bool is_joint(char c) { return c == '_' || c == '-'; }

/// Equal but for case and joints.
bool same_letters(std::string_view a, std::string_view b) {
    std::size_t i = 0;
    std::size_t j = 0;
    for (;;) {
        while (i < a.size() && is_joint(a[i])) ++i;
        while (j < b.size() && is_joint(b[j])) ++j;
        if (i == a.size() || j == b.size()) return i == a.size() && j == b.size();
        if (lower(a[i++]) != lower(b[j++])) return false;
    }
}

/// A word in lower case.
class Folded {
  public:
    explicit Folded(std::string_view word) : size_(word.size()) {
        std::ranges::transform(word, text_.begin(), lower);
    }
    [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }

  private:
    std::array<char, kLongestWord> text_;
    std::size_t size_;
};

struct Near {
    std::size_t distance;
    std::string_view name;
};

}  // namespace

std::size_t edit_distance(std::string_view from, std::string_view to, std::size_t limit) {
    const std::size_t far = limit + 1;
    if (from.size() > to.size()) std::swap(from, to);
    if (to.size() > kLongestWord || to.size() - from.size() > limit) return far;

    // Three rows of the usual table, since a swap looks two rows back; only the band of `limit`
    // around the diagonal can hold an answer.
    std::array<std::array<std::size_t, kLongestWord + 1>, 3> rows;
    for (auto& row : rows) row.fill(far);
    for (std::size_t j = 0; j <= std::min(limit, to.size()); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        auto& row = rows[i % 3];
        const auto& above = rows[(i - 1) % 3];
        const auto& above2 = rows[(i + 1) % 3];
        const std::size_t first = i > limit ? i - limit : 0;
        const std::size_t last = std::min(to.size(), i + limit);
        if (first > 0) row[first - 1] = far;
        std::size_t best = far;
        for (std::size_t j = first; j <= last; ++j) {
            std::size_t cost = j == 0 ? i : far;
            if (j > 0) {
                cost = std::min(above[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1), row[j - 1] + 1);
            }
            cost = std::min(cost, above[j] + 1);
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
                cost = std::min(cost, above2[j - 2] + 1);
            }
            row[j] = std::min(cost, far);
            best = std::min(best, row[j]);
        }
        if (last < to.size()) row[last + 1] = far;
        // A swap reaches back over one row, but along the diagonal, where this row would be within
        // the limit as well.
        if (best == far) return far;
    }
    return std::min(rows[from.size() % 3][to.size()], far);
}

std::vector<std::string_view> near_names(std::string_view word,
                                         std::span<const std::string_view> candidates,
                                         std::size_t limit) {
    if (word.size() > kLongestWord) return {};
    const Folded folded_word(word);
    std::vector<Near> found;
    for (const std::string_view name : candidates) {
        if (name == word) continue;
        if (name.size() > kLongestWord) continue;
        const std::size_t shorter = std::min(word.size(), name.size());
        const std::size_t allowed =
            shorter < 3 ? 0 : std::clamp(shorter / 3, std::size_t{1}, kMostEdits);
        std::size_t distance = 0;
        if (!same_letters(word, name)) {
            if (allowed == 0) continue;
            distance = edit_distance(folded_word.view(), Folded(name).view(), allowed);
            if (distance > allowed) continue;
        }
        const auto is_it = [name](const Near& near) { return near.name == name; };
        if (std::ranges::none_of(found, is_it)) found.push_back({distance, name});
    }
    std::ranges::stable_sort(found, {}, &Near::distance);
    if (found.size() > limit) found.resize(limit);
    std::vector<std::string_view> names;
    names.reserve(found.size());
    for (const Near& near : found) names.push_back(near.name);
    return names;
}

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates) {
    const auto names = near_names(word, candidates, 1);
    return names.empty() ? std::string_view{} : names.front();
}

}  // namespace cobble::frontend
