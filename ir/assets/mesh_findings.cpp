// SPDX-License-Identifier: MIT
// What a mesh file is told about itself.
#include "ir/assets/mesh_findings.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "ir/assets/asset_loader.hpp"
#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/assets/obj/obj_problems.hpp"

namespace cobble::ir {

using source::Diagnostic;
using source::DiagnosticCode;
using source::Severity;
using source::Span;

namespace {

const DiagnosticCode kEmpty{
    "asset-mesh-empty",
    Severity::kWarning,
    "a mesh file has no usable face",
    "There is nothing to draw: the file has no `f` line that could be used. The object is left "
    "out.",
    "v 0 0 0\nv 1 0 0\nv 0 1 0",
    "Export the mesh with its faces, or remove the object."};

const DiagnosticCode kDegenerateFace{
    "asset-mesh-degenerate-face",
    Severity::kWarning,
    "faces of a mesh have no area",
    "A face whose corners lie on one line cannot be hit by a ray and has no normal. It is kept, "
    "so that the numbers of the other faces stay what they are, but nothing of it is seen.",
    "f 1 2 2",
    "Remove the face, or merge doubled vertices in a modelling program."};

const DiagnosticCode kZeroNormal{
    "asset-mesh-zero-normal",
    Severity::kWarning,
    "normals of a mesh have no length",
    "A `vn` of 0 0 0 points nowhere; faces that use it are shaded flat.",
    "vn 0 0 0",
    "Export the mesh again with normals, or without any."};

const DiagnosticCode kDegenerateUv{
    "asset-mesh-degenerate-uv",
    Severity::kWarning,
    "texture coordinates under a normal map have no area",
    "A normal map is turned into space along the directions in which the texture coordinates grow. "
    "Where the corners of a face have no such directions, any tangent is taken, so the relief may "
    "look turned there.",
    "vt 0 0\nf 1/1 2/1 3/1",
    "Unwrap the mesh so that each face covers some area of the picture."};

/// The line that begins at `offset`.
Span line_span(source::SourceId id, std::string_view text, std::uint32_t offset) {
    const auto end = std::min(text.find_first_of("\r\n", offset), text.size());
    return {id, offset, static_cast<std::uint32_t>(end)};
}

struct Tally {
    std::uint64_t count = 0;
    std::uint32_t first = 0;  ///< byte of the first one's line
    void add(std::uint32_t offset) {
        if (count++ == 0) first = offset;
    }
};

std::string of(std::uint64_t count, std::size_t total) {
    return std::to_string(count) + " of " + std::to_string(total) +
           (total == 1 ? " face" : " faces");
}

/// How many faces the file has: polygons are cut into triangles, which share their line.
std::size_t faces_as_written(const ObjFile& file) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < file.face_offsets.size(); ++i) {
        count += i == 0 || file.face_offsets[i] != file.face_offsets[i - 1] ? 1 : 0;
    }
    return count;
}

bool face_has_area(const ObjFile& file, std::size_t face) {
    const auto& c = file.faces[face].corners;
    const auto& p = file.positions;
    return has_area(p[c[0].position], p[c[1].position], p[c[2].position]);
}

/// Some triangle of the polygon of this line has an area.
bool partly_has_area(const ObjFile& file, std::uint32_t line) {
    auto at = static_cast<std::size_t>(
        std::lower_bound(file.face_offsets.begin(), file.face_offsets.end(), line) -
        file.face_offsets.begin());
    for (; at < file.faces.size() && file.face_offsets[at] == line; ++at) {
        if (face_has_area(file, at)) return true;
    }
    return false;
}

Diagnostic about(const DiagnosticCode& code, std::string message, Span span, Span scene_span) {
    Diagnostic diagnostic;
    diagnostic.code = &code;
    diagnostic.severity = code.severity;
    diagnostic.message = std::move(message);
    diagnostic.span = span;
    diagnostic.related.push_back({scene_span, "the mesh is named here"});
    return diagnostic;
}

}  // namespace

void AssetLoader::report_problems(const LoadedObj& loaded, Span span) {
    const ObjFile& file = loaded.file;
    const std::size_t first = found_.size();
    for (const ObjProblem& problem : file.problems) {
        report(about(*problem.code, problem.message, {loaded.source, problem.begin, problem.end},
                     span),
               span);
    }
    if (file.problem_count > file.problems.size() && found_.size() > first) {
        found_.back().diagnostic.notes.push_back(
            "and " + std::to_string(file.problem_count - file.problems.size()) +
            " more errors in this file");
    }
    for (const ObjProblem& remark : file.remarks) {
        report(about(*remark.code, remark.message, {loaded.source, remark.begin, remark.end}, span),
               span);
    }
    if (file.more_remarks) {
        found_.back().diagnostic.notes.emplace_back("other words are not listed");
    }
    const std::string_view text = sources_.text(loaded.source);
    if (file.faces.empty()) {
        // Errors of the file say more, and why.
        if (file.problem_count > 0) return;
        report(about(kEmpty, "mesh has no usable face", {loaded.source, 0, 0}, span), span);
        return;
    }
    Tally flat;
    Tally zero;
    for (std::size_t i = 0; i < file.faces.size(); ++i) {
        if (!face_has_area(file, i)) flat.add(file.face_offsets[i]);
        for (const auto& corner : file.faces[i].corners) {
            if (corner.normal == Mesh::kNone) continue;
            const math::Vec3d& n = file.normals[corner.normal];
            if (n.x != 0 || n.y != 0 || n.z != 0) continue;
            zero.add(file.face_offsets[i]);
            break;
        }
    }
    if (flat.count > 0) {
        const std::size_t written = faces_as_written(file);
        const bool cut = written < file.faces.size();
        const std::string subject =
            cut ? std::to_string(flat.count) + " of the " + std::to_string(file.faces.size()) +
                      " triangles of the mesh's " + std::to_string(written) +
                      (written == 1 ? " face" : " faces")
                : of(flat.count, file.faces.size()) + " of the mesh";
        Diagnostic finding = about(kDegenerateFace, subject + " have no area",
                                   line_span(loaded.source, text, flat.first), span);
        if (partly_has_area(file, flat.first)) {
            finding.notes.emplace_back(
                "the rest of this face has an area: three of its corners lie on one line, or two "
                "in one place");
        }
        report(std::move(finding), span);
    }
    if (zero.count > 0) {
        report(
            about(kZeroNormal,
                  of(zero.count, file.faces.size()) + " of the mesh have a normal without length",
                  line_span(loaded.source, text, zero.first), span),
            span);
    }
}

void report_degenerate_uvs(AssetLoader& loader, const LoadedObj& loaded, std::string_view text,
                           Span span) {
    const ObjFile& file = loaded.file;
    Tally tally;
    for (std::size_t i = 0; i < file.faces.size(); ++i) {
        const auto& c = file.faces[i].corners;
        if (c[0].uv != Mesh::kNone) {
            const math::Vec2d a = file.uvs[c[0].uv];
            const math::Vec2d b = file.uvs[c[1].uv];
            const math::Vec2d d = file.uvs[c[2].uv];
            const double area = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
            if (area != 0) continue;
        }
        tally.add(file.face_offsets[i]);
    }
    if (tally.count == 0) return;
    loader.report(about(kDegenerateUv,
                        of(tally.count, file.faces.size()) +
                            " under a normal map have texture coordinates without area",
                        line_span(loaded.source, text, tally.first), span),
                  span);
}

}  // namespace cobble::ir
