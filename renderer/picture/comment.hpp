// SPDX-License-Identifier: MIT
// A line of text inside a picture file, where viewers pass over it or show it as a comment.
//
// PNG has a tEXt chunk "Comment" for it, OpenEXR an attribute "comments", Radiance a header line
// that begins with "#", TGA its image ID. PFM and BMP have no place for text: there it follows the
// last pixel as a line of its own, which readers do not look at.
#pragma once

#include <string>
#include <string_view>

#include "renderer/picture/picture_io.hpp"

namespace cobble::renderer {

/// A TGA file counts the bytes of its image ID in 8 bits.
inline constexpr std::size_t kMaxComment = 255;

/// Puts `comment` into a file that encode() made: 1 to kMaxComment bytes of printable ASCII.
void add_comment(std::string& bytes, PictureFormat format, std::string_view comment);

/// The first comment of a picture file of any of these formats, "" if there is none. PFM, BMP and
/// TGA files without one may give any text: look for what a comment of yours begins with. Any bytes
/// may be given; costs no more than a look at the headers.
std::string comment_of(std::string_view bytes);

}  // namespace cobble::renderer
