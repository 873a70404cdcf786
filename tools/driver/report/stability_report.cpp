// SPDX-License-Identifier: MIT
#include "tools/driver/report/stability_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tools/driver/report/excerpt.hpp"
#include "tools/driver/report/figures.hpp"
#include "tools/driver/report/object_words.hpp"
#include "tools/driver/report/preparation_notes.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using renderer::ObjectStability;
using renderer::PixelPrecision;
using renderer::StabilityFault;

// A screenful: those without a fault beyond it are no worse than the last.
constexpr std::size_t kEnough = 20;

constexpr std::string_view kBold = "1";
constexpr std::string_view kRed = "1;31";
constexpr std::string_view kGreen = "1;32";

std::string_view name_of(StabilityFault fault) {
    switch (fault) {
        case StabilityFault::kCrack:
            return "crack";
        case StabilityFault::kChanged:
            return "changed";
        case StabilityFault::kSelfHit:
            return "self-hit";
        case StabilityFault::kLost:
            return "lost";
    }
    return "?";
}

std::string_view words_of(StabilityFault fault) {
    return fault == StabilityFault::kChanged ? "changed hit" : name_of(fault);
}

// Their number does not matter where there are very many.
std::string steps_text(double ulps) { return ulps < 1e6 ? fmt::format("{:.3g}", ulps) : "> 1e+06"; }

struct Faults {
    std::uint64_t cracks = 0, changed = 0, self_hits = 0, lost = 0, too_coarse = 0;

    void add(const ObjectStability& object) {
        cracks += object.cracks;
        changed += object.changed;
        self_hits += object.self_hits;
        lost += object.lost > 0 ? 1 : 0;
        too_coarse += object.too_coarse() ? 1 : 0;
    }
    /// Along rays that float saw something along, which number types do not explain.
    [[nodiscard]] bool hits() const { return cracks + changed + self_hits > 0; }
    [[nodiscard]] bool any() const { return hits() || lost + too_coarse > 0; }
    [[nodiscard]] int kinds() const {
        return (cracks > 0 ? 1 : 0) + (changed > 0 ? 1 : 0) + (self_hits > 0 ? 1 : 0);
    }
    /// The kinds that there are; with `all`, the first three in any case.
    [[nodiscard]] std::string text(bool all) const {
        std::string words;
        const auto add = [&](std::uint64_t count, std::string_view what) {
            if (!words.empty()) words += ", ";
            words += counted(count, what);
        };
        if (all || cracks > 0) add(cracks, "crack");
        if (all || changed > 0) add(changed, "changed hit");
        if (all || self_hits > 0) add(self_hits, "self-hit");
        if (lost > 0) add(lost, "lost object");
        if (too_coarse > 0) {
            words += words.empty() ? "" : ", ";
            words += "float too coarse for " + counted(too_coarse, "object");
        }
        return words;
    }
};

Faults faults_of(const renderer::Stability& stability) {
    Faults faults;
    for (const ObjectStability& object : stability.objects) faults.add(object);
    return faults;
}

/// "far.scene:33:5: WHAT: WHERE" in colours.
std::string fault_line(std::string_view place, std::string_view what, std::string_view where,
                       const ReportStyle& style) {
    return fmt::format("{}{}{}: {}\n", painted(kBold, place, style), place.empty() ? "" : ": ",
                       painted(kRed, what, style), painted(kBold, where, style));
}

/// What an object's faults are and where the first of them is, with its line.
std::string fault_text(const StabilityReport& report, const ObjectStability& entry,
                       Positions& positions, const ReportStyle& style) {
    const ir::Object& object = report.scene.objects[entry.object.value];
    const std::string_view kind = block_name(object.kind);
    const std::string place = place_of(object.span, positions);
    std::string text;
    std::string first;
    if (entry.example) {
        const math::Vec3d p = entry.example->position;
        const std::string face =
            place_of(face_span(report.scene, object, entry.example->face), positions);
        first = fmt::format("{:.9g} {:.9g} {:.9g}{}{}", p.x, p.y, p.z,
                            face.empty() ? "" : ", face ", face);
    }
    if (const Faults faults{entry.cracks, entry.changed, entry.self_hits}; faults.any()) {
        text += fault_line(
            place, faults.text(false),
            fmt::format(
                "on the {}, the first{} at {}", kind,
                faults.kinds() == 1 ? "" : fmt::format(", a {},", words_of(entry.example->fault)),
                first),
            style);
    } else if (entry.lost > 0) {
        text +=
            fault_line(place, "lost",
                       fmt::format("double sees the {} along {}, float along none, such as at {}",
                                   kind, counted(entry.lost, "ray"), first),
                       style);
    }
    if (entry.too_coarse()) {
        const PixelPrecision& at = *entry.worst;
        const math::Vec3d p = at.position;
        text += fault_line(
            place, "float is too coarse",
            fmt::format(
                "a pixel of the {} is {} of its steps at {:.9g} {:.9g} {:.9g}: {:.3g} wide, "
                "where floats are {:.3g} apart",
                kind, steps_text(at.ulps()), p.x, p.y, p.z, at.pixel, at.step),
            style);
    }
    if (object.span.valid()) text += excerpt_of(object.span, positions, style, kRed);
    return text;
}

constexpr std::string_view kRow = "{:>7} {:>7} {:>7} {:>8} {:>10} {:>6} {:>11}  {}\n";

std::string table(const StabilityReport& report, Positions& positions) {
    const auto& objects = report.stability.objects;
    std::string text = fmt::format(kRow, "rays", "hits", "cracks", "changed", "self-hits", "lost",
                                   "ulps/pixel", "object");
    std::size_t shown = 0;
    for (const ObjectStability& entry : objects) {
        if (shown >= kEnough) break;
        ++shown;
        const ir::Object& object = report.scene.objects[entry.object.value];
        text +=
            fmt::format(kRow, entry.rays, entry.hits, entry.cracks, entry.changed, entry.self_hits,
                        entry.lost, entry.worst ? steps_text(entry.least_ulps()) : "-",
                        named(block_name(object.kind), object.label, object.span, positions));
    }
    if (shown < objects.size()) {
        text += fmt::format("and {}, none of them worse (--format json has all)\n",
                            counted(objects.size() - shown, "object"));
    }
    return text;
}

std::string precision(const StabilityReport& report, Positions& positions) {
    const renderer::Stability& s = report.stability;
    std::string text =
        fmt::format("steps of float across a pixel of {}x{}\n", report.width, report.height);
    const auto line = [&](std::string_view name, const std::optional<PixelPrecision>& at) {
        if (!at) return;
        const ir::Object& object = report.scene.objects[at->object.value];
        text += fmt::format("  {:<13} {:>8}  (it is {:.3g} wide, {:.3g} from the camera)  {}\n",
                            name, steps_text(at->ulps()), at->pixel, at->distance,
                            named(block_name(object.kind), object.label, object.span, positions));
    };
    line("nearest hit", s.nearest);
    line("farthest hit", s.farthest);
    line("worst feature", s.worst);
    return s.worst ? text : "";
}

std::string changes(const renderer::PrimitiveChanges& c) {
    if (c.rays == 0) return "";
    std::string text = fmt::format(
        "along {} float and double met different things first; "
        "by 106 binary digits double is right along {}, float along {}, both along {}",
        counted(c.rays, "ray"), c.for_double, c.for_float, c.for_both);
    if (c.open > 0)
        text += fmt::format(", and {} {} too close to call", c.open, c.open == 1 ? "is" : "are");
    return text + "\n";
}

struct Shortcomings {
    std::uint64_t few = 0, unseen = 0;
};

Shortcomings shortcomings_of(const renderer::Stability& stability) {
    Shortcomings sum;
    for (const ObjectStability& object : stability.objects) {
        const bool few = object.least_ulps() < renderer::kFewUlps;
        sum.few += few && !object.too_coarse() ? 1 : 0;
        sum.unseen += object.hits == 0 && object.lost == 0 ? 1 : 0;
    }
    return sum;
}

/// What the notes tell of that no ray can.
struct Lost {
    std::uint64_t faces = 0, of_faces = 0;  ///< of objects that are there in part
    std::uint64_t unseen = 0;               ///< objects without a part in float, in double unseen
    std::uint64_t blurred = 0;              ///< by transforms that lose digits
    std::uint64_t as_written = 0;           ///< objects that have no extent in any number type

    [[nodiscard]] bool by_float() const { return faces + unseen + blurred > 0; }
};

Lost lost_of(const renderer::Stability& stability) {
    using Note = renderer::PreparationNote;
    Lost lost;
    std::vector<std::uint64_t> faces(stability.objects.size());
    for (const ObjectStability& object : stability.objects) {
        faces[object.object.value] = object.faces;
        if (object.faces_lost == 0 || object.lost > 0) continue;
        if (object.faces_lost == object.faces) {
            ++lost.unseen;
        } else {
            lost.faces += object.faces_lost;
            lost.of_faces += object.faces;
        }
    }
    for (const Note& note : stability.notes) {
        const bool whole = note.count == faces[note.object.value];
        if (note.kind == Note::Kind::kDegenerate && whole) ++lost.as_written;
        if (note.kind == Note::Kind::kIllConditioned) ++lost.blurred;
    }
    return lost;
}

/// The notes without those of faces that nobody would see: they matter as little in float as in
/// any other number type.
std::vector<renderer::PreparationNote> visible(const renderer::Stability& stability) {
    using Kind = renderer::PreparationNote::Kind;
    std::vector<const ObjectStability*> objects(stability.objects.size());
    for (const ObjectStability& object : stability.objects) objects[object.object.value] = &object;
    auto notes = stability.notes;
    std::erase_if(notes, [&](const renderer::PreparationNote& note) {
        const ObjectStability& object = *objects[note.object.value];
        if (note.kind == Kind::kDegenerate) return note.count < object.faces;
        return (note.kind == Kind::kFlattened || note.kind == Kind::kOutOfRange) &&
               object.faces_lost == 0;
    });
    return notes;
}

std::uint64_t rays_of(const renderer::Stability& s) {
    return s.rays + s.picture_rays + s.departures;
}

std::string summary(const StabilityReport& report, const ReportStyle& style) {
    const renderer::Stability& s = report.stability;
    const Faults faults = faults_of(s);
    const auto [few, unseen] = shortcomings_of(s);
    std::string text;
    if (few > 0) {
        text += fmt::format(
            "{} with pixels of less than {} steps of float, where neighbours may look alike; "
            "--precision double has more\n",
            counted(few, "object"), renderer::kFewUlps);
    }
    if (unseen > 0) {
        text += fmt::format(
            "{} that no ray {}: nothing is said of what is hidden from the camera, or seen only "
            "through glass or in mirrors\n",
            counted(unseen, "object"), s.complete ? "met, in double either" : "has met so far");
    }
    if (faults.hits()) {
        text +=
            "where float is too coarse, `cobble lint` says by how much and --precision double "
            "renders it; elsewhere a fault is one of the renderer\n";
    } else if (faults.any()) {
        text += "float is not good enough: --precision double renders what it loses or coarsens\n";
    }
    if (!s.complete) text += "stopped before all rays were cast: what was found until then\n";
    if (!faults.any() && few == 0 && !lost_of(s).by_float() && s.worst) {
        text += fmt::format(
            "float is good enough{}: a pixel is {} of its steps wide at least, and {} would do\n",
            s.complete && unseen == 0 ? "" : " for what was measured", steps_text(s.worst->ulps()),
            renderer::kFewUlps);
    }
    text += fmt::format("{}: {}, {}x{}: {}\n", printable(report.path), counted(rays_of(s), "ray"),
                        report.width, report.height,
                        painted(faults.any() ? kRed : kGreen, faults.text(true), style));
    return text;
}

Json precision_json(const std::optional<PixelPrecision>& at, const ir::Scene& scene,
                    Positions& positions) {
    if (!at) return nullptr;
    return {{"ulps_per_pixel", at->ulps()},
            {"pixel", at->pixel},
            {"distance", at->distance},
            {"position", Json::array({at->position.x, at->position.y, at->position.z})},
            {"object", object_json(scene, at->object, positions)}};
}

Json object_entry(const StabilityReport& report, const ObjectStability& entry,
                  Positions& positions) {
    const ir::Object& object = report.scene.objects[entry.object.value];
    Json json = {{"object", object_json(report.scene, entry.object, positions)},
                 {"closed", object.kind == ir::ShapeKind::kMesh ? Json(entry.closed) : nullptr},
                 {"rays", entry.rays},
                 {"hits", entry.hits},
                 {"cracks", entry.cracks},
                 {"changed", entry.changed},
                 {"self_hits", entry.self_hits},
                 {"lost", entry.lost},
                 {"too_coarse", entry.too_coarse()},
                 {"faces", entry.faces},
                 {"faces_lost", entry.faces_lost},
                 {"least_ulps_per_pixel", nullptr}};
    if (entry.worst) json["least_ulps_per_pixel"] = entry.least_ulps();
    if (!entry.example) return json;
    const math::Vec3d p = entry.example->position;
    Json first = {{"kind", name_of(entry.example->fault)},
                  {"position", Json::array({p.x, p.y, p.z})}};
    const source::Span face = face_span(report.scene, object, entry.example->face);
    if (face.valid()) {
        first["face"] = {{"index", entry.example->face}, {"at", place_json(face, positions)}};
    }
    json["first_fault"] = std::move(first);
    return json;
}

}  // namespace

std::string stability_to_text(const StabilityReport& report, const ReportStyle& style) {
    Positions positions(report.sources);
    std::string text;
    std::size_t shown = 0;
    for (const ObjectStability& entry : report.stability.objects) {
        if (entry.sound() || ++shown > kEnough) break;
        text += fault_text(report, entry, positions, style);
    }
    return text + table(report, positions) + precision(report, positions) +
           changes(report.stability.changes) +
           notes_to_text(visible(report.stability), report.scene, positions, "float") +
           summary(report, style);
}

std::string stability_line(const StabilityReport& report) {
    const renderer::Stability& s = report.stability;
    const Faults faults = faults_of(s);
    const auto [few, unseen] = shortcomings_of(s);
    std::string text = fmt::format("{}: {}, {}", printable(report.path),
                                   faults.any() ? faults.text(false)
                                   : s.complete ? "sound"
                                                : "sound so far",
                                   counted(rays_of(s), "ray"));
    if (s.worst) {
        text += fmt::format(", a pixel is {} steps of float at least", steps_text(s.worst->ulps()));
    }
    if (few > 0) text += fmt::format(", {} with too few digits", counted(few, "object"));
    if (unseen > 0) text += fmt::format(", {} not met", counted(unseen, "object"));
    const Lost lost = lost_of(s);
    if (lost.faces > 0) {
        text += fmt::format(", lost in part: {} of {}", lost.faces, counted(lost.of_faces, "face"));
    }
    if (lost.unseen > 0) {
        text += fmt::format(", {} out of sight not there in float", counted(lost.unseen, "object"));
    }
    if (lost.blurred > 0) {
        text += fmt::format(", {} whose transforms lose digits", counted(lost.blurred, "object"));
    }
    if (lost.as_written > 0) {
        text += fmt::format(", {} without extent", counted(lost.as_written, "object"));
    }
    if (!s.complete) text += ", stopped early";
    return text + "\n";
}

Json stability_to_json(const StabilityReport& report) {
    Positions positions(report.sources);
    const renderer::Stability& s = report.stability;
    Json objects = Json::array();
    for (const ObjectStability& entry : s.objects) {
        objects.push_back(object_entry(report, entry, positions));
    }
    return {{"cobble_stability", 1},
            {"path", report.path},
            {"size", Json::array({report.width, report.height})},
            {"rays", s.rays},
            {"picture_rays", s.picture_rays},
            {"departures", s.departures},
            {"clean", s.clean()},
            {"complete", s.complete},
            {"precision",
             {{"nearest", precision_json(s.nearest, report.scene, positions)},
              {"farthest", precision_json(s.farthest, report.scene, positions)},
              {"worst", precision_json(s.worst, report.scene, positions)}}},
            {"primitive_changes",
             {{"rays", s.changes.rays},
              {"for_double", s.changes.for_double},
              {"for_float", s.changes.for_float},
              {"for_both", s.changes.for_both},
              {"open", s.changes.open}}},
            {"objects", std::move(objects)},
            {"notes", notes_to_json(s.notes, report.scene, positions, "float")}};
}

}  // namespace cobble::driver
