// SPDX-License-Identifier: MIT
#include "frontend/source/file_source.hpp"

namespace cobble::source {

std::string_view folder_of(std::string_view path) {
    const auto slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash + 1);
}

std::string resolve(std::string_view from, std::string_view path) {
    if (path.starts_with('/')) return std::string(path);
    std::string joined(folder_of(from));
    joined += path;
    return joined;
}

}  // namespace cobble::source
