// SPDX-License-Identifier: MIT
// `--format sarif`: the Static Analysis Results Interchange Format, version 2.1.0 (OASIS, 2020).
#include <fmt/core.h>

#include <map>
#include <string>
#include <utility>

#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/formats.hpp"

namespace cobble::driver {
namespace {

std::string_view level_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return "error";
        case source::Severity::kWarning:
            return "warning";
        case source::Severity::kInfo:
            return "note";
    }
    return "none";
}

// A path as a URI reference (RFC 3986): all but unreserved characters and '/' is %-encoded.
std::string uri(std::string_view path) {
    constexpr std::string_view kPlain = "-._~/";
    std::string result = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        const bool alphanumeric =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (alphanumeric || kPlain.find(c) != std::string_view::npos) {
            result += c;
        } else {
            result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return result;
}

class SarifReporter : public Reporter {
  public:
    explicit SarifReporter(Sink sink) : sink_(std::move(sink)) {}

    void file(const FileReport& report) override {
        Positions positions(*report.sources);
        for (const source::Diagnostic& diagnostic : report.diagnostics) {
            results_.push_back(result(diagnostic, report, positions));
        }
    }

    void finish(const Summary& /*summary*/) override {
        const Json driver = {
            {"name", "cobble"}, {"version", COBBLE_VERSION}, {"rules", std::move(rules_)}};
        const Json run = {{"tool", {{"driver", driver}}},
                          {"columnKind", "unicodeCodePoints"},
                          {"results", std::move(results_)}};
        const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                          {"version", "2.1.0"},
                          {"runs", Json::array({run})}};
        sink_(pretty(log));
    }

  private:
    std::size_t rule(const source::DiagnosticCode& code) {
        const auto [found, is_new] = rule_index_.try_emplace(&code, rules_.size());
        if (is_new) {
            rules_.push_back({{"id", code.code},
                              {"shortDescription", {{"text", code.title}}},
                              {"fullDescription", {{"text", code.why}}},
                              {"help", {{"text", code.mend}}},
                              {"defaultConfiguration", {{"level", level_of(code.severity)}}}});
        }
        return found->second;
    }

    static Json region(source::Span span, Positions& positions) {
        const auto start = positions.start(span);
        const auto end = positions.end(span);
        return {{"startLine", start.line},  {"startColumn", start.column},
                {"endLine", end.line},      {"endColumn", end.column},
                {"byteOffset", span.begin}, {"byteLength", span.end - span.begin}};
    }

    static Json location(std::string_view path, source::Span span, Positions& positions) {
        Json physical = {{"artifactLocation", {{"uri", uri(path)}}}};
        if (span.valid()) physical["region"] = region(span, positions);
        return {{"physicalLocation", std::move(physical)}};
    }

    static Json fix(const source::Fix& fix, Positions& positions) {
        std::map<std::string, Json> changes;
        for (const source::Edit& edit : fix.edits) {
            Json& replacements =
                changes.try_emplace(std::string(positions.path(edit.span)), Json::array())
                    .first->second;
            replacements.push_back({{"deletedRegion", region(edit.span, positions)},
                                    {"insertedContent", {{"text", edit.text}}}});
        }
        Json artifacts = Json::array();
        for (auto& [path, replacements] : changes) {
            artifacts.push_back({{"artifactLocation", {{"uri", uri(path)}}},
                                 {"replacements", std::move(replacements)}});
        }
        return {{"description", {{"text", fix.title}}}, {"artifactChanges", std::move(artifacts)}};
    }

    Json result(const source::Diagnostic& diagnostic, const FileReport& report,
                Positions& positions) {
        const source::Span span = diagnostic.span;
        const std::string_view path =
            report.sources->path(span.valid() ? span.source : report.scene);
        std::string message = diagnostic.message;
        for (const std::string& note : diagnostic.notes) message += "\n" + note;
        Json entry = {{"ruleId", diagnostic.code->code},
                      {"ruleIndex", rule(*diagnostic.code)},
                      {"level", level_of(diagnostic.severity)},
                      {"message", {{"text", std::move(message)}}},
                      {"locations", Json::array({location(path, span, positions)})}};
        Json related = Json::array();
        for (const source::Related& place : diagnostic.related) {
            if (!place.span.valid()) continue;
            Json at = location(positions.path(place.span), place.span, positions);
            at["message"] = {{"text", place.message}};
            related.push_back(std::move(at));
        }
        if (!related.empty()) entry["relatedLocations"] = std::move(related);
        Json fixes = Json::array();
        for (const source::Fix& one : diagnostic.fixes) fixes.push_back(fix(one, positions));
        if (!fixes.empty()) entry["fixes"] = std::move(fixes);
        return entry;
    }

    Sink sink_;
    Json rules_ = Json::array();
    Json results_ = Json::array();
    std::map<const source::DiagnosticCode*, std::size_t> rule_index_;
};

}  // namespace

std::unique_ptr<Reporter> make_sarif_reporter(Sink sink) {
    return std::make_unique<SarifReporter>(std::move(sink));
}

}  // namespace cobble::driver
