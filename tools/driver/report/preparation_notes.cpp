// SPDX-License-Identifier: MIT
#include "tools/driver/report/preparation_notes.hpp"

#include <fmt/core.h>

#include <set>

#include "tools/driver/report/object_words.hpp"

namespace cobble::driver {
namespace {

using renderer::PreparationNote;

// A scene of a thousand broken things has one thing wrong with it.
constexpr std::size_t kEnough = 20;

/// "3 faces of the TriangleMesh have", "the Box has": the subject and its verb.
std::string subject(const PreparationNote& note, const ir::Object& object, std::string_view one,
                    std::string_view many) {
    const std::string_view kind = block_name(object.kind);
    if (object.kind != ir::ShapeKind::kMesh) return fmt::format("the {} {}", kind, one);
    return note.count == 1 ? fmt::format("a face of the {} {}", kind, one)
                           : fmt::format("{} faces of the {} {}", note.count, kind, many);
}

/// The page that explains it, in brackets; "" where there is none.
std::string_view code_of(PreparationNote::Kind kind) {
    switch (kind) {
        case PreparationNote::Kind::kFlattened:
        case PreparationNote::Kind::kOutOfRange:
            return " [precision-loss]";
        case PreparationNote::Kind::kIllConditioned:
            return " [transform-ill-conditioned]";
        case PreparationNote::Kind::kDegenerate:
        case PreparationNote::Kind::kSingular:
            return "";
    }
    return "";
}

}  // namespace

std::string_view kind_name(PreparationNote::Kind kind) {
    switch (kind) {
        case PreparationNote::Kind::kDegenerate:
            return "degenerate";
        case PreparationNote::Kind::kFlattened:
            return "flattened";
        case PreparationNote::Kind::kOutOfRange:
            return "out-of-range";
        case PreparationNote::Kind::kIllConditioned:
            return "ill-conditioned";
        case PreparationNote::Kind::kSingular:
            return "singular";
    }
    return "?";
}

std::string note_text(const PreparationNote& note, const ir::Scene& scene, Positions& positions,
                      std::string_view precision) {
    const ir::Object& object = scene.objects[note.object.value];
    std::string text;
    switch (note.kind) {
        case PreparationNote::Kind::kDegenerate:
            text = subject(note, object, "has", "have") + " no extent: never hit";
            break;
        case PreparationNote::Kind::kFlattened:
            text = fmt::format("{} flat in {}, whose steps are wider there: never hit",
                               subject(note, object, "is", "are"), precision);
            break;
        case PreparationNote::Kind::kOutOfRange:
            text = fmt::format("{} beyond the range of {}: never hit",
                               subject(note, object, "is", "are"), precision);
            break;
        case PreparationNote::Kind::kIllConditioned:
            return fmt::format("the transforms of the {} lose most digits of {}",
                               block_name(object.kind), precision);
        case PreparationNote::Kind::kSingular:
            return fmt::format("the transforms of the {} flatten it in {}: never hit",
                               block_name(object.kind), precision);
    }
    const std::string face = place_of(face_span(scene, object, note.face), positions);
    if (!face.empty()) text += fmt::format(" ({} {})", note.count == 1 ? "at" : "first at", face);
    return text;
}

std::string notes_to_text(const std::vector<PreparationNote>& notes, const ir::Scene& scene,
                          Positions& positions, std::string_view precision) {
    std::string text;
    for (std::size_t i = 0; i < notes.size() && i < kEnough; ++i) {
        const ir::Object& object = scene.objects[notes[i].object.value];
        const std::string place = place_of(object.span, positions);
        text +=
            fmt::format("{}{}warning: {}{}\n", place, place.empty() ? "" : ": ",
                        note_text(notes[i], scene, positions, precision), code_of(notes[i].kind));
    }
    if (notes.size() > kEnough) {
        text += fmt::format("and {} more warnings like these\n", notes.size() - kEnough);
    }
    return text;
}

Json notes_to_json(const std::vector<PreparationNote>& notes, const ir::Scene& scene,
                   Positions& positions, std::string_view precision) {
    Json json = Json::array();
    for (const PreparationNote& note : notes) {
        json.push_back({{"kind", kind_name(note.kind)},
                        {"object", object_json(scene, note.object, positions)},
                        {"count", note.count},
                        {"message", note_text(note, scene, positions, precision)}});
    }
    return json;
}

std::string_view prepared_in(const ir::Scene& scene, const renderer::Settings& settings) {
    // The published programs' ways are all traced in double.
    const bool wide =
        scene.compat != ir::Compat::kNone || settings.precision == renderer::Precision::kDouble;
    return wide ? "double" : "float";
}

std::vector<PreparationNote> without_checked(const std::vector<PreparationNote>& notes,
                                             const ir::Scene& scene,
                                             const std::vector<source::Diagnostic>& diagnostics) {
    std::set<std::uint32_t> lossy;  // where such objects begin
    for (const source::Diagnostic& diagnostic : diagnostics) {
        const std::string_view code = diagnostic.code->code;
        if (code == "precision-loss" || code == "transform-ill-conditioned" ||
            code == "degenerate-triangle") {
            lossy.insert(diagnostic.span.begin);
        }
    }
    std::vector<PreparationNote> rest;
    for (const PreparationNote& note : notes) {
        const ir::Object& object = scene.objects[note.object.value];
        const bool faces =
            object.kind == ir::ShapeKind::kTriangle || object.kind == ir::ShapeKind::kMesh;
        const bool checked = note.kind == PreparationNote::Kind::kDegenerate ? faces
                             : note.kind == PreparationNote::Kind::kSingular
                                 ? false
                                 : lossy.contains(object.span.begin);
        if (!checked) rest.push_back(note);
    }
    return rest;
}

}  // namespace cobble::driver
