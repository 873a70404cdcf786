// SPDX-License-Identifier: MIT
// OBJ text as the published programs read it; see ObjRules::kPublished.
#pragma once

#include "ir/assets/obj/obj_file.hpp"

namespace cobble::ir {

ObjFile read_published_obj(const std::string& text, std::uint64_t max_faces);

}  // namespace cobble::ir
