// SPDX-License-Identifier: MIT
#include "frontend/format/format.hpp"

#include <algorithm>
#include <limits>

#include "frontend/format/layout.hpp"
#include "frontend/format/proof.hpp"
#include "frontend/format/writer.hpp"
#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"

namespace cobble::frontend {
namespace {

constexpr std::uint64_t kMaxBytes = std::numeric_limits<std::uint32_t>::max() - 1;

struct Flaw {
    std::string what;  ///< empty: none
    /// True if the tree alone is at fault: with errors in the file, white space may decide which
    /// brace is taken to be missing.
    bool in_tree = false;
};

/// Why `result` is not the text of `tokens` with other white space, or not the last word on it.
Flaw find_flaw(const Tokens& tokens, const Cst& cst, const Layout& layout,
               const WriteOptions& written, std::int64_t lines_added, std::string_view result) {
    if (result.size() > kMaxBytes) return {"the result is 4 GiB or larger"};
    const Tokens again = lex(result);
    if (std::string what = token_difference(tokens, again); !what.empty()) return {what};
    const Cst tree = parse(again);
    if (std::string what = tree_difference(cst, tree); !what.empty()) return {what, true};
    WriteOptions options = written;
    if (options.last_line != UINT32_MAX) {
        const std::int64_t last = std::int64_t{options.last_line} + lines_added;
        if (last < options.first_line) return {};
        options.last_line = static_cast<std::uint32_t>(last);
    }
    // A formatted text has the layout of its source: it need not be made again.
    if (!compare(again, layout, options, result).as_expected) {
        return {"formatting the result again changes it", true};
    }
    return {};
}

}  // namespace

FormatResult format(std::string_view text, const FormatOptions& options) {
    FormatResult result;
    if (text.size() > kMaxBytes) {
        result.text = text;
        result.refused = true;
        result.refusal = "the file is 4 GiB or larger";
        return result;
    }
    WriteOptions lines;
    if (options.first_line != 0 || options.last_line != 0) {
        lines = {std::max(options.first_line, 1U), options.last_line};
    }
    const Tokens tokens = lex(text);
    const Cst cst = parse(tokens);
    const Layout layout = lay_out(tokens, cst);
    result.has_errors = layout.has_errors;
    const WriteResult written = write(tokens, layout, lines, result.text);
    Flaw flaw = find_flaw(tokens, cst, layout, lines, written.lines_added, result.text);
    if (flaw.what.empty()) return result;
    result.text = text;
    if (result.has_errors && flaw.in_tree) {
        result.left_alone = true;
    } else {
        result.refused = true;
        result.refusal = std::move(flaw.what);
    }
    return result;
}

}  // namespace cobble::frontend
