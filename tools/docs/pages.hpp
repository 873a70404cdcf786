// SPDX-License-Identifier: MIT
// The generated pages: each a path from the repository's root and its text. Input: the grammars,
// the vocabulary, the registry of diagnostics, and one example scene a block. Invariant: the same
// on every machine and compiler.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/vocabulary.hpp"
#include "tools/docs/expression.hpp"

namespace cobble::docs {

struct Page {
    std::string path;
    std::string text;
};

/// The text of tools/docs/examples/NAME.scene, or nothing.
using ExampleSource = std::function<std::optional<std::string>(std::string_view name)>;

/// The blocks as rules: what may stand where, from the vocabulary.
Grammar block_grammar();

/// The part of an example between `// example` and `// end`, without its indentation; the whole
/// text if it has no such lines.
std::string shown_part(std::string_view example);

Page language_page(const ExampleSource& examples);
Page diagnostics_page();
/// grammar/grammar.ebnf.md and the pictures under grammar/railroad.
std::vector<Page> grammar_pages();

/// All of the above.
std::vector<Page> all_pages(const ExampleSource& examples);

}  // namespace cobble::docs
