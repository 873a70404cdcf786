// SPDX-License-Identifier: MIT
// Spans as lines and columns, with one line index for each file that is asked about.
#pragma once

#include <map>
#include <string_view>

#include "frontend/source/line_index.hpp"
#include "frontend/source/source_map.hpp"
#include "frontend/source/span.hpp"

namespace cobble::driver {

class Positions {
  public:
    explicit Positions(const source::SourceMap& sources) : sources_(&sources) {}

    [[nodiscard]] const source::LineIndex& lines(source::SourceId id) {
        const auto found = indices_.find(id.value);
        if (found != indices_.end()) return found->second;
        return indices_.try_emplace(id.value, sources_->text(id)).first->second;
    }
    [[nodiscard]] source::LineColumn start(source::Span span) {
        return lines(span.source).locate(span.begin);
    }
    [[nodiscard]] source::LineColumn end(source::Span span) {
        return lines(span.source).locate(span.end);
    }
    [[nodiscard]] std::string_view path(source::Span span) const {
        return sources_->path(span.source);
    }

  private:
    const source::SourceMap* sources_;
    std::map<std::uint32_t, source::LineIndex> indices_;
};

}  // namespace cobble::driver
