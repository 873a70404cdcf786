// SPDX-License-Identifier: MIT
// What a decoder forgives and a lint must not: files cut short, data damaged on the way.
#pragma once

#include <string>
#include <string_view>

namespace cobble::image {

/// The name of the file's format by its first bytes ("PNG"), or an empty string if it is none of
/// BMP, PNG, JPEG and HDR. TGA files have no mark at their beginning.
std::string_view image_format(std::string_view bytes);

/// Walks the file's own structure: chunks and their checksums (PNG), segments, their tables and the
/// end mark (JPEG), the bytes that its size calls for and the palette's range (BMP, TGA), run
/// lengths (TGA). Of an HDR file, whose decoder forgives nothing, only the header. Gives what is
/// wrong, for people, or an empty string. A decoder that is handed a file without fault here reads
/// no byte that is not there. Cost: one pass at most.
std::string find_damage(std::string_view bytes);

}  // namespace cobble::image
