// SPDX-License-Identifier: MIT
#include "frontend/ast/reporter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/source/utf8.hpp"

namespace cobble::frontend {
namespace {

using source::Diagnostic;
using source::DiagnosticCode;
using source::Severity;

const DiagnosticCode kTooManyErrors(
    "too-many-errors", Severity::kError, "the file has more errors than are kept",
    "Only the first 10000 syntax errors of a file are kept. So many seldom mean a scene with "
    "mistakes: the file is probably no scene at all, or it was damaged.",
    "(a picture that was renamed to scene.txt)",
    "Check that this is the file you meant. If it is, mend the first errors and try again: most of "
    "the others may follow from them.");

// Enough to recognise a word by, and no more than a terminal's line.
constexpr std::size_t kQuotedBytes = 60;

}  // namespace

Diagnostic& Reporter::add(const DiagnosticCode& code, ByteRange bytes, std::string message) {
    Diagnostic diagnostic;
    diagnostic.code = &code;
    diagnostic.severity = code.severity;
    diagnostic.message = std::move(message);
    diagnostic.span = span(bytes);
    if (diagnostics_.size() < source::kMostFindings) {
        diagnostics_.push_back(std::move(diagnostic));
        return diagnostics_.back();
    }
    ++dropped_;
    overflow_ = std::move(diagnostic);
    return overflow_;
}

std::vector<Diagnostic> Reporter::take() {
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                     [](const auto& a, const auto& b) { return a.span.begin < b.span.begin; });
    if (dropped_ > 0) {
        Diagnostic last;
        last.code = &kTooManyErrors;
        last.severity = kTooManyErrors.severity;
        last.message = fmt::format("{} more errors are not shown", dropped_);
        last.span = diagnostics_.back().span;
        diagnostics_.push_back(std::move(last));
    }
    return std::move(diagnostics_);
}

std::string quoted(std::string_view text) {
    std::string result = "'";
    std::size_t at = 0;
    while (at < text.size() && at < kQuotedBytes) {
        const std::size_t length = source::utf8_length(text.substr(at));
        const auto byte = static_cast<unsigned char>(text[at]);
        if (length == 0 || byte < 0x20 || byte == 0x7f) {
            result += "\xEF\xBF\xBD";
            ++at;
        } else {
            result += text.substr(at, length);
            at += length;
        }
    }
    result += at < text.size() ? "...'" : "'";
    return result;
}

}  // namespace cobble::frontend
