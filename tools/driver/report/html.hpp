// SPDX-License-Identifier: MIT
// Pieces of HTML pages that need nothing but themselves.
#pragma once

#include <string>
#include <string_view>

#include "renderer/film/picture.hpp"
#include "tools/driver/report/cost_tables.hpp"

namespace cobble::driver {

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// An <img> with the picture inside, as PNG; "" if it is empty or PNG cannot hold it. `alt` is
/// plain text.
std::string html_picture(const renderer::Plane32& picture, std::string_view alt);

/// With a capital first, if it is a Latin letter.
std::string sentence(std::string text);

/// A table with a caption and headers for its columns and rows, in a box that scrolls where the
/// page is too narrow; the notes below.
std::string html_table(const CostTable& table);

}  // namespace cobble::driver
