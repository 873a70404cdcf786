// SPDX-License-Identifier: MIT
// The files of one run: their paths and, for text files, their bytes.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "frontend/source/span.hpp"

namespace cobble::source {

/// Owns the paths and texts that spans refer to. Text views stay valid as long as the map lives.
class SourceMap {
  public:
    /// Adds a file; `text` is empty for binary files. At most 2^32 - 2 bytes of text.
    SourceId add(std::string path, std::string text);

    [[nodiscard]] std::string_view path(SourceId id) const { return files_[id.value].path; }
    [[nodiscard]] std::string_view text(SourceId id) const { return files_[id.value].text; }
    [[nodiscard]] std::string_view text(Span span) const {
        return text(span.source).substr(span.begin, span.end - span.begin);
    }
    [[nodiscard]] std::size_t size() const { return files_.size(); }

  private:
    struct File {
        std::string path;
        std::string text;
    };
    std::deque<File> files_;  // a deque, so that adding a file moves no text
};

}  // namespace cobble::source
