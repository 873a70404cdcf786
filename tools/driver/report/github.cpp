// SPDX-License-Identifier: MIT
// `--format github`: workflow commands that become annotations of a pull request.
#include <fmt/core.h>

#include <string>
#include <utility>

#include "tools/driver/report/formats.hpp"
#include "tools/driver/report/positions.hpp"

namespace cobble::driver {
namespace {

// "%" first of all, then what would end the line; in properties also what would end the value.
std::string escaped(std::string_view text, bool property) {
    std::string result;
    for (const char c : text) {
        const bool special =
            c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','));
        if (special) {
            result += fmt::format("%{:02X}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result;
}

std::string_view command_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return "error";
        case source::Severity::kWarning:
            return "warning";
        case source::Severity::kInfo:
            return "notice";
    }
    return "notice";
}

class GithubReporter : public Reporter {
  public:
    explicit GithubReporter(Sink sink) : sink_(std::move(sink)) {}

    void file(const FileReport& report) override {
        Positions positions(*report.sources);
        for (const source::Diagnostic& diagnostic : report.diagnostics) {
            const bool placed = diagnostic.span.valid();
            const std::string_view path =
                report.sources->path(placed ? diagnostic.span.source : report.scene);
            std::string line =
                fmt::format("::{} file={}", command_of(diagnostic.severity), escaped(path, true));
            if (placed) {
                const auto start = positions.start(diagnostic.span);
                const auto end = positions.end(diagnostic.span);
                line += fmt::format(",line={},endLine={}", start.line, end.line);
                // Columns are taken within one line only.
                if (start.line == end.line) {
                    line += fmt::format(",col={},endColumn={}", start.column, end.column);
                }
            }
            std::string message = diagnostic.message;
            for (const std::string& note : diagnostic.notes) message += "\n" + note;
            sink_(fmt::format("{},title={}::{}\n", line, escaped(diagnostic.code->code, true),
                              escaped(message, false)));
        }
    }

    void finish(const Summary& /*summary*/) override {}

  private:
    Sink sink_;
};

}  // namespace

std::unique_ptr<Reporter> make_github_reporter(Sink sink) {
    return std::make_unique<GithubReporter>(std::move(sink));
}

}  // namespace cobble::driver
