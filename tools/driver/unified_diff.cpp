// SPDX-License-Identifier: MIT
// Lines that occur once in both texts anchor the comparison (the patience idea: the longest chain
// of them in increasing order); Myers' greedy algorithm (An O(ND) Difference Algorithm, 1986) fills
// the gaps between them.
#include "tools/driver/unified_diff.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cobble::driver {
namespace {

using Lines = std::vector<std::string_view>;

// Myers' algorithm keeps its search in memory: 400 differences are 160,000 numbers.
constexpr int kMaxDifferences = 400;

Lines split(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

// A stretch of each text: lines [a0, a1) against [b0, b1).
struct Gap {
    std::size_t a0, a1, b0, b1;
};

// Which lines are common: partner[i] is the line of the second text that line i of the first is
// equal to, or kNone.
constexpr std::size_t kNone = ~std::size_t{0};

class Matcher {
  public:
    Matcher(const Lines& a, const Lines& b) : a_(a), b_(b), partner_(a.size(), kNone) {}

    std::vector<std::size_t> run() {
        Gap all{0, a_.size(), 0, b_.size()};
        trim(all);
        std::size_t a = all.a0;
        std::size_t b = all.b0;
        for (const auto& [at_a, at_b] : anchors(all)) {
            fill({a, at_a, b, at_b});
            partner_[at_a] = at_b;
            a = at_a + 1;
            b = at_b + 1;
        }
        fill({a, all.a1, b, all.b1});
        return std::move(partner_);
    }

  private:
    using Pair = std::pair<std::size_t, std::size_t>;

    void trim(Gap& gap) {
        while (gap.a0 < gap.a1 && gap.b0 < gap.b1 && a_[gap.a0] == b_[gap.b0]) {
            partner_[gap.a0++] = gap.b0++;
        }
        while (gap.a0 < gap.a1 && gap.b0 < gap.b1 && a_[gap.a1 - 1] == b_[gap.b1 - 1]) {
            partner_[--gap.a1] = --gap.b1;
        }
    }

    // Lines that occur once on either side, thinned to the longest chain that goes forward.
    std::vector<Pair> anchors(const Gap& gap) const {
        struct Count {
            std::size_t in_a = 0, in_b = 0, at_b = 0;
        };
        std::unordered_map<std::string_view, Count> counts;
        for (std::size_t i = gap.a0; i < gap.a1; ++i) ++counts[a_[i]].in_a;
        for (std::size_t i = gap.b0; i < gap.b1; ++i) {
            Count& count = counts[b_[i]];
            ++count.in_b;
            count.at_b = i;
        }
        std::vector<Pair> unique;
        for (std::size_t i = gap.a0; i < gap.a1; ++i) {
            const Count& count = counts[a_[i]];
            if (count.in_a == 1 && count.in_b == 1) unique.emplace_back(i, count.at_b);
        }
        // piles[k]: the chain of length k + 1 whose end in the second text is smallest.
        std::vector<std::size_t> piles;
        std::vector<std::size_t> previous(unique.size(), kNone);
        for (std::size_t i = 0; i < unique.size(); ++i) {
            const auto pile = std::lower_bound(
                piles.begin(), piles.end(), unique[i].second,
                [&unique](std::size_t p, std::size_t at) { return unique[p].second < at; });
            if (pile != piles.begin()) previous[i] = *(pile - 1);
            if (pile == piles.end()) {
                piles.push_back(i);
            } else {
                *pile = i;
            }
        }
        std::vector<Pair> chain;
        for (std::size_t i = piles.empty() ? kNone : piles.back(); i != kNone; i = previous[i]) {
            chain.push_back(unique[i]);
        }
        std::reverse(chain.begin(), chain.end());
        return chain;
    }

    void fill(Gap gap) {
        trim(gap);
        const auto n = static_cast<std::ptrdiff_t>(gap.a1 - gap.a0);
        const auto m = static_cast<std::ptrdiff_t>(gap.b1 - gap.b0);
        if (n == 0 || m == 0) return;
        // furthest[d][k + d]: how far diagonal k (x - y) reaches with d differences.
        std::vector<std::vector<std::ptrdiff_t>> furthest;
        for (std::ptrdiff_t d = 0; d <= std::min<std::ptrdiff_t>(n + m, kMaxDifferences); ++d) {
            furthest.emplace_back(static_cast<std::size_t>(2 * d + 1), -1);
            for (std::ptrdiff_t k = -d; k <= d; k += 2) {
                std::ptrdiff_t x =
                    d == 0 ? 0 : step(furthest[static_cast<std::size_t>(d) - 1], d, k);
                std::ptrdiff_t y = x - k;
                if (x < 0 || y < 0 || x > n || y > m) continue;
                while (x < n && y < m && same(gap, x, y)) {
                    ++x;
                    ++y;
                }
                furthest[static_cast<std::size_t>(d)][static_cast<std::size_t>(k + d)] = x;
                if (x == n && y == m) {
                    trace(gap, furthest, d, k);
                    return;
                }
            }
        }
    }

    [[nodiscard]] bool same(const Gap& gap, std::ptrdiff_t x, std::ptrdiff_t y) const {
        return a_[gap.a0 + static_cast<std::size_t>(x)] == b_[gap.b0 + static_cast<std::size_t>(y)];
    }

    static std::ptrdiff_t at(const std::vector<std::ptrdiff_t>& row, std::ptrdiff_t d,
                             std::ptrdiff_t k) {
        return k < -d || k > d ? -1 : row[static_cast<std::size_t>(k + d)];
    }

    // Where diagonal k starts with its d-th difference: a line removed (from k - 1) or added.
    static std::ptrdiff_t step(const std::vector<std::ptrdiff_t>& before, std::ptrdiff_t d,
                               std::ptrdiff_t k) {
        const std::ptrdiff_t removed = at(before, d - 1, k - 1);
        const std::ptrdiff_t added = at(before, d - 1, k + 1);
        return std::max(removed < 0 ? -1 : removed + 1, added);
    }

    void trace(const Gap& gap, const std::vector<std::vector<std::ptrdiff_t>>& furthest,
               std::ptrdiff_t d, std::ptrdiff_t k) {
        for (; d >= 0; --d) {
            std::ptrdiff_t x = at(furthest[static_cast<std::size_t>(d)], d, k);
            const auto* before = d == 0 ? nullptr : &furthest[static_cast<std::size_t>(d) - 1];
            const std::ptrdiff_t start = before == nullptr ? 0 : step(*before, d, k);
            for (; x > start; --x) {
                partner_[gap.a0 + static_cast<std::size_t>(x - 1)] =
                    gap.b0 + static_cast<std::size_t>(x - 1 - k);
            }
            if (before == nullptr) break;
            const std::ptrdiff_t removed = at(*before, d - 1, k - 1);
            k += removed >= 0 && removed + 1 == start ? -1 : 1;
        }
    }

    const Lines& a_;
    const Lines& b_;
    std::vector<std::size_t> partner_;
};

enum class Kind : char { kSame = ' ', kRemoved = '-', kAdded = '+' };

struct Step {
    Kind kind;
    std::string_view line;
};

std::vector<Step> script(const Lines& a, const Lines& b) {
    const std::vector<std::size_t> partner = Matcher(a, b).run();
    std::vector<Step> steps;
    std::size_t next_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (partner[i] == kNone) {
            steps.push_back({Kind::kRemoved, a[i]});
            continue;
        }
        while (next_b < partner[i]) steps.push_back({Kind::kAdded, b[next_b++]});
        steps.push_back({Kind::kSame, a[i]});
        ++next_b;
    }
    while (next_b < b.size()) steps.push_back({Kind::kAdded, b[next_b++]});
    return steps;
}

std::string paint(const DiffStyle& style, std::string_view code, std::string_view line) {
    if (!style.color) return std::string(line);
    const bool ended = line.ends_with('\n');
    if (ended) line.remove_suffix(1);
    return fmt::format("\x1b[{}m{}\x1b[0m{}", code, line, ended ? "\n" : "");
}

// "12,7", "12" for one line, "11,0" for none after line 11.
std::string range(std::size_t first, std::size_t count) {
    if (count == 1) return std::to_string(first + 1);
    return fmt::format("{},{}", count == 0 ? first : first + 1, count);
}

// A name as `patch` and `git apply` read it: in quotes, as in C, if it holds control characters,
// quotes or backslashes; with a tab behind it if blanks would end it.
std::string file_name(std::string_view name) {
    std::string escaped;
    for (const char c : name) {
        if (c == '"' || c == '\\') {
            escaped += '\\';
            escaped += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            escaped += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
        } else {
            escaped += c;
        }
    }
    if (escaped != name) return '"' + escaped + '"';
    return escaped.find(' ') == std::string::npos ? escaped : escaped + '\t';
}

}  // namespace

std::string unified_diff(std::string_view before, std::string_view after,
                         std::string_view before_name, std::string_view after_name,
                         const DiffStyle& style) {
    if (before == after) return {};
    const std::vector<Step> steps = script(split(before), split(after));
    std::string text = paint(style, "1", fmt::format("--- {}\n", file_name(before_name))) +
                       paint(style, "1", fmt::format("+++ {}\n", file_name(after_name)));
    std::size_t line_a = 0;
    std::size_t line_b = 0;
    for (std::size_t i = 0; i < steps.size();) {
        std::size_t change = i;
        while (change < steps.size() && steps[change].kind == Kind::kSame) ++change;
        if (change == steps.size()) break;
        const std::size_t begin = change - std::min<std::size_t>(change - i, style.context);
        line_a += begin - i;
        line_b += begin - i;
        // The hunk goes on while the next change is near enough to share its context.
        std::size_t end = change;
        for (std::size_t same = 0; end < steps.size() && same <= 2 * std::size_t{style.context};
             ++end) {
            same = steps[end].kind == Kind::kSame ? same + 1 : 0;
        }
        while (end > change && steps[end - 1].kind == Kind::kSame) --end;
        for (unsigned k = 0; k < style.context && end < steps.size(); ++k) ++end;
        std::string body;
        std::size_t count_a = 0;
        std::size_t count_b = 0;
        for (std::size_t k = begin; k < end; ++k) {
            count_a += steps[k].kind != Kind::kAdded ? 1 : 0;
            count_b += steps[k].kind != Kind::kRemoved ? 1 : 0;
            std::string line(1, static_cast<char>(steps[k].kind));
            line += steps[k].line;
            const bool ended = line.ends_with('\n');
            if (steps[k].kind == Kind::kSame) {
                body += line;
            } else {
                body += paint(style, steps[k].kind == Kind::kRemoved ? "31" : "32", line);
            }
            if (!ended) body += "\n\\ No newline at end of file\n";
        }
        text +=
            paint(style, "36",
                  fmt::format("@@ -{} +{} @@\n", range(line_a, count_a), range(line_b, count_b)));
        text += body;
        line_a += count_a;
        line_b += count_b;
        i = end;
    }
    return text;
}

}  // namespace cobble::driver
