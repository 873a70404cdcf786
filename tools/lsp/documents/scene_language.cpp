// SPDX-License-Identifier: MIT
#include <utility>

#include "frontend/format/format.hpp"
#include "tools/driver/fixes.hpp"
#include "tools/driver/session.hpp"
#include "tools/lsp/documents/language.hpp"

namespace cobble::lsp {
namespace {

class SceneAnalysis final : public Analysis {
  public:
    SceneAnalysis(std::string path, std::string text)
        : session_(std::move(path), std::move(text)) {}

    [[nodiscard]] std::string_view text() const override {
        return session_.sources.text(session_.scene);
    }
    [[nodiscard]] const source::SourceMap& sources() const override { return session_.sources; }
    [[nodiscard]] source::SourceId source() const override { return session_.scene; }

    [[nodiscard]] const frontend::CheckedScene* scene() const override { return &session_.checked; }

    const std::vector<source::Diagnostic>& diagnostics(source::FileSource& files) override {
        if (!linted_) diagnostics_ = driver::lint(session_, files, {});
        linted_ = true;
        return diagnostics_;
    }

  private:
    driver::Session session_;
    bool linted_ = false;
    std::vector<source::Diagnostic> diagnostics_;
};

class SceneLanguage final : public Language {
  public:
    [[nodiscard]] std::unique_ptr<Analysis> analyse(std::string path,
                                                    std::string text) const override {
        return std::make_unique<SceneAnalysis>(std::move(path), std::move(text));
    }

    [[nodiscard]] std::vector<frontend::SpaceEdit> format(std::string_view text,
                                                          std::uint32_t first_line,
                                                          std::uint32_t last_line) const override {
        const frontend::FormatResult result = frontend::format(text, {first_line, last_line});
        if (result.refused) return {};
        return frontend::space_edits(text, result.text);
    }

    [[nodiscard]] FixedText fix_all(const std::string& path, std::string text,
                                    source::FileSource& files) const override {
        driver::Fixed fixed = driver::fix_until_stable(path, std::move(text), files, {}, false);
        return {std::move(fixed.text), fixed.applied};
    }
};

}  // namespace

std::unique_ptr<Language> make_scene_language() { return std::make_unique<SceneLanguage>(); }

}  // namespace cobble::lsp
