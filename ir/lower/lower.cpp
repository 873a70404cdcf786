// SPDX-License-Identifier: MIT
#include "ir/lower.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "frontend/ast/views.hpp"
#include "ir/assets/asset_loader.hpp"
#include "ir/assets/mesh_findings.hpp"
#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/lower/fold.hpp"
#include "ir/lower/frames.hpp"
#include "ir/lower/materials.hpp"
#include "ir/lower/precision.hpp"
#include "ir/lower/shapes.hpp"

namespace cobble::ir {
namespace {

namespace field = frontend::field;
using frontend::BlockNodeId;
using frontend::BlockView;
using frontend::CheckedScene;
using grammar::BlockId;
using grammar::Role;
using source::DiagnosticCode;
using source::Severity;
using source::Span;

const DiagnosticCode kOutOfRange{
    "transform-out-of-range",
    Severity::kError,
    "nested transforms leave the range of numbers",
    "Each transform is fine by itself, but together they scale the object so far up or down that "
    "its place, or the way back from there, is no finite number. The object is left out.",
    "Transform {\n    UniformScale 1e200\n    Transform {\n        UniformScale 1e200\n"
    "        Sphere { center 0 0 0  radius 1 }\n    }\n}",
    "Choose world units in which the scene's sizes lie near 1."};

const DiagnosticCode kIllConditioned{
    "transform-ill-conditioned",
    Severity::kWarning,
    "a transform squeezes its object so hard that digits are lost",
    "Rays are taken into the object's own space by the inverse transform. If it stretches one "
    "direction more than a million times as much as another, single-precision hits there keep no "
    "correct digit.",
    "Transform {\n    Scale 1 0.0000001 1\n    Sphere { center 0 0 0  radius 1 }\n}",
    "Use a less extreme scale, or a flat object such as a Triangle or a Plane; `--precision "
    "double` "
    "bears half a billion times as much."};

const DiagnosticCode kTooFast{
    "motion-too-fast",
    Severity::kWarning,
    "a motion turns too often for its steps",
    "A motion is cut into at most 1024 straight steps (fewer in a scene with very many motions), "
    "of at most 15 degrees each where that suffices. Beyond, corners of the path are cut.",
    "Transform {\n    YRotate 0\n    Motion { YRotate 36000 }\n    Sphere { center 5 0 0  radius 1 "
    "}\n}",
    "Turn less during one exposure."};

// Double has 29 binary digits more.
constexpr double kWorstInDouble = kWorstCondition * 0x1p29;

class Lowering {
  public:
    Lowering(const CheckedScene& checked, source::SourceMap& sources, source::FileSource& files,
             const LowerOptions& options, bool keep)
        : checked_(checked),
          sources_(sources),
          options_(options),
          keep_(keep),
          assets_(checked.source, sources, files, options, keep),
          frames_(checked),
          shapes_(checked, frames_, lowered_.scene) {}

    Lowered run() {
        Scene& scene = lowered_.scene;
        scene.compat = options_.compat;
        scene.source = checked_.source;
        find_objects();
        load_assets();
        const auto camera = lower_camera(checked_);
        if (camera) scene.camera = *camera;
        lowered_.has_camera = camera.has_value();
        scene.lights = lower_lights(checked_, options_);
        scene.background = lower_background(checked_, options_, !scene.lights.empty());
        scene.background.cube_map = background_map_;
        add_materials();
        for (const BlockNodeId block : objects_) add_object(block);
        shapes_.finish();
        scene.images = assets_.take_images();
        scene.cube_maps = std::move(assets_.cube_maps());
        if (keep_) fold_constants(scene);
        lowered_.renderable = camera.has_value() && !scene.objects.empty();
        if (camera && !checked_.has_errors() && options_.judge_float) {
            for (source::Diagnostic& finding : precision_findings(scene, options_.size)) {
                const Span span = finding.span;
                assets_.report(std::move(finding), span);
            }
        }
        lowered_.diagnostics = assets_.take_diagnostics();
        return std::move(lowered_);
    }

  private:
    /// Objects that stand in the scene's Group, at any depth, in textual order.
    void find_objects() {
        const auto& blocks = checked_.ast.blocks;
        std::vector<bool> open(blocks.size(), false);  // children of this block are objects
        for (std::uint32_t i = 0; i < blocks.size(); ++i) {
            const auto& block = blocks[i];
            const Role role = grammar::row(block.row).role;
            const bool placed =
                block.parent.valid() ? open[block.parent.value] : role == Role::kGroup;
            if (!placed) continue;
            open[i] = role == Role::kGroup || role == Role::kTransform;
            if (role == Role::kObject && !block.broken) objects_.push_back({i});
        }
    }

    [[nodiscard]] Span value_span(BlockNodeId block, grammar::FieldId row) const {
        const auto* found = checked_.ast.find(block, row);
        const auto bytes = checked_.tokens.range(checked_.ast.values_of(*found)[0].token);
        return {checked_.source, bytes.begin, bytes.end};
    }

    template <typename Get>
    ImageId image(BlockNodeId block, grammar::FieldId row, Get&& get, ImageUse use) {
        const auto path = get(BlockView(checked_.tokens, checked_.ast, block));
        return path ? assets_.image(*path, value_span(block, row), use) : ImageId{};
    }
    template <typename Get>
    CubeMapId cube_map(BlockNodeId block, grammar::FieldId row, Get&& get) {
        const auto path = get(BlockView(checked_.tokens, checked_.ast, block));
        return path ? assets_.cube_map(*path, value_span(block, row)) : CubeMapId{};
    }

    /// Textures of unused materials are read too: a lint wants to know. In textual order, so that
    /// what a file is told stands at the first place that names it.
    void load_assets() {
        using grammar::FieldId;
        const auto& blocks = checked_.ast.blocks;
        for (std::uint32_t i = 0; i < blocks.size(); ++i) {
            if (blocks[i].broken) continue;
            const BlockNodeId id{i};
            if (blocks[i].row == BlockId::kBackground) {
                background_map_ =
                    cube_map(id, FieldId::kBackground_cubeMap, field::Background_cubeMap);
            } else if (blocks[i].row == BlockId::kMaterial) {
                material_assets_[i] = {
                    image(id, FieldId::kMaterial_texture, field::Material_texture,
                          ImageUse::kTexture),
                    image(id, FieldId::kMaterial_normal, field::Material_normal,
                          ImageUse::kNormalMap),
                    image(id, FieldId::kMaterial_bump, field::Material_bump, ImageUse::kBumpMap),
                    cube_map(id, FieldId::kMaterial_cubeMap, field::Material_cubeMap)};
            } else if (blocks[i].row == BlockId::kPhongMaterial) {
                material_assets_[i] = {
                    image(id, FieldId::kPhongMaterial_texture, field::PhongMaterial_texture,
                          ImageUse::kTexture),
                    image(id, FieldId::kPhongMaterial_normal, field::PhongMaterial_normal,
                          ImageUse::kNormalMap),
                    image(id, FieldId::kPhongMaterial_bump, field::PhongMaterial_bump,
                          ImageUse::kBumpMap),
                    cube_map(id, FieldId::kPhongMaterial_cubeMap, field::PhongMaterial_cubeMap)};
            } else if (blocks[i].row == BlockId::kTriangleMesh) {
                load_mesh(id);
            }
        }
        for (const BlockNodeId id : objects_) {
            const auto found = mesh_uses_.find(id.value);
            if (found == mesh_uses_.end()) continue;
            if (mesh_counts_[found->second]++ == 0) ++meshes_of_obj_[found->second.first];
        }
    }

    void load_mesh(BlockNodeId id) {
        const BlockView view(checked_.tokens, checked_.ast, id);
        const auto path = field::TriangleMesh_obj_file(view);
        if (!path) return;
        const Span span = value_span(id, grammar::FieldId::kTriangleMesh_obj_file);
        const std::size_t obj = assets_.obj(*path, span);
        const LoadedObj& loaded = assets_.objs()[obj];
        if (!loaded.usable) return;
        double crease = field::TriangleMesh_creaseAngle(view).value_or(60);
        // Where the angle is not asked, meshes that differ in it are one.
        if (normal_rule(loaded) != NormalRule::kCreaseAngle || has_normals(loaded)) crease = 0;
        if (!(crease >= 0 && crease <= 180)) crease = 60;
        mesh_uses_[id.value] = {obj, crease};
        if (under_normal_map(id) && judged_uvs_.insert(obj).second) {
            report_degenerate_uvs(assets_, loaded, sources_.text(loaded.source), span);
        }
    }

    [[nodiscard]] bool under_normal_map(BlockNodeId object) const {
        const std::uint32_t index = checked_.material_of_block[object.value];
        if (index == CheckedScene::kNoMaterial || index >= checked_.materials.size()) return false;
        const BlockNodeId material = checked_.materials[index];
        const auto has = [&](grammar::FieldId row) {
            return checked_.ast.find(material, row) != nullptr;
        };
        using grammar::FieldId;
        return has(FieldId::kMaterial_normal) || has(FieldId::kMaterial_bump) ||
               has(FieldId::kPhongMaterial_normal) || has(FieldId::kPhongMaterial_bump);
    }

    [[nodiscard]] bool has_normals(const LoadedObj& loaded) const {
        return options_.compat == Compat::kNone && !loaded.file.normals.empty() &&
               std::any_of(loaded.file.faces.begin(), loaded.file.faces.end(),
                           [](const auto& f) { return f.corners[0].normal != Mesh::kNone; });
    }

    [[nodiscard]] NormalRule normal_rule(const LoadedObj& loaded) const {
        // The tracers shade meshes of few vertices flat.
        constexpr std::size_t kFlatUpTo = 120;
        switch (options_.compat) {
            case Compat::kNone:
                return NormalRule::kCreaseAngle;
            case Compat::kFa2016:
                return NormalRule::kSumOfUnits;
            case Compat::kA4:
                return NormalRule::kSumOfCrosses;
            case Compat::kProject:
                if (options_.casting) return NormalRule::kSumOfCrosses;
                break;
            case Compat::kA5:
                break;
        }
        return loaded.file.positions.size() > kFlatUpTo ? NormalRule::kSumOfCrosses
                                                        : NormalRule::kFlat;
    }

    void add_materials() {
        for (const BlockNodeId block : checked_.materials) {
            const auto found = material_assets_.find(block.value);
            lowered_.scene.materials.push_back(lower_material(
                checked_, block, found == material_assets_.end() ? MaterialAssets{} : found->second,
                options_));
        }
    }

    /// The material of an object; a magenta checker where the file has none for it.
    MaterialId material_of(BlockNodeId object) {
        auto& materials = lowered_.scene.materials;
        const std::uint32_t index = checked_.material_of_block[object.value];
        if (index != CheckedScene::kNoMaterial && index < checked_.materials.size()) {
            return {index};
        }
        if (!substitute_.valid()) {
            substitute_ = {static_cast<std::uint32_t>(materials.size())};
            Material material;
            material.substituted = true;
            material.span = span_of(checked_, object);
            materials.push_back(std::move(material));
        }
        return substitute_;
    }

    void add_object(BlockNodeId block) {
        Scene& scene = lowered_.scene;
        Object object;
        object.material = material_of(block);
        object.label = label_of(checked_, block);
        object.span = span_of(checked_, block);
        const std::uint32_t frame = frames_.inside(block);
        const Material& material = scene.materials[object.material.value];
        const bool reads_uv = material.texture.valid() || material.normal_map.valid() ||
                              material.bump_map.valid() || material.substituted;
        bool good = false;
        if (checked_.ast.block(block).row == BlockId::kTriangleMesh) {
            const auto use = mesh_uses_.find(block.value);
            if (use == mesh_uses_.end()) return;  // said when it was read
            good = shapes_.placement(frame).has_value();
            good = good && shapes_.place_mesh(mesh_for(use->second), mesh_counts_[use->second] == 1,
                                              block, object);
        } else {
            good = shapes_.add(block, reads_uv, object);
        }
        report_frame(frame, good, object.span);
        if (good) scene.objects.push_back(std::move(object));
    }

    /// Builds the mesh at its first use; for a lint without normals.
    std::uint32_t mesh_for(const std::pair<std::size_t, double>& use) {
        const auto found = meshes_.find(use);
        if (found != meshes_.end()) return found->second;
        LoadedObj& loaded = assets_.objs()[use.first];
        const bool normals = has_normals(loaded);
        const NormalRule rule = normal_rule(loaded);
        ObjFile file = meshes_of_obj_[use.first] == 1 ? std::move(loaded.file) : loaded.file;
        Mesh mesh;
        mesh.positions = std::move(file.positions);
        mesh.uvs = std::move(file.uvs);
        mesh.faces = std::move(file.faces);
        mesh.face_offsets = std::move(file.face_offsets);
        mesh.path = loaded.path;
        mesh.source = loaded.source;
        if (keep_ && normals) {
            mesh.normals = std::move(file.normals);
            adopt_normals(mesh);
        } else if (keep_) {
            compute_normals(mesh, rule, use.second);
        }
        const auto index = static_cast<std::uint32_t>(lowered_.scene.meshes.size());
        lowered_.scene.meshes.push_back(std::move(mesh));
        return meshes_[use] = index;
    }

    void add_finding(const DiagnosticCode& code, const char* message, Span span,
                     const char* note = nullptr) {
        source::Diagnostic diagnostic;
        diagnostic.code = &code;
        diagnostic.severity = code.severity;
        diagnostic.message = message;
        diagnostic.span = span;
        if (note != nullptr) diagnostic.notes.emplace_back(note);
        assets_.report(std::move(diagnostic), span);
    }

    /// Once per frame; silent where the checker has found errors, of which this may be one.
    void report_frame(std::uint32_t frame, bool good, Span span) {
        if (checked_.has_errors()) return;
        if (reported_.size() <= frame) reported_.resize(frames_.size(), false);
        if (reported_[frame]) return;
        if (!good) {
            add_finding(kOutOfRange, "the object's transforms lead out of the range of numbers",
                        span);
        } else if (shapes_.condition(frame) >
                   (options_.judge_float ? kWorstCondition : kWorstInDouble)) {
            add_finding(kIllConditioned,
                        "the object's transforms stretch one direction more than a million times "
                        "as much as another",
                        span,
                        shapes_.condition(frame) > kWorstInDouble
                            ? "doubles do not resolve it either"
                            : "'--precision double' resolves it");
        } else if (frames_.frame(frame).coarse) {
            add_finding(kTooFast, "the object turns too far for steps of 15 degrees", span);
        } else {
            return;
        }
        reported_[frame] = true;
    }

    const CheckedScene& checked_;
    source::SourceMap& sources_;
    const LowerOptions& options_;
    bool keep_;
    Lowered lowered_;
    AssetLoader assets_;
    Frames frames_;
    ShapeBuilder shapes_;

    std::vector<BlockNodeId> objects_;
    CubeMapId background_map_;
    std::map<std::uint32_t, MaterialAssets> material_assets_;  ///< by block
    using MeshUse = std::pair<std::size_t, double>;            ///< OBJ file, crease angle
    std::map<std::uint32_t, MeshUse> mesh_uses_;               ///< by block
    std::map<MeshUse, std::size_t> mesh_counts_;
    std::map<MeshUse, std::uint32_t> meshes_;
    std::map<std::size_t, std::size_t> meshes_of_obj_;  ///< how many to build from one file
    std::set<std::size_t> judged_uvs_;
    MaterialId substitute_;
    std::vector<bool> reported_;
};

}  // namespace

Lowered lower(const CheckedScene& checked, source::SourceMap& sources, source::FileSource& files,
              const LowerOptions& options) {
    return Lowering(checked, sources, files, options, true).run();
}

std::vector<source::Diagnostic> check_assets(const CheckedScene& checked,
                                             source::SourceMap& sources, source::FileSource& files,
                                             const LowerOptions& options) {
    return Lowering(checked, sources, files, options, false).run().diagnostics;
}

}  // namespace cobble::ir
