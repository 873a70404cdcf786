// SPDX-License-Identifier: MIT
#include "tools/lsp/documents/diagnostic_messages.hpp"

#include <utility>

#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/lsp/protocol/uri.hpp"

namespace cobble::lsp {
namespace {

// LSP's DiagnosticSeverity.
int severity_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return 1;
        case source::Severity::kWarning:
            return 2;
        case source::Severity::kInfo:
            break;
    }
    return 3;
}

// DiagnosticTag: what editors show faded.
constexpr int kUnnecessary = 1;

class Writer {
  public:
    Writer(const Workspace& workspace, const Document& document, Analysis& analysis)
        : workspace_(&workspace),
          document_(&document),
          analysis_(&analysis),
          as_lint_has_it_(analysis.sources()) {}

    [[nodiscard]] std::string uri_of(source::SourceId id) const {
        return id == analysis_->source() ? document_->uri()
                                         : uri_of_path(analysis_->sources().path(id));
    }

    [[nodiscard]] Json to_json(const source::Diagnostic& diagnostic) {
        std::string message = diagnostic.message;
        for (const std::string& note : diagnostic.notes) message += '\n' + note;
        Json json = {{"range", range_of(diagnostic.span)},
                     {"severity", severity_of(diagnostic.severity)},
                     {"code", diagnostic.code->code},
                     {"source", "cobble"},
                     {"message", std::move(message)}};
        Json related = Json::array();
        for (const source::Related& other : diagnostic.related) {
            if (!other.span.valid()) continue;
            related.push_back(
                {{"location",
                  {{"uri", uri_of(other.span.source)}, {"range", range_of(other.span)}}},
                 {"message", other.message}});
        }
        if (!related.empty()) json["relatedInformation"] = std::move(related);
        if (diagnostic.code->code.starts_with("unused")) json["tags"] = Json::array({kUnnecessary});
        json["data"] = driver::to_json(diagnostic, as_lint_has_it_);
        return json;
    }

  private:
    [[nodiscard]] Json range_of(source::Span span) {
        if (!span.valid()) return workspace_->positions_of({}).range(0, 0);
        const auto [found, is_new] = positions_.try_emplace(
            span.source.value, analysis_->sources().text(span.source), workspace_->client.encoding);
        return found->second.range(span.begin, span.end);
    }

    const Workspace* workspace_;
    const Document* document_;
    Analysis* analysis_;
    driver::Positions as_lint_has_it_;
    std::map<std::uint32_t, TextPositions> positions_;
};

}  // namespace

std::map<std::string, Json> diagnostics_by_file(Workspace& workspace, Document& document) {
    Analysis& analysis = document.analysis();
    const auto& diagnostics = analysis.diagnostics(workspace.files);
    Writer writer(workspace, document, analysis);
    std::map<std::string, Json> files;
    files[document.uri()] = Json::array();
    for (const source::Diagnostic& diagnostic : diagnostics) {
        const source::SourceId id =
            diagnostic.span.valid() ? diagnostic.span.source : analysis.source();
        files.try_emplace(writer.uri_of(id), Json::array())
            .first->second.push_back(writer.to_json(diagnostic));
    }
    return files;
}

Json workspace_edit(const source::Fix& fix, const Document& document, source::SourceId source,
                    const TextPositions& positions) {
    Json edits = Json::array();
    for (const source::Edit& edit : fix.edits) {
        if (edit.span.source != source) return nullptr;
        edits.push_back(
            {{"range", positions.range(edit.span.begin, edit.span.end)}, {"newText", edit.text}});
    }
    return {{"changes", {{document.uri(), std::move(edits)}}}};
}

}  // namespace cobble::lsp
