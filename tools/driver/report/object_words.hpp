// SPDX-License-Identifier: MIT
// What reports call the things of a scene, and where these stand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/scene/scene.hpp"
#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/positions.hpp"

namespace cobble::driver {

using ir::block_name;

/// Where the face of a mesh stands in its OBJ file; invalid for other objects.
source::Span face_span(const ir::Scene& scene, const ir::Object& object, std::uint32_t face);

/// "path:line:column" of where a span begins, made safe to print; "" for an invalid one.
std::string place_of(source::Span span, Positions& positions);

/// The kind and label of something, and its place, made safe to print.
std::string named(std::string_view kind, const std::string& label, source::Span span,
                  Positions& positions);

/// {"path", "line", "column", "range"}; null for an invalid span.
Json place_json(source::Span span, Positions& positions);

/// {"index", "kind", "label", "at"}.
Json object_json(const ir::Scene& scene, ir::ObjectId id, Positions& positions);

}  // namespace cobble::driver
