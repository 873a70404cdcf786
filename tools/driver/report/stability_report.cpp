// SPDX-License-Identifier: MIT
#include "tools/driver/report/stability_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/driver/report/object_words.hpp"
#include "tools/driver/report/preparation_notes.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using renderer::ObjectStability;
using renderer::StabilityFault;

// A screenful: those without a fault beyond it are no worse than the last.
constexpr std::size_t kEnough = 20;

std::string_view name_of(StabilityFault fault) {
    switch (fault) {
        case StabilityFault::kCrack:
            return "crack";
        case StabilityFault::kChanged:
            return "changed";
        case StabilityFault::kSelfHit:
            return "self-hit";
    }
    return "?";
}

std::string precision_of(const ObjectStability& object) {
    if (object.hits == 0) return "-";
    // More than a million is plenty, however many.
    return object.least_ulps < 1e6 ? fmt::format("{:.3g}", object.least_ulps) : "> 1e+06";
}

std::string counted(std::uint64_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string table(const StabilityReport& report, Positions& positions) {
    const auto& objects = report.stability.objects;
    std::string text = fmt::format("{:>7} {:>7} {:>7} {:>8} {:>10} {:>11}  {}\n", "rays", "hits",
                                   "cracks", "changed", "self-hits", "ulps/pixel", "object");
    std::size_t shown = 0;
    for (const ObjectStability& entry : objects) {
        if (shown >= kEnough && entry.faults() == 0) break;
        ++shown;
        const ir::Object& object = report.scene.objects[entry.object.value];
        text += fmt::format("{:>7} {:>7} {:>7} {:>8} {:>10} {:>11}  {}\n", entry.rays, entry.hits,
                            entry.cracks, entry.changed, entry.self_hits, precision_of(entry),
                            named(block_name(object.kind), object.label, object.span, positions));
        if (!entry.example) continue;
        const math::Vec3d p = entry.example->position;
        const std::string face =
            place_of(face_span(report.scene, object, entry.example->face), positions);
        text += fmt::format("{:8}first {} at {:.9g} {:.9g} {:.9g}{}{}\n", "",
                            name_of(entry.example->fault), p.x, p.y, p.z,
                            face.empty() ? "" : ", face ", face);
    }
    if (shown < objects.size()) {
        text += fmt::format("and {} with no more to say (--json has all)\n",
                            counted(objects.size() - shown, "object"));
    }
    return text;
}

std::string summary(const StabilityReport& report) {
    const auto& objects = report.stability.objects;
    std::uint64_t cracks = 0;
    std::uint64_t changed = 0;
    std::uint64_t self_hits = 0;
    std::uint64_t few = 0;
    std::uint64_t unseen = 0;
    for (const ObjectStability& object : objects) {
        cracks += object.cracks;
        changed += object.changed;
        self_hits += object.self_hits;
        few += object.least_ulps < renderer::kFewUlps ? 1 : 0;
        unseen += object.hits == 0 ? 1 : 0;
    }
    std::string text = fmt::format("{}: {}, {}x{}: {}, {}, {}\n", printable(report.path),
                                   counted(report.stability.rays, "ray"), report.width,
                                   report.height, counted(cracks, "crack"),
                                   counted(changed, "changed hit"), counted(self_hits, "self-hit"));
    if (few > 0) {
        text += fmt::format(
            "{} with pixels of less than {} ulps of float: it has too few digits "
            "there; --precision double has more\n",
            counted(few, "object"), renderer::kFewUlps);
    }
    if (unseen > 0) {
        text += fmt::format("{} that no ray hit: hidden from the camera, or not there in float\n",
                            counted(unseen, "object"));
    }
    return text;
}

}  // namespace

std::string stability_to_text(const StabilityReport& report) {
    Positions positions(report.sources);
    return table(report, positions) +
           notes_to_text(report.stability.notes, report.scene, positions, "float") +
           summary(report);
}

std::string stability_to_json(const StabilityReport& report) {
    Positions positions(report.sources);
    Json objects = Json::array();
    for (const ObjectStability& entry : report.stability.objects) {
        Json json = {{"object", object_json(report.scene, entry.object, positions)},
                     {"rays", entry.rays},
                     {"hits", entry.hits},
                     {"cracks", entry.cracks},
                     {"changed", entry.changed},
                     {"self_hits", entry.self_hits},
                     {"least_ulps_per_pixel", nullptr}};
        if (entry.hits > 0) json["least_ulps_per_pixel"] = entry.least_ulps;
        if (entry.example) {
            const math::Vec3d p = entry.example->position;
            Json first = {{"kind", name_of(entry.example->fault)},
                          {"position", Json::array({p.x, p.y, p.z})}};
            const source::Span face = face_span(
                report.scene, report.scene.objects[entry.object.value], entry.example->face);
            if (face.valid()) {
                first["face"] = {{"index", entry.example->face},
                                 {"at", place_json(face, positions)}};
            }
            json["first_fault"] = std::move(first);
        }
        objects.push_back(std::move(json));
    }
    Json notes = notes_to_json(report.stability.notes, report.scene, positions, "float");
    const Json json = {
        {"cobble_stability", 1},         {"size", Json::array({report.width, report.height})},
        {"rays", report.stability.rays}, {"clean", report.stability.clean()},
        {"objects", std::move(objects)}, {"notes", std::move(notes)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cobble::driver
