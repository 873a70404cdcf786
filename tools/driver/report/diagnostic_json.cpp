// SPDX-License-Identifier: MIT
#include "tools/driver/report/diagnostic_json.hpp"

#include <fmt/core.h>

#include "tools/driver/report/formats.hpp"

namespace cobble::driver {
namespace {

Json place_to_json(source::LineColumn place, std::uint32_t offset) {
    return {{"line", place.line}, {"column", place.column}, {"offset", offset}};
}

Json fix_to_json(const source::Fix& fix, source::Span of, Positions& positions) {
    Json edits = Json::array();
    for (const source::Edit& edit : fix.edits) {
        Json entry = Json::object();
        if (edit.span.source != of.source) entry["path"] = positions.path(edit.span);
        entry["range"] = range_to_json(edit.span, positions);
        entry["text"] = edit.text;
        edits.push_back(std::move(entry));
    }
    return {{"title", fix.title}, {"safe", fix.safe}, {"edits", std::move(edits)}};
}

}  // namespace

Json range_to_json(source::Span span, Positions& positions) {
    if (!span.valid()) return nullptr;
    return {{"start", place_to_json(positions.start(span), span.begin)},
            {"end", place_to_json(positions.end(span), span.end)}};
}

Json to_json(const source::Diagnostic& diagnostic, Positions& positions) {
    Json related = Json::array();
    for (const source::Related& place : diagnostic.related) {
        related.push_back({{"path", place.span.valid() ? positions.path(place.span) : ""},
                           {"message", place.message},
                           {"range", range_to_json(place.span, positions)}});
    }
    Json fixes = Json::array();
    for (const source::Fix& fix : diagnostic.fixes) {
        fixes.push_back(fix_to_json(fix, diagnostic.span, positions));
    }
    return {{"code", diagnostic.code->code},
            {"severity", name_of(diagnostic.severity)},
            {"message", diagnostic.message},
            {"range", range_to_json(diagnostic.span, positions)},
            {"notes", diagnostic.notes},
            {"help", fmt::format("cobble explain {}", diagnostic.code->code)},
            {"related", std::move(related)},
            {"fixes", std::move(fixes)}};
}

std::string dump(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string pretty(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cobble::driver
