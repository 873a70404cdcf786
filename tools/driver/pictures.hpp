// SPDX-License-Identifier: MIT
// Picture files, and the pictures that a render keeps beside its colours.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/picture/picture_io.hpp"

namespace cobble::driver {

struct ReadPicture {
    renderer::Plane32 plane;
    bool eight_bit = false;
    std::string comment;  ///< that the file carries; may be any text
    std::string problem;  ///< "cannot read PATH: REASON"; empty if it was read
};

ReadPicture read_picture(const std::string& path);

/// Encodes by the path's ending and writes the file whole. Gives "" or what went wrong.
std::string write_picture(const std::string& path, const renderer::Plane32& plane,
                          const renderer::EncodeOptions& options);

/// What speaks against writing a picture of this size to `path`: an ending that names no format, a
/// size that no file holds, a folder that is not there, no room on the disk. Gives "" or what is
/// wrong; writes nothing.
std::string check_picture_path(const std::string& path, std::uint32_t width, std::uint32_t height,
                               std::uint32_t channels);

/// True for the formats that keep 8 bits a channel.
bool keeps_bytes(const std::string& path);

/// Distances as grey for an 8-bit picture. White is near, black is far and where nothing is hit; in
/// Compat::kFa2016 near is black and nothing is white. Without a range it is that of the picture.
renderer::Plane32 depth_as_grey(const renderer::Plane32& depth, ir::Compat compat,
                                std::optional<std::pair<double, double>> range);

/// Normals as colours for an 8-bit picture: (n + 1) / 2 in each channel, and the absolute value in
/// the published programs of 2012, and those after them.
renderer::Plane32 normals_as_color(const renderer::Plane32& normals, ir::Compat compat);

/// Counts as grey: `samples`, as many as a pixel was to take, are white. So grey means the same in
/// all parts of a picture.
renderer::Plane32 counts_as_grey(const renderer::Plane32& counts, std::uint32_t samples);

}  // namespace cobble::driver
