// SPDX-License-Identifier: MIT
#include "ir/json.hpp"

#include <nlohmann/json.hpp>

namespace cobble::ir {
namespace {

using Json = nlohmann::ordered_json;

Json vector(math::Vec3d v) { return {v.x, v.y, v.z}; }
Json vector(math::Vec2d v) { return {v.x, v.y}; }

template <typename Tag>
Json index(Id<Tag> id) {
    return id.valid() ? Json(id.value) : Json(nullptr);
}

/// Sixteen numbers, column by column.
Json matrix(const math::Affined& map) {
    Json result = Json::array();
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 3; ++i) result.push_back(map.rows[i][j]);
        result.push_back(j == 3 ? 1.0 : 0.0);
    }
    return result;
}

constexpr const char* kCompatNames[] = {"none", "a4", "a5", "fa2016", "project"};
constexpr const char* kKindNames[] = {"sphere", "plane", "triangle", "box", "mesh"};
constexpr const char* kTagNames[] = {"display", "linear", "data"};

// Writes the top level by hand, one record at a time, so that the tree of a big scene is never in
// memory as a whole.
class Writer {
  public:
    Writer(const Scene& scene, const source::SourceMap& sources)
        : scene_(scene), sources_(sources) {}

    std::string run() {
        out_ = "{\n  \"cobble_ir\": 1";
        field("compat", kCompatNames[static_cast<std::size_t>(scene_.compat)]);
        field("source", scene_.source.valid() ? Json(sources_.path(scene_.source)) : Json(nullptr));
        field("camera", camera());
        field("background", background());
        list("lights", scene_.lights, [this](const Light& x) { return light(x); });
        list("materials", scene_.materials, [this](const Material& x) { return material(x); });
        list("objects", scene_.objects, [this](const Object& x) { return object(x); });
        list("spheres", scene_.spheres, [](const Sphere& x) { return sphere(x); });
        list("planes", scene_.planes, [](const Plane& x) { return plane(x); });
        list("triangles", scene_.triangles, [](const Triangle& x) { return triangle(x); });
        list("boxes", scene_.boxes, [](const Box& x) {
            return Json{{"min", vector(x.min)}, {"max", vector(x.max)}};
        });
        list("meshes", scene_.meshes, [](const Mesh& x) { return mesh(x); });
        list("placements", scene_.placements, [](const Placement& x) {
            return Json{{"object_to_world", matrix(x.object_to_world)},
                        {"world_to_object", matrix(x.world_to_object)}};
        });
        list("images", scene_.images, [](const Image& x) { return image(x); });
        list("cube_maps", scene_.cube_maps, [this](const CubeMap& x) { return cube_map(x); });
        field("motion_chord_error", scene_.motion_chord_error);
        out_ += "\n}\n";
        return std::move(out_);
    }

  private:
    // Bytes that are no UTF-8 (in a path) are shown as U+FFFD, as everywhere.
    static std::string dump(const Json& json) {
        return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    void field(const char* name, const Json& value) {
        out_ += ",\n  \"";
        out_ += name;
        out_ += "\": ";
        out_ += dump(value);
    }
    template <typename T, typename Write>
    void list(const char* name, const std::vector<T>& items, Write&& write) {
        out_ += ",\n  \"";
        out_ += name;
        out_ += "\": [";
        for (std::size_t i = 0; i < items.size(); ++i) {
            out_ += i == 0 ? "\n    " : ",\n    ";
            out_ += dump(write(items[i]));
        }
        out_ += items.empty() ? "]" : "\n  ]";
    }

    [[nodiscard]] Json span(source::Span s) const {
        if (!s.valid()) return nullptr;
        return {{"source", sources_.path(s.source)}, {"begin", s.begin}, {"end", s.end}};
    }
    void add_place(Json& json, const std::string& label, source::Span s) const {
        if (!label.empty()) json["label"] = label;
        json["span"] = span(s);
    }

    [[nodiscard]] Json camera() const {
        const Camera& c = scene_.camera;
        Json json{{"center", vector(c.center)},
                  {"forward", vector(c.forward)},
                  {"up", vector(c.up)},
                  {"right", vector(c.right)},
                  {"up_as_written", vector(c.up_as_written)},
                  {"angle", c.angle},
                  {"aperture", c.aperture},
                  {"focus_distance", c.focus_distance},
                  {"blades", c.blades},
                  {"shutter_open", c.shutter_open},
                  {"shutter_close", c.shutter_close}};
        add_place(json, c.label, c.span);
        return json;
    }

    [[nodiscard]] Json background() const {
        const Background& b = scene_.background;
        return {{"color", vector(b.color)},
                {"ambient", vector(b.ambient)},
                {"cube_map", index(b.cube_map)},
                {"span", span(b.span)}};
    }

    [[nodiscard]] Json light(const Light& l) const {
        Json json;
        if (l.kind == Light::Kind::kPoint) {
            json = {{"kind", "point"},
                    {"position", vector(l.position)},
                    {"color", vector(l.color)},
                    {"falloff", l.falloff},
                    {"radius", l.radius}};
        } else {
            json = {{"kind", "directional"},
                    {"direction", vector(l.direction)},
                    {"color", vector(l.color)},
                    {"angle", l.angle}};
        }
        add_place(json, l.label, l.span);
        return json;
    }

    [[nodiscard]] Json material(const Material& m) const {
        Json json{{"diffuse", vector(m.diffuse)},
                  {"specular", vector(m.specular)},
                  {"shininess", m.shininess},
                  {"refraction_index", m.refraction_index},
                  {"texture", index(m.texture)},
                  {"folded_texture", index(m.folded_texture)},
                  {"normal_map", index(m.normal_map)},
                  {"bump_map", index(m.bump_map)},
                  {"cube_map", index(m.cube_map)},
                  {"texture_filter",
                   m.texture_filter == TextureFilter::kNearest ? "nearest" : "bilinear"},
                  {"texture_scale", vector(m.texture_scale)}};
        json["noise"] = nullptr;
        if (m.has_noise) {
            json["noise"] = {{"color1", vector(m.noise.color1)},
                             {"color2", vector(m.noise.color2)},
                             {"octaves", m.noise.octaves},
                             {"frequency", m.noise.frequency},
                             {"amplitude", m.noise.amplitude}};
        }
        if (m.substituted) json["substituted"] = true;
        add_place(json, m.label, m.span);
        return json;
    }

    [[nodiscard]] Json object(const Object& o) const {
        Json json{{"kind", kKindNames[static_cast<std::size_t>(o.kind)]},
                  {"shape", o.shape},
                  {"material", index(o.material)}};
        json["placement"] = nullptr;
        if (o.placement.count > 0) {
            json["placement"] = {{"first", o.placement.first}, {"count", o.placement.count}};
        }
        add_place(json, o.label, o.span);
        return json;
    }

    static Json sphere(const Sphere& s) {
        Json keys = Json::array();
        for (const auto& key : s.keys) {
            keys.push_back({{"center", vector(key.center)}, {"radius", key.radius}});
        }
        return {{"keys", std::move(keys)}};
    }
    static Json plane(const Plane& p) {
        return {{"normal", vector(p.normal)}, {"offset", p.offset},
                {"u_axis", vector(p.u_axis)}, {"u_offset", p.u_offset},
                {"v_axis", vector(p.v_axis)}, {"v_offset", p.v_offset}};
    }
    static Json triangle(const Triangle& t) {
        Json keys = Json::array();
        for (const auto& key : t.keys) {
            keys.push_back(Json::array({vector(key[0]), vector(key[1]), vector(key[2])}));
        }
        return {{"keys", std::move(keys)}};
    }
    static Json mesh(const Mesh& m) {
        return {{"path", m.path},
                {"positions", m.positions.size()},
                {"normals", m.normals.size()},
                {"uvs", m.uvs.size()},
                {"faces", m.faces.size()}};
    }
    static Json image(const Image& i) {
        Json json{{"path", i.path},
                  {"width", i.width},
                  {"height", i.height},
                  {"tag", kTagNames[static_cast<std::size_t>(i.tag)]}};
        if (i.missing) json["missing"] = true;
        return json;
    }
    [[nodiscard]] Json cube_map(const CubeMap& c) const {
        Json faces;
        constexpr const char* kNames[] = {"left", "right", "up", "down", "front", "back"};
        for (std::size_t f = 0; f < 6; ++f) faces[kNames[f]] = index(c.faces[f]);
        return {{"faces", std::move(faces)}, {"span", span(c.span)}};
    }

    const Scene& scene_;
    const source::SourceMap& sources_;
    std::string out_;
};

}  // namespace

std::string to_json(const Scene& scene, const source::SourceMap& sources) {
    return Writer(scene, sources).run();
}

}  // namespace cobble::ir
