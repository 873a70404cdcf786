// SPDX-License-Identifier: MIT
// A diagnostic as JSON: the one place where its fields are named, for every tool that speaks JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "frontend/source/diagnostic.hpp"
#include "tools/driver/report/positions.hpp"

namespace cobble::driver {

using Json = nlohmann::ordered_json;

/// {"start": {"line", "column", "offset"}, "end": ...}: lines and columns from 1, columns in code
/// points, offsets in bytes, the end exclusive; null for an invalid span.
Json range_to_json(source::Span span, Positions& positions);

/// code, severity, message, range, notes, help, related, fixes. An edit has a path only if it lies
/// in another file than the diagnostic.
Json to_json(const source::Diagnostic& diagnostic, Positions& positions);

/// On one line; bytes that are not UTF-8 become U+FFFD.
std::string dump(const Json& json);

/// Over lines, one space a level, with a line end; else the same.
std::string pretty(const Json& json);

}  // namespace cobble::driver
