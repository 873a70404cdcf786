// SPDX-License-Identifier: MIT
#include "frontend/source/source_map.hpp"

#include <utility>

namespace cobble::source {

SourceId SourceMap::add(std::string path, std::string text) {
    files_.push_back({std::move(path), std::move(text)});
    return SourceId{static_cast<std::uint32_t>(files_.size() - 1)};
}

}  // namespace cobble::source
