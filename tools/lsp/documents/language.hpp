// SPDX-License-Identifier: MIT
// What the server asks of a language; it knows nothing else about what is in a document.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/format/space_edits.hpp"
#include "frontend/source/diagnostic.hpp"
#include "frontend/source/file_source.hpp"
#include "frontend/source/source_map.hpp"

namespace cobble::lsp {

/// One text of a document, looked at once. All offsets are bytes of it.
class Analysis {
  public:
    Analysis() = default;
    Analysis(const Analysis&) = delete;
    Analysis& operator=(const Analysis&) = delete;
    virtual ~Analysis() = default;

    [[nodiscard]] virtual std::string_view text() const = 0;
    /// Where the findings' spans lie; the document itself is `source()`.
    [[nodiscard]] virtual const source::SourceMap& sources() const = 0;
    [[nodiscard]] virtual source::SourceId source() const = 0;
    /// Of a scene, what the questions of frontend/editor are asked of; else null.
    [[nodiscard]] virtual const frontend::CheckedScene* scene() const { return nullptr; }
    /// All that `cobble lint` says, in its order. Reads the files that the document names, once.
    virtual const std::vector<source::Diagnostic>& diagnostics(source::FileSource& files) = 0;
};

/// The text after all its safe fixes.
struct FixedText {
    std::string text;
    std::size_t applied = 0;
};

class Language {
  public:
    Language() = default;
    Language(const Language&) = delete;
    Language& operator=(const Language&) = delete;
    virtual ~Language() = default;

    [[nodiscard]] virtual std::unique_ptr<Analysis> analyse(std::string path,
                                                            std::string text) const = 0;
    /// Lines [first, last] from 1, or all with zeros.
    [[nodiscard]] virtual std::vector<frontend::SpaceEdit> format(
        std::string_view text, std::uint32_t first_line, std::uint32_t last_line) const = 0;
    [[nodiscard]] virtual FixedText fix_all(const std::string& path, std::string text,
                                            source::FileSource& files) const = 0;
};

/// Scenes.
std::unique_ptr<Language> make_scene_language();

}  // namespace cobble::lsp
