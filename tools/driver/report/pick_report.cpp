// SPDX-License-Identifier: MIT
#include "tools/driver/report/pick_report.hpp"

#include <fmt/core.h>

#include <string_view>
#include <utility>
#include <vector>

#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/object_words.hpp"

namespace cobble::driver {
namespace {

using renderer::PickNode;

std::string_view name_of(PickNode::Kind kind) {
    switch (kind) {
        case PickNode::Kind::kCamera:
            return "camera";
        case PickNode::Kind::kReflected:
            return "reflected";
        case PickNode::Kind::kRefracted:
            return "refracted";
    }
    return "?";
}

std::string_view name_of(ir::Light::Kind kind) {
    return kind == ir::Light::Kind::kPoint ? "PointLight" : "DirectionalLight";
}

std::string numbers(const math::Vec3d& v) {
    return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
}

Json vector_json(const math::Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

class Writer {
  public:
    explicit Writer(const PickReport& report) : report_(report), positions_(report.sources) {}

    std::string text() {
        std::string text = fmt::format("pixel {},{}\n", report_.x, report_.y);
        struct Open {
            std::uint32_t node;
            std::size_t depth;
        };
        std::vector<Open> open{{0, 0}};
        std::uint64_t count = 0;
        while (!open.empty()) {
            const Open at = open.back();
            open.pop_back();
            const PickNode& node = report_.tree.nodes[at.node];
            text += node_text(node, std::string(2 * at.depth, ' '));
            ++count;
            if (!report_.whole_tree) break;
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                if (is_shown(*child)) open.push_back({*child, at.depth + 1});
            }
        }
        if (report_.whole_tree && count < report_.tree.rays) {
            text += fmt::format("... {} rays more\n", report_.tree.rays - count);
        }
        const std::string incomplete = incomplete_text(report_.tree);
        if (!incomplete.empty()) text += incomplete + "\n";
        return text;
    }

    std::string json() {
        // Children stand after their parents: built from the back, each is whole when it is needed.
        const auto& nodes = report_.tree.nodes;
        std::vector<Json> done(nodes.size());
        const std::size_t count = report_.whole_tree ? nodes.size() : 1;
        std::uint64_t shown = 0;
        for (std::uint32_t i = static_cast<std::uint32_t>(count); i-- > 0;) {
            if (!is_shown(i)) continue;
            ++shown;
            done[i] = node_json(nodes[i]);
            if (!report_.whole_tree) continue;
            Json rays = Json::array();
            for (const std::uint32_t child : nodes[i].children) {
                if (is_shown(child)) rays.push_back(std::move(done[child]));
            }
            done[i]["rays"] = std::move(rays);
        }
        Json json = {{"cobble_pick", 1},
                     {"pixel", Json::array({report_.x, report_.y})},
                     {"complete", report_.tree.complete}};
        if (report_.whole_tree) json["rays_left_out"] = report_.tree.rays - shown;
        json["ray"] = std::move(done[0]);
        return pretty(json);
    }

  private:
    // A shown ray's parent is shown too: it comes before it and is less deep.
    [[nodiscard]] bool is_shown(std::uint32_t node) const {
        return node < kMostShownRays && report_.tree.nodes[node].depth <= kMostShownDepth;
    }

    std::string node_text(const PickNode& node, const std::string& indent) {
        std::string text;
        const auto line = [&text, &indent](std::string_view name, const std::string& value) {
            text += fmt::format("{}{:<10} {}\n", indent, name, value);
        };
        text += fmt::format("{}{} ray\n", indent, name_of(node.kind));
        line("  from", numbers(node.origin));
        line("  towards", numbers(node.direction));
        if (!node.hit) {
            line("  hits", "nothing: the background");
            line("  color", numbers(node.color));
            return text;
        }
        const ir::Object& object = report_.scene.objects[node.object.value];
        line("  object", named(block_name(object.kind), object.label, object.span, positions_));
        if (const source::Span face = face_span(report_.scene, object, node.face); face.valid()) {
            line("  face", fmt::format("{}  {}", node.face, place_of(face, positions_)));
        }
        if (node.material.valid()) {
            const ir::Material& material = report_.scene.materials[node.material.value];
            line("  material", named(std::to_string(node.material.value), material.label,
                                     material.span, positions_));
        }
        line("  position", numbers(node.position));
        line("  normal", numbers(node.normal));
        line("  depth", fmt::format("{:.9g}", node.t));
        for (const PickNode::LightSeen& seen : node.lights) {
            const ir::Light& light = report_.scene.lights[seen.light.value];
            line("  light",
                 fmt::format("{}  {}, gives {}",
                             named(name_of(light.kind), light.label, light.span, positions_),
                             seen.visible ? "visible" : "hidden", numbers(seen.contribution)));
        }
        line("  color", numbers(node.color));
        return text;
    }

    Json node_json(const PickNode& node) {
        Json json = {{"kind", name_of(node.kind)},
                     {"origin", vector_json(node.origin)},
                     {"direction", vector_json(node.direction)},
                     {"hit", node.hit},
                     {"color", vector_json(node.color)}};
        if (!node.hit) return json;
        const ir::Object& object = report_.scene.objects[node.object.value];
        json["object"] = object_json(report_.scene, node.object, positions_);
        const source::Span face = face_span(report_.scene, object, node.face);
        if (face.valid())
            json["face"] = {{"index", node.face}, {"at", place_json(face, positions_)}};
        if (node.material.valid()) {
            const ir::Material& material = report_.scene.materials[node.material.value];
            json["material"] = {{"index", node.material.value},
                                {"label", material.label},
                                {"at", place_json(material.span, positions_)}};
        }
        json["position"] = vector_json(node.position);
        json["normal"] = vector_json(node.normal);
        json["geometric_normal"] = vector_json(node.geometric_normal);
        json["depth"] = node.t;
        Json lights = Json::array();
        for (const PickNode::LightSeen& seen : node.lights) {
            const ir::Light& light = report_.scene.lights[seen.light.value];
            lights.push_back({{"index", seen.light.value},
                              {"kind", name_of(light.kind)},
                              {"label", light.label},
                              {"at", place_json(light.span, positions_)},
                              {"visible", seen.visible},
                              {"contribution", vector_json(seen.contribution)}});
        }
        json["lights"] = std::move(lights);
        return json;
    }

    const PickReport& report_;
    Positions positions_;
};

}  // namespace

std::string incomplete_text(const renderer::PickTree& tree) {
    if (tree.complete) return {};
    return fmt::format("cut off after {} rays; the colour is incomplete", tree.rays);
}

std::string pick_to_text(const PickReport& report) { return Writer(report).text(); }

std::string pick_to_json(const PickReport& report) { return Writer(report).json(); }

}  // namespace cobble::driver
