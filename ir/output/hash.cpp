// SPDX-License-Identifier: MIT
#include "ir/hash.hpp"

#include <bit>
#include <map>

#include "ir/output/sha256.hpp"

namespace cobble::ir {
namespace {

// Everything is written little-endian, numbers as the 8 bytes of a double, lists behind their
// length. Materials and cube maps are numbered in the order in which objects use them.
class Encoder {
  public:
    explicit Encoder(const Scene& scene) : scene_(scene) {}

    std::string run() {
        text("cobble-ir-1");
        integer(static_cast<std::uint64_t>(scene_.compat));
        number_materials();
        camera();
        lights();
        vector(scene_.background.color);
        vector(scene_.background.ambient);
        cube_map(scene_.background.cube_map);
        integer(order_.size());
        for (const MaterialId id : order_) material(scene_.materials[id.value]);
        integer(scene_.objects.size());
        for (const Object& o : scene_.objects) object(o);
        flush();
        return to_hex(sha_.finish());
    }

  private:
    void raw(std::uint64_t value) {
        if (size_ + 8 > buffer_.size()) flush();
        for (std::size_t i = 0; i < 8; ++i) {
            buffer_[size_++] = static_cast<std::uint8_t>(value >> (8 * i));
        }
    }
    void flush() {
        sha_.add(buffer_.data(), size_);
        size_ = 0;
    }
    void integer(std::uint64_t value) { raw(value); }
    /// -0 becomes 0.
    void number(double value) { raw(std::bit_cast<std::uint64_t>(value + 0.0)); }
    void vector(math::Vec3d v) {
        number(v.x);
        number(v.y);
        number(v.z);
    }
    void text(std::string_view value) {
        integer(value.size());
        flush();
        sha_.add(value.data(), value.size());
    }
    void digest(const Sha256::Digest& value) {
        flush();
        sha_.add(value.data(), value.size());
    }

    void number_materials() {
        numbers_.assign(scene_.materials.size(), 0);
        std::vector<bool> seen(scene_.materials.size(), false);
        for (const Object& o : scene_.objects) {
            if (seen[o.material.value]) continue;
            seen[o.material.value] = true;
            numbers_[o.material.value] = order_.size();
            order_.push_back(o.material);
        }
    }

    [[nodiscard]] bool anything_moves() const {
        for (const Object& o : scene_.objects) {
            if (o.placement.count > 1) return true;
            if (o.placement.count > 0) continue;
            if (o.kind == ShapeKind::kSphere && scene_.spheres[o.shape].keys.size() > 1)
                return true;
            if (o.kind == ShapeKind::kTriangle && scene_.triangles[o.shape].keys.size() > 1) {
                return true;
            }
        }
        return false;
    }

    void camera() {
        const Camera& c = scene_.camera;
        vector(c.center);
        vector(c.forward);
        vector(c.up);
        // Only the edition of 2016 looks at it.
        if (scene_.compat == Compat::kFa2016) vector(c.up_as_written);
        number(c.angle);
        number(c.aperture);
        if (c.aperture > 0) {
            number(c.focus_distance);
            integer(c.blades);
        }
        // When the shutter opens matters only to what moves.
        const bool moving = anything_moves();
        number(moving ? c.shutter_open : 0);
        number(moving ? c.shutter_close : 0);
    }

    void lights() {
        integer(scene_.lights.size());
        for (const Light& light : scene_.lights) {
            integer(static_cast<std::uint64_t>(light.kind));
            vector(light.color);
            if (light.kind == Light::Kind::kPoint) {
                vector(light.position);
                number(light.falloff);
                number(light.radius);
            } else {
                vector(light.direction);
                number(light.angle);
            }
        }
    }

    void image(ImageId id, bool data) {
        integer(id.valid() ? 1 : 0);
        if (!id.valid()) return;
        const auto known = images_.find({id.value, data});
        if (known != images_.end()) return digest(known->second);
        const Image& picture = scene_.images[id.value];
        Sha256 sha;
        const auto add = [&](std::uint64_t value) {
            std::array<std::uint8_t, 8> bytes;
            for (std::size_t i = 0; i < 8; ++i) {
                bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
            }
            sha.add(bytes.data(), bytes.size());
        };
        add(picture.width);
        add(picture.height);
        // By its use, not its tag: one picture may be both.
        const ColorTag colour = picture.floats.empty() ? ColorTag::kDisplay : ColorTag::kLinear;
        add(static_cast<std::uint64_t>(data ? ColorTag::kData : colour));
        add(picture.bytes.empty() ? 0 : 1);
        sha.add(picture.bytes.data(), picture.bytes.size());
        for (const float value : picture.floats) {
            add(std::bit_cast<std::uint32_t>(value + 0.0F));
        }
        digest(images_[{id.value, data}] = sha.finish());
    }

    void cube_map(CubeMapId id) {
        integer(id.valid() ? 1 : 0);
        if (!id.valid()) return;
        for (const ImageId face : scene_.cube_maps[id.value].faces) image(face, false);
    }

    void material(const Material& m) {
        vector(m.diffuse);
        vector(m.specular);
        number(m.shininess);
        number(m.refraction_index);
        image(m.texture, false);
        image(m.normal_map, true);
        image(m.bump_map, true);
        cube_map(m.cube_map);
        // How pictures are read matters only where there are some; a cube map has no scale.
        const bool pictures = m.texture.valid() || m.normal_map.valid() || m.bump_map.valid();
        if (pictures || m.cube_map.valid()) {
            integer(static_cast<std::uint64_t>(m.texture_filter));
        }
        if (pictures) {
            number(m.texture_scale.x);
            number(m.texture_scale.y);
        }
        integer(m.has_noise ? 1 : 0);
        if (m.has_noise) {
            vector(m.noise.color1);
            vector(m.noise.color2);
            integer(m.noise.octaves);
            number(m.noise.frequency);
            number(m.noise.amplitude);
        }
        integer(m.substituted ? 1 : 0);
    }

    void object(const Object& o) {
        integer(static_cast<std::uint64_t>(o.kind));
        integer(numbers_[o.material.value]);
        integer(o.placement.count);
        for (std::uint32_t k = 0; k < o.placement.count; ++k) {
            // The way back follows from the way there.
            for (const auto& row : scene_.placements[o.placement.first + k].object_to_world.rows) {
                for (const double entry : row) number(entry);
            }
        }
        switch (o.kind) {
            case ShapeKind::kSphere:
                return sphere(scene_.spheres[o.shape]);
            case ShapeKind::kPlane:
                return plane(scene_.planes[o.shape]);
            case ShapeKind::kTriangle:
                return triangle(scene_.triangles[o.shape]);
            case ShapeKind::kBox:
                vector(scene_.boxes[o.shape].min);
                return vector(scene_.boxes[o.shape].max);
            case ShapeKind::kMesh:
                return mesh(o.shape);
        }
    }

    void sphere(const Sphere& s) {
        integer(s.keys.size());
        for (const auto& key : s.keys) {
            vector(key.center);
            number(key.radius);
        }
    }

    void plane(const Plane& p) {
        vector(p.normal);
        number(p.offset);
        vector(p.u_axis);
        vector(p.v_axis);
        number(p.u_offset);
        number(p.v_offset);
    }

    void triangle(const Triangle& t) {
        integer(t.keys.size());
        for (const auto& key : t.keys) {
            for (const math::Vec3d& corner : key) vector(corner);
        }
    }

    /// By what it looks like: corners by value, so that unused or doubled vertices do not count.
    void mesh(std::uint32_t index) {
        const auto known = meshes_.find(index);
        if (known != meshes_.end()) return digest(known->second);
        const Mesh& m = scene_.meshes[index];
        Encoder part(scene_);
        part.integer(m.faces.size());
        for (const auto& face : m.faces) {
            for (const auto& corner : face.corners) {
                part.vector(m.positions[corner.position]);
                part.integer((corner.normal != Mesh::kNone ? 1U : 0U) |
                             (corner.uv != Mesh::kNone ? 2U : 0U));
                if (corner.normal != Mesh::kNone) part.vector(m.normals[corner.normal]);
                if (corner.uv != Mesh::kNone) {
                    part.number(m.uvs[corner.uv].x);
                    part.number(m.uvs[corner.uv].y);
                }
            }
        }
        part.flush();
        digest(meshes_[index] = part.sha_.finish());
    }

    const Scene& scene_;
    Sha256 sha_;
    std::array<std::uint8_t, 4096> buffer_{};
    std::size_t size_ = 0;
    std::vector<std::size_t> numbers_;  ///< per material, for those in use
    std::vector<MaterialId> order_;
    std::map<std::pair<std::uint32_t, bool>, Sha256::Digest> images_;  ///< by id, is data
    std::map<std::uint32_t, Sha256::Digest> meshes_;
};

}  // namespace

std::string hash(const Scene& scene) { return Encoder(scene).run(); }

}  // namespace cobble::ir
