// SPDX-License-Identifier: MIT
// Collects the binder's findings: makes spans, and stops a hopeless file from filling the memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/lex/tokens.hpp"
#include "frontend/source/diagnostic.hpp"

namespace cobble::frontend {

class Reporter {
  public:
    Reporter(source::SourceId source, const Tokens& tokens) : source_(source), tokens_(tokens) {}

    /// A finding about a range of bytes, to which notes and fixes can be added. After
    /// source::kMostFindings the rest is counted, not kept: a binary file would otherwise give one
    /// a byte, some 300 times its size.
    source::Diagnostic& add(const source::DiagnosticCode& code, ByteRange bytes,
                            std::string message);
    source::Diagnostic& add(const source::DiagnosticCode& code, TokenId token,
                            std::string message) {
        return add(code, tokens_.range(token), std::move(message));
    }

    [[nodiscard]] source::Span span(ByteRange bytes) const {
        return {source_, bytes.begin, bytes.end};
    }
    [[nodiscard]] source::Span span(TokenId token) const { return span(tokens_.range(token)); }
    /// From the beginning of one token to the end of another.
    [[nodiscard]] source::Span span(TokenId first, TokenId last) const {
        return span(ByteRange{tokens_.tokens[first.value].begin, tokens_.range(last).end});
    }
    [[nodiscard]] const Tokens& tokens() const { return tokens_; }
    [[nodiscard]] std::string_view text(TokenId token) const { return tokens_.text_of(token); }

    /// All findings in the order of their places.
    std::vector<source::Diagnostic> take();

  private:
    source::SourceId source_;
    const Tokens& tokens_;
    std::vector<source::Diagnostic> diagnostics_;
    source::Diagnostic overflow_;  ///< where findings go that are not kept
    std::size_t dropped_ = 0;
};

/// A token as messages quote it: cut short if it is long, with what cannot be shown replaced by
/// U+FFFD.
std::string quoted(std::string_view text);

}  // namespace cobble::frontend
