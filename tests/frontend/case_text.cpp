// SPDX-License-Identifier: MIT
#include "tests/frontend/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "frontend/source/line_index.hpp"

namespace cobble::test {
namespace {

std::string_view name_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return "error";
        case source::Severity::kWarning:
            return "warning";
        case source::Severity::kInfo:
            break;
    }
    return "info";
}

std::string place(const source::LineIndex& lines, source::Span span) {
    if (!span.valid()) return "-";
    const auto begin = lines.locate(span.begin);
    const auto end = lines.locate(span.end);
    if (begin.line == end.line) {
        return fmt::format("{}:{}-{}", begin.line, begin.column, end.column);
    }
    return fmt::format("{}:{}-{}:{}", begin.line, begin.column, end.line, end.column);
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\n') {
            result += "\\n";
        } else if (c == '\r') {
            result += "\\r";
        } else if (c == '\t') {
            result += "\\t";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace

std::string describe(std::string_view text, const std::vector<source::Diagnostic>& diagnostics) {
    const source::LineIndex lines(text);
    std::string result;
    for (const source::Diagnostic& diagnostic : diagnostics) {
        result +=
            fmt::format("{} {} {}: {}\n", place(lines, diagnostic.span),
                        name_of(diagnostic.severity), diagnostic.code->code, diagnostic.message);
        for (const auto& note : diagnostic.notes) result += fmt::format("    note: {}\n", note);
        for (const auto& related : diagnostic.related) {
            result += fmt::format("    {}: {}\n", place(lines, related.span), related.message);
        }
        for (const auto& fix : diagnostic.fixes) {
            result += fmt::format("    {} fix: {}\n", fix.safe ? "safe" : "unsafe", fix.title);
            for (const auto& edit : fix.edits) {
                result += fmt::format("        {} -> \"{}\"\n", place(lines, edit.span),
                                      escaped(edit.text));
            }
        }
    }
    return result.empty() ? "nothing\n" : result;
}

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

std::vector<std::string> files_in(const std::string& folder, std::string_view ending) {
    std::vector<std::string> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        if (entry.is_regular_file() && entry.path().extension() == ending) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace cobble::test
