// SPDX-License-Identifier: MIT
#include "tools/driver/report/object_words.hpp"

#include <fmt/core.h>

#include "tools/driver/text.hpp"

namespace cobble::driver {

source::Span face_span(const ir::Scene& scene, const ir::Object& object, std::uint32_t face) {
    if (object.kind != ir::ShapeKind::kMesh) return {};
    const ir::Mesh& mesh = scene.meshes[object.shape];
    if (face >= mesh.face_offsets.size() || !mesh.source.valid()) return {};
    return {mesh.source, mesh.face_offsets[face], mesh.face_offsets[face]};
}

std::string place_of(source::Span span, Positions& positions) {
    if (!span.valid()) return "";
    const source::LineColumn at = positions.start(span);
    return fmt::format("{}:{}:{}", printable(positions.path(span)), at.line, at.column);
}

std::string named(std::string_view kind, const std::string& label, source::Span span,
                  Positions& positions) {
    return fmt::format("{}{}{}  {}", kind, label.empty() ? "" : " ", printable(label),
                       place_of(span, positions));
}

Json place_json(source::Span span, Positions& positions) {
    if (!span.valid()) return nullptr;
    const source::LineColumn at = positions.start(span);
    return {{"path", positions.path(span)},
            {"line", at.line},
            {"column", at.column},
            {"range", range_to_json(span, positions)}};
}

Json object_json(const ir::Scene& scene, ir::ObjectId id, Positions& positions) {
    const ir::Object& object = scene.objects[id.value];
    return {{"index", id.value},
            {"kind", block_name(object.kind)},
            {"label", object.label},
            {"at", place_json(object.span, positions)}};
}

}  // namespace cobble::driver
