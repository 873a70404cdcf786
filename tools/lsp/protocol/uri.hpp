// SPDX-License-Identifier: MIT
// file: URIs (RFC 8089) and paths.
#pragma once

#include <string>
#include <string_view>

namespace cobble::lsp {

/// "file:///a%20b.scene" as "/a b.scene". What is no file: URI is its own path, by which nothing
/// will be found on a disk: a buffer that was never saved, say.
std::string path_of_uri(std::string_view uri);

/// "/a b.scene" as "file:///a%20b.scene"; what does not begin with '/' as it is.
std::string uri_of_path(std::string_view path);

}  // namespace cobble::lsp
