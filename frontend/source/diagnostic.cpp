// SPDX-License-Identifier: MIT
#include "frontend/source/diagnostic.hpp"

#include <algorithm>

namespace cobble::source {
namespace {

// Constant-initialised, so that codes of any translation unit may register before main.
constinit const DiagnosticCode* registry_head = nullptr;

}  // namespace

DiagnosticCode::DiagnosticCode(std::string_view code_name, Severity default_severity,
                               std::string_view title_text, std::string_view why_text,
                               std::string_view example_text, std::string_view mend_text)
    : code(code_name),
      severity(default_severity),
      title(title_text),
      why(why_text),
      example(example_text),
      mend(mend_text),
      next(registry_head) {
    registry_head = this;
}

std::vector<const DiagnosticCode*> all_codes() {
    std::vector<const DiagnosticCode*> codes;
    for (const DiagnosticCode* code = registry_head; code != nullptr; code = code->next) {
        codes.push_back(code);
    }
    std::sort(codes.begin(), codes.end(),
              [](const auto* a, const auto* b) { return a->code < b->code; });
    return codes;
}

const DiagnosticCode* find_code(std::string_view name) {
    for (const DiagnosticCode* code = registry_head; code != nullptr; code = code->next) {
        if (code->code == name) return code;
    }
    return nullptr;
}

}  // namespace cobble::source
