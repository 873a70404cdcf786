// SPDX-License-Identifier: MIT
// One record for every finding, whoever reports it: the terminal, JSON, SARIF, a language server.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/span.hpp"

namespace cobble::source {

enum class Severity : unsigned char { kError, kWarning, kInfo };

/// What a diagnostic code is: declared once, beside the code that emits it, with static storage
/// duration. Constructing one adds it to the registry that `all_codes()` walks.
///
/// `code` is kebab-case, never renamed or reused; codes about files begin "asset-". The page of
/// `cobble explain CODE` is made of `title` (one line), `why` (what is wrong about it and what
/// happens otherwise), `example` (a piece of scene text that shows it) and `mend` (what to write).
struct DiagnosticCode {
    DiagnosticCode(std::string_view code, Severity severity, std::string_view title,
                   std::string_view why, std::string_view example, std::string_view mend);
    DiagnosticCode(const DiagnosticCode&) = delete;
    DiagnosticCode& operator=(const DiagnosticCode&) = delete;

    std::string_view code;
    Severity severity;
    std::string_view title;
    std::string_view why;
    std::string_view example;
    std::string_view mend;
    const DiagnosticCode* next;  ///< registry list; order unspecified
};

/// Every code linked into the program, sorted by name.
std::vector<const DiagnosticCode*> all_codes();

/// The code with this name, or null.
const DiagnosticCode* find_code(std::string_view name);

/// How many findings are kept of what may find one at every byte: more serve nobody, and at some
/// 500 bytes each they stay below 5 MB.
inline constexpr std::size_t kMostFindings = 10000;

/// A second place that a finding refers to, in the same file or another.
struct Related {
    Span span;
    std::string message;
};

/// Replace the bytes of `span` by `text`.
struct Edit {
    Span span;
    std::string text;
};

/// A change that removes the finding and adds none. `safe` means that the picture stays the same or
/// becomes what was evidently meant; an unsafe fix says in its title what changes.
struct Fix {
    std::string title;
    bool safe = false;
    std::vector<Edit> edits;
};

/// One finding. `span` is invalid for a finding about no place (a whole file that is missing).
/// Message: lower case, one sentence, no final stop; other places go into notes and related.
struct Diagnostic {
    const DiagnosticCode* code = nullptr;
    Severity severity = Severity::kError;
    std::string message;
    Span span;
    std::vector<std::string> notes;
    std::vector<Related> related;
    std::vector<Fix> fixes;
};

}  // namespace cobble::source
