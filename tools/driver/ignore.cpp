// SPDX-License-Identifier: MIT
#include "tools/driver/ignore.hpp"

#include <algorithm>

namespace cobble::driver {
namespace {

// No path is longer (Linux's PATH_MAX), so that a longer line can only be nonsense.
constexpr std::size_t kMaxPattern = 4096;

struct Set {
    std::size_t length = 0;  // of the pattern; 0 if it is not closed
    bool matches = false;
};

// [a-z], [!a-z] or [^a-z] at the front of `pattern` against one character.
Set match_set(std::string_view pattern, char c) {
    std::size_t i = 1;
    const bool negated = i < pattern.size() && (pattern[i] == '!' || pattern[i] == '^');
    if (negated) ++i;
    bool found = false;
    for (bool first = true; i < pattern.size(); first = false) {
        if (pattern[i] == ']' && !first) return {i + 1, found != negated && c != '/'};
        if (pattern[i] == '\\' && i + 1 < pattern.size()) ++i;
        const char low = pattern[i++];
        char high = low;
        if (i + 1 < pattern.size() && pattern[i] == '-' && pattern[i + 1] != ']') {
            high = pattern[i + 1];
            i += 2;
        }
        found = found || (low <= c && c <= high);
    }
    return {};
}

}  // namespace

bool glob_matches(std::string_view pattern, std::string_view path) {
    if (pattern.size() > kMaxPattern || path.size() > kMaxPattern) return false;
    // reached[i]: what of the pattern was read so far can match the first i characters.
    std::vector<char> reached(path.size() + 1, 0);
    std::vector<char> next(path.size() + 1);
    reached[0] = 1;
    for (std::size_t p = 0; p < pattern.size();) {
        std::fill(next.begin(), next.end(), char{0});
        const std::string_view rest = pattern.substr(p);
        const bool at_segment = p == 0 || pattern[p - 1] == '/';
        if (at_segment && rest.starts_with("**/")) {
            // Nothing, or whole folders.
            bool any = false;
            for (std::size_t i = 0; i <= path.size(); ++i) {
                any = any || reached[i] != 0;
                next[i] = reached[i] != 0 || (any && i > 0 && path[i - 1] == '/') ? 1 : 0;
            }
            p += 3;
        } else if (at_segment && rest == "**") {
            bool any = false;
            for (std::size_t i = 0; i <= path.size(); ++i) {
                any = any || reached[i] != 0;
                next[i] = any ? 1 : 0;
            }
            p += 2;
        } else if (rest[0] == '*') {
            for (std::size_t i = 0; i <= path.size(); ++i) {
                const bool goes_on = i > 0 && next[i - 1] != 0 && path[i - 1] != '/';
                next[i] = reached[i] != 0 || goes_on ? 1 : 0;
            }
            ++p;
        } else {
            std::size_t length = 1;
            const bool escaped = rest[0] == '\\' && rest.size() > 1;
            const bool set = rest[0] == '[' && match_set(rest, 'x').length != 0;
            if (escaped) length = 2;
            if (set) length = match_set(rest, 'x').length;
            for (std::size_t i = 0; i < path.size(); ++i) {
                if (reached[i] == 0) continue;
                bool same = path[i] == rest[escaped ? 1 : 0];
                if (set) same = match_set(rest, path[i]).matches;
                if (rest[0] == '?') same = path[i] != '/';
                next[i + 1] = same ? 1 : 0;
            }
            p += length;
        }
        reached.swap(next);
    }
    return reached[path.size()] != 0;
}

void IgnoreRules::add(std::string_view folder, std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        while (line.ends_with(' ') && !line.ends_with("\\ ")) line.remove_suffix(1);
        if (line.empty() || line.front() == '#' || line.size() > kMaxPattern) continue;
        Rule rule;
        rule.folder = folder;
        rule.negated = line.front() == '!';
        if (rule.negated) line.remove_prefix(1);
        rule.folders_only = line.ends_with('/');
        if (rule.folders_only) line.remove_suffix(1);
        // A slash within binds the pattern to this folder; without one it holds at any depth.
        const bool bound = line.find('/') != std::string_view::npos;
        if (line.starts_with('/')) line.remove_prefix(1);
        if (line.empty()) continue;
        rule.pattern = bound ? std::string(line) : "**/" + std::string(line);
        rules_.push_back(std::move(rule));
    }
}

bool IgnoreRules::ignores(std::string_view path, bool is_folder) const {
    for (auto rule = rules_.rbegin(); rule != rules_.rend(); ++rule) {
        if (rule->folders_only && !is_folder) continue;
        if (!path.starts_with(rule->folder)) continue;
        if (glob_matches(rule->pattern, path.substr(rule->folder.size()))) return !rule->negated;
    }
    return false;
}

}  // namespace cobble::driver
