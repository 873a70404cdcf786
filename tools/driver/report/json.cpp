// SPDX-License-Identifier: MIT
// `--format json` (one document) and `--format jsonl` (one diagnostic a line).
#include <fmt/core.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/formats.hpp"

namespace cobble::driver {
namespace {

// Fields are only ever added within one version.
constexpr int kVersion = 1;

std::string_view path_of(const source::Diagnostic& diagnostic, const FileReport& report) {
    return report.sources->path(diagnostic.span.valid() ? diagnostic.span.source : report.scene);
}

Json summary_to_json(const Summary& summary) {
    return {{"files", summary.files}, {"errors", summary.errors}, {"warnings", summary.warnings}};
}

// Holds everything until the end: findings in one mesh that several scenes use belong together.
class JsonReporter : public Reporter {
  public:
    explicit JsonReporter(Sink sink) : sink_(std::move(sink)) {}

    void file(const FileReport& report) override {
        Positions positions(*report.sources);
        entry(report.sources->path(report.scene));
        for (const source::Diagnostic& diagnostic : report.diagnostics) {
            files_[entry(path_of(diagnostic, report))].diagnostics.push_back(
                dump(to_json(diagnostic, positions)));
        }
    }

    void finish(const Summary& summary) override {
        sink_(fmt::format("{{\"version\": {},\n \"files\": [", kVersion));
        for (std::size_t i = 0; i < files_.size(); ++i) {
            sink_(fmt::format("{}\n  {{\"path\": {}, \"diagnostics\": [", i == 0 ? "" : ",",
                              dump(Json(files_[i].path))));
            for (std::size_t k = 0; k < files_[i].diagnostics.size(); ++k) {
                sink_(k == 0 ? "\n   " : ",\n   ");
                sink_(files_[i].diagnostics[k]);
            }
            sink_("]}");
        }
        sink_(fmt::format("],\n \"summary\": {}}}\n", dump(summary_to_json(summary))));
    }

  private:
    struct File {
        std::string path;
        std::vector<std::string> diagnostics;
    };

    std::size_t entry(std::string_view path) {
        const auto [found, is_new] = index_.try_emplace(std::string(path), files_.size());
        if (is_new) files_.push_back({std::string(path), {}});
        return found->second;
    }

    Sink sink_;
    std::vector<File> files_;  // in order of appearance
    std::map<std::string, std::size_t, std::less<>> index_;
};

class JsonLinesReporter : public Reporter {
  public:
    explicit JsonLinesReporter(Sink sink) : sink_(std::move(sink)) {}

    void file(const FileReport& report) override {
        Positions positions(*report.sources);
        for (const source::Diagnostic& diagnostic : report.diagnostics) {
            Json line = {{"version", kVersion}, {"path", path_of(diagnostic, report)}};
            line.update(to_json(diagnostic, positions));
            sink_(dump(line) + "\n");
        }
    }

    void finish(const Summary& summary) override {
        sink_(dump({{"version", kVersion}, {"summary", summary_to_json(summary)}}) + "\n");
    }

  private:
    Sink sink_;
};

}  // namespace

std::unique_ptr<Reporter> make_json_reporter(Sink sink) {
    return std::make_unique<JsonReporter>(std::move(sink));
}

std::unique_ptr<Reporter> make_json_lines_reporter(Sink sink) {
    return std::make_unique<JsonLinesReporter>(std::move(sink));
}

}  // namespace cobble::driver
