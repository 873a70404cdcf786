// SPDX-License-Identifier: MIT
// Scenes around the few lines that the page of a diagnostic is about.
//
// Made while codes are constructed, before main; the texts live as long as the program. `lines` end
// with a line end and are indented from 0; they are moved in to where they stand.
#pragma once

#include <string_view>

namespace cobble::frontend {

/// A PerspectiveCamera that looks along -z, with `lines` behind its direction and `up`.
std::string_view camera_example(std::string_view lines);

/// A Group with a Transform that holds `lines` and then a Sphere.
std::string_view transform_example(std::string_view lines);

/// `materials` in Materials, and a Group that holds `lines` and then a Sphere.
std::string_view object_example(std::string_view materials, std::string_view lines);

}  // namespace cobble::frontend
