// SPDX-License-Identifier: MIT
#include "ir/lower/loss.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cobble::ir {
namespace {

const source::DiagnosticCode kPrecisionLoss{
    "precision-loss",
    source::Severity::kWarning,
    "float cannot resolve an object where it stands",
    "Scenes are rendered in float, of 24 binary digits, after the coordinates are made relative to "
    "a point near the camera. That helps what stands near the camera, however far from zero it "
    "is, but not what stands far from the camera: a million away from that point neighbouring "
    "floats are 0.0625 apart. What is smaller than a few such steps loses its shape or is not "
    "there at all, and where a pixel is smaller than one, as through a long lens, outlines, "
    "shading and shadows go in steps. How wide a pixel is depends on the picture's height: `lint` "
    "reckons with 640x480, `render` with its `--size`. Beyond 1.3e36 float cannot reckon.",
    "PerspectiveCamera {\n    center 0 0 5\n    direction 0 0 -1\n    up 0 1 0\n    angle 40\n}\n"
    "Materials {\n    Material { diffuseColor 0.8 0.2 0.1 }\n}\n"
    "Group {\n    MaterialIndex 0\n    Sphere {\n        center 0 0 0\n        radius 1\n    }\n"
    "    Triangle {\n        vertex0 1000000.3 0 0\n        vertex1 1000000.301 0 0\n"
    "        vertex2 1000000.3 1 0\n    }\n}\n",
    "Render with `--precision double`, whose steps are half a billion times smaller, or bring the "
    "camera and what it sees closer to each other."};

std::string number(double x) { return fmt::format("{:.3g}", x); }

std::string what_is_kept(const Feature& feature) {
    if (feature.lost() >= 1) {
        return fmt::format("float moves it by up to {}: it keeps nothing of this width",
                           number(feature.moved));
    }
    return fmt::format("float moves it by up to {}: it keeps {:.0f} % of this width",
                       number(feature.moved), std::floor(100 * (1 - feature.lost())));
}

/// Doubles hold a scene's numbers as they are, and are as far apart as they are where these
/// are local: how far from zero the scene is does not matter to them either.
void add_mend(source::Diagnostic& finding, double width, double reach,
              std::string_view otherwise = "bring the camera and what it sees closer together") {
    const double step = math::step_at<double>(reach);
    finding.notes.push_back(
        width >= step / kLostShare
            ? fmt::format("'--precision double' resolves it: neighbouring doubles are {} apart",
                          number(step))
            : fmt::format("doubles, {} apart, do not resolve it either: {}", number(step),
                          otherwise));
}

}  // namespace

source::Diagnostic LossWords::describe(const Object& object, const Loss& loss) {
    source::Diagnostic finding;
    finding.code = &kPrecisionLoss;
    finding.severity = kPrecisionLoss.severity;
    const std::string_view name = block_name(object.kind);
    finding.span = object.span;
    finding.span.end =
        std::min(finding.span.end, finding.span.begin + static_cast<std::uint32_t>(name.size()));
    if (loss.out_of_range) {
        finding.message =
            fmt::format("the {} reaches {}, and float reckons with numbers up to {} only", name,
                        number(loss.reach), number(double{math::kLargestCoordinate<float>}));
        finding.notes.emplace_back("no ray hits it; '--precision double' renders it");
        return finding;
    }
    const double reach = loss.feature ? loss.feature->reach
                         : loss.place ? loss.place->reach
                                      : loss.flat->reach;
    const bool at_camera = !loss.feature && loss.place && loss.place->at_camera;
    const bool in_own_space = !loss.feature && !loss.place && object.placement.count > 0;
    const std::string steps = fmt::format(
        "and floats are {} apart {}, {} from {}", number(double{math::step_at<float>(reach)}),
        at_camera ? "at the camera" : "there", number(reach),
        in_own_space ? "the middle of the mesh" : "the local origin");
    if (loss.feature) {
        const bool many = object.kind == ShapeKind::kMesh;
        finding.message = fmt::format("{} {} is {} wide, {}", many ? "a face of the" : "the", name,
                                      number(loss.feature->width), steps);
        finding.notes.push_back(what_is_kept(*loss.feature));
        if (many) {
            finding.notes.push_back(fmt::format("so it goes for {} of {} faces looked at",
                                                loss.lost_faces, loss.faces));
        }
        add_mend(finding, loss.feature->width, reach);
    } else if (!loss.place) {
        finding.message =
            fmt::format("{} of {} triangles of the {} {} flat in float: the widest is {} wide, {}",
                        loss.flat_faces, loss.faces, name, loss.flat_faces == 1 ? "is" : "are",
                        number(loss.flat->width), steps);
        finding.notes.emplace_back("no ray hits what is flat");
        add_mend(finding, loss.flat->width, reach,
                 "merge vertices that lie as close as that in a modelling program");
        const Mesh& mesh = scene_->meshes[object.shape];
        if (mesh.source.valid()) {
            finding.related.push_back(
                {{mesh.source, loss.flat_at, loss.flat_at + 1}, "the first is of this face"});
        }
    } else {
        finding.message = fmt::format("at {}x{} a pixel of the {} is {} wide, {}", size_.width,
                                      size_.height, name, number(loss.place->pixel), steps);
        finding.notes.emplace_back(
            "points of neighbouring pixels are one: its outline, shading and shadows go in "
            "steps");
        add_mend(finding, loss.place->pixel, reach);
    }
    if (loss.flat_faces > 0 && (loss.feature || loss.place)) {
        finding.notes.push_back(
            fmt::format("{} of {} triangles looked at are flat in float: never hit",
                        loss.flat_faces, loss.faces));
    }
    if (!origin_told_) {
        finding.notes.push_back(
            fmt::format("the local origin, which coordinates are made relative to, is {} {} "
                        "{}, {} from the camera",
                        number(origin_.x), number(origin_.y), number(origin_.z),
                        number(largest(scene_->camera.center - origin_))));
    }
    origin_told_ = true;
    return finding;
}

}  // namespace cobble::ir
