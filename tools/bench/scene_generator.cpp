// SPDX-License-Identifier: MIT
#include "tools/bench/scene_generator.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace cobble::bench {
namespace {

constexpr int kMaterials = 64;
constexpr int kObjectsPerGroup = 200;

constexpr std::array<std::string_view, 8> kWords = {"stone", "glass",  "brass",  "leaf",
                                                    "water", "copper", "marble", "clay"};
constexpr std::array<std::string_view, 6> kNotes = {
    "// moved a little to the left, so that the lamp shows",
    "// the roof",
    "// measured from the photograph: 1 unit = 10 cm",
    "// still too dark?",
    "// keep in step with the mesh",
    "// second row from the door"};

/// Numerical Recipes' quick generator (32 bits, 1664525 and 1013904223): only variety is asked for.
class Random {
  public:
    std::uint32_t below(std::uint32_t count) {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<std::uint32_t>((std::uint64_t{state_} * count) >> 32U);
    }

  private:
    std::uint32_t state_ = 2012;
};

/// Writes a scene and its JSON in step.
class Generator {
  public:
    GeneratedScene run(std::size_t bytes) {
        preamble();
        std::string objects;
        std::string objects_json;
        int groups = 0;
        const std::string head = std::move(out_.scene);
        const std::string head_json = std::move(out_.json);
        while (groups == 0 || head.size() + objects.size() < bytes) {
            out_ = {};
            group();
            objects += out_.scene;
            if (groups > 0) objects_json += ',';
            objects_json += out_.json;
            ++groups;
        }
        out_.scene = fmt::format("{}Group {{\n    numObjects {}\n\n{}}}\n", head, groups, objects);
        out_.json = fmt::format(R"({}"Group":{{"numObjects":{},"children":[{}]}}}})", head_json,
                                groups, objects_json);
        return std::move(out_);
    }

  private:
    void scene(std::string_view text) { out_.scene += text; }
    void json(std::string_view text) { out_.json += text; }

    /// One number as a person, an exporter or a careless script writes it. `low` 1 makes it
    /// positive.
    std::string number(bool positive = false) {
        const std::uint32_t sort = random_.below(10);
        const std::uint32_t digits = random_.below(1'000'000) + 1;
        const bool minus = !positive && random_.below(3) == 0;
        std::string text;
        if (sort < 3) {
            text = fmt::format("{}", digits % 20 + 1);
        } else if (sort < 6) {
            text = fmt::format("{}.{}", digits % 10, digits / 10 % 99 + 1);
        } else if (sort < 9) {
            text = fmt::format("{}.{:06}", digits % 100, digits);
        } else {
            text = fmt::format("{}.{}e-{}", digits % 9 + 1, digits / 10 % 1000, random_.below(6));
        }
        return minus ? fmt::format("-{}", text) : text;
    }
    std::string negative() { return fmt::format("-{}", number(true)); }
    std::string unit_number() { return fmt::format("0.{}", random_.below(999) + 1); }

    void field(int indent, std::string_view name, std::initializer_list<std::string> values,
               bool last = false) {
        out_.scene.append(static_cast<std::size_t>(indent) * 4, ' ');
        scene(name);
        fmt::format_to(std::back_inserter(out_.json), R"("{}":)", name);
        if (values.size() > 1) json("[");
        bool first = true;
        for (const std::string& value : values) {
            scene(" ");
            scene(value);
            if (!first) json(",");
            first = false;
            json(value);
        }
        if (values.size() > 1) json("]");
        if (!last) json(",");
        if (random_.below(30) == 0) {
            scene(" ");
            scene(kNotes[random_.below(kNotes.size())]);
        }
        scene("\n");
    }
    void vector(int indent, std::string_view name, bool last = false) {
        field(indent, name, {number(), number(), number()}, last);
    }
    void color(int indent, std::string_view name, bool last = false) {
        field(indent, name, {unit_number(), unit_number(), unit_number()}, last);
    }

    static std::string material_name(std::uint32_t index) {
        return fmt::format("{}_{}", kWords[index % kWords.size()], index);
    }

    void preamble() {
        scene("// A scene to measure with.\nPerspectiveCamera {\n");
        json(R"({"PerspectiveCamera":{)");
        field(1, "center", {"0", "0", "10"});
        field(1, "direction", {"0", "0", "-1"});
        field(1, "up", {"0", "1", "0"});
        field(1, "angle", {"30"}, true);
        scene("}\n\nLights {\n    numLights 1\n    DirectionalLight sun {\n");
        json(R"(},"Lights":{"numLights":1,"children":[{"type":"DirectionalLight","label":"sun",)");
        field(2, "direction", {"-0.5", "-0.5", "-0.7"});
        color(2, "color", true);
        scene("    }\n}\n\nBackground {\n");
        json("}]},\"Background\":{");
        color(1, "color");
        color(1, "ambientLight", true);
        scene("}\n\n");
        fmt::format_to(std::back_inserter(out_.scene), "Materials {{\n    numMaterials {}\n\n",
                       kMaterials);
        fmt::format_to(std::back_inserter(out_.json),
                       R"(}},"Materials":{{"numMaterials":{},"children":[)", kMaterials);
        for (std::uint32_t i = 0; i < kMaterials; ++i) {
            fmt::format_to(std::back_inserter(out_.scene), "    PhongMaterial {} {{\n",
                           material_name(i));
            fmt::format_to(std::back_inserter(out_.json),
                           R"({}{{"type":"PhongMaterial","label":"{}",)", i == 0 ? "" : ",",
                           material_name(i));
            color(2, "diffuseColor");
            color(2, "specularColor");
            field(2, "shininess", {number(true)}, true);
            scene("    }\n");
            json("}");
        }
        scene("}\n\n");
        json("]},");
    }

    void group() {
        fmt::format_to(std::back_inserter(out_.scene), "    Group {{\n        numObjects {}\n",
                       kObjectsPerGroup);
        fmt::format_to(std::back_inserter(out_.json),
                       R"({{"type":"Group","numObjects":{},"children":[)", kObjectsPerGroup);
        for (int i = 0; i < kObjectsPerGroup; ++i) {
            if (i > 0) json(",");
            if (i % 5 == 0) {
                const std::uint32_t material = next_material_++ % kMaterials;
                const std::string name = material_name(material);
                const bool label = random_.below(2) == 0;
                scene("\n        MaterialIndex ");
                const std::string value = label ? name : fmt::format("{}", material);
                scene(value);
                scene("\n");
                const char* quote = label ? "\"" : "";
                fmt::format_to(std::back_inserter(out_.json), R"({{"MaterialIndex":{0}{1}{0}}},)",
                               quote, value);
            }
            if (random_.below(12) == 0) {
                scene("        ");
                scene(kNotes[random_.below(kNotes.size())]);
                scene("\n");
            }
            object();
        }
        scene("    }\n\n");
        json("]}");
    }

    void open(int indent, std::string_view name) {
        out_.scene.append(static_cast<std::size_t>(indent) * 4, ' ');
        scene(name);
        fmt::format_to(std::back_inserter(out_.json), R"({{"type":"{}",)", name);
        if (random_.below(8) == 0) {
            const std::string label =
                fmt::format("{}{}", kWords[random_.below(kWords.size())], ++labels_);
            fmt::format_to(std::back_inserter(out_.scene), " {}_o", label);
            fmt::format_to(std::back_inserter(out_.json), R"("label":"{}_o",)", label);
        }
        scene(" {\n");
    }
    void close(int indent) {
        out_.scene.append(static_cast<std::size_t>(indent) * 4, ' ');
        scene("}\n");
        json("}");
    }

    void sphere(int indent) {
        open(indent, "Sphere");
        vector(indent + 1, "center");
        field(indent + 1, "radius", {number(true)}, true);
        close(indent);
    }

    void box(int indent) {
        open(indent, "Box");
        field(indent + 1, "min", {negative(), negative(), negative()});
        field(indent + 1, "max", {number(true), number(true), number(true)}, true);
        close(indent);
    }

    void triangle(int indent) {
        // Corners in three places that no choice of digits makes collinear.
        open(indent, "Triangle");
        field(indent + 1, "vertex0", {negative(), "0", "0"});
        field(indent + 1, "vertex1", {number(true), "0", "0.5"});
        field(indent + 1, "vertex2", {"0", number(true), number()}, true);
        close(indent);
    }

    void transform(int indent) {
        open(indent, "Transform");
        json(R"("children":[)");
        const std::string pad(static_cast<std::size_t>(indent + 1) * 4, ' ');
        const std::string x = number();
        const std::string y = number();
        const std::string z = number();
        fmt::format_to(std::back_inserter(out_.scene), "{}Translate {} {} {}\n", pad, x, y, z);
        fmt::format_to(std::back_inserter(out_.json), R"({{"Translate":[{},{},{}]}},)", x, y, z);
        const std::string degrees = number();
        if (random_.below(2) == 0) {
            fmt::format_to(std::back_inserter(out_.scene), "{}YRotate {}\n", pad, degrees);
            fmt::format_to(std::back_inserter(out_.json), R"({{"YRotate":{}}},)", degrees);
        } else {
            fmt::format_to(std::back_inserter(out_.scene), "{}Rotate {{ 0 1 1 {} }}\n", pad,
                           degrees);
            fmt::format_to(std::back_inserter(out_.json), R"({{"Rotate":[0,1,1,{}]}},)", degrees);
        }
        if (random_.below(2) == 0) {
            sphere(indent + 1);
        } else {
            box(indent + 1);
        }
        json("]");
        close(indent);
    }

    void object() {
        switch (random_.below(5)) {
            case 0:
            case 1:
                return sphere(2);
            case 2:
                return box(2);
            case 3:
                return triangle(2);
            default:
                return transform(2);
        }
    }

    GeneratedScene out_;
    Random random_;
    std::uint32_t next_material_ = 0;
    std::uint32_t labels_ = 0;
};

}  // namespace

GeneratedScene generate_scene(std::size_t bytes) { return Generator().run(bytes); }

}  // namespace cobble::bench
