// SPDX-License-Identifier: MIT
// What a render does at each stage: chosen once, from the scene and its settings, before any ray.
//
// Each stage has a few forms, every one compiled by itself; the batches of a render call those that
// are chosen here, and have memory for the columns that are needed here and for no others. Effects
// that are off are no form and no column of any stage.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/integrator/active_effects.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

template <typename T>
struct PreparedMaterial;

/// Beyond this many turns a path is given up, whatever Settings::bounces says: even a mirror of
/// 99 % sends back less than a ten-thousandth by then, and stacks have a size to be made for.
inline constexpr std::uint32_t kMostBounces = 1000;

/// How rays are followed.
enum class Tracing : std::uint8_t {
    kRayByRay,  ///< the reference
    kStraight,  ///< in batches, from the camera to the colour: no ray goes on from a surface
    kInTurns,   ///< in batches, turn by turn
};
/// Where the first rays start, and when.
enum class RayStage : std::uint8_t { kPinhole, kLens, kTime, kLensAndTime };
/// What the look of a surface that is computed by itself may depend on, beside its material's
/// colour: a sum of parts. Texture coordinates are computed for pictures and for normals.
using SurfaceStage = std::uint8_t;
inline constexpr SurfaceStage kSurfacePictures = 1;  ///< that give colours
inline constexpr SurfaceStage kSurfaceNoise = 2;
inline constexpr SurfaceStage kSurfaceBent = 4;  ///< normals, by maps
inline constexpr SurfaceStage kAnySurface = 7;
/// From which place of a light it shines.
enum class LightStage : std::uint8_t { kMiddle, kArea };
/// Which rays go on from surfaces.
enum class ScatterStage : std::uint8_t { kNone, kReflect, kRefract, kReflectAndRefract };
/// What a ray sees that meets nothing.
enum class MissStage : std::uint8_t { kColor, kCubeMap };

/// COBBLE_COLUMNS(id, name, why_none): columns of a batch; the last one says why there are none.
#define COBBLE_COLUMN_GROUPS(COBBLE_COLUMNS)                                              \
    COBBLE_COLUMNS(kRays, "rays and hits", "rays are followed one by one")                \
    COBBLE_COLUMNS(kSurfaces, "surfaces", "rays are followed one by one")                 \
    COBBLE_COLUMNS(kOneByOne, "surfaces one by one", "all are at rest and of one colour") \
    COBBLE_COLUMNS(kLight, "light", "there are no lights")                                \
    COBBLE_COLUMNS(kShadowRays, "shadow rays", "shadows are off, or there are no lights") \
    COBBLE_COLUMNS(kHighlights, "highlights", "highlights are off, or nothing has one")   \
    COBBLE_COLUMNS(kScatter, "what goes on", "no ray goes on from a surface")             \
    COBBLE_COLUMNS(kReflected, "reflected rays", "no ray is reflected")                   \
    COBBLE_COLUMNS(kRefracted, "refracted rays", "no ray is refracted")

enum class ColumnGroup : std::uint8_t {
#define COBBLE_COLUMNS(id, name, why_none) id,
    COBBLE_COLUMN_GROUPS(COBBLE_COLUMNS)
#undef COBBLE_COLUMNS
        kCount_
};
inline constexpr std::size_t kColumnGroups = static_cast<std::size_t>(ColumnGroup::kCount_);

/// Something in memory.
struct PlannedBytes {
    std::string_view name;
    std::uint64_t bytes = 0;    ///< 0: not there
    std::string_view why_none;  ///< if it is not
};

/// A stage, for people.
struct PlannedStage {
    std::string_view stage;
    std::string form;
    std::string why;
};

struct RenderPlan {
    Tracing tracing = Tracing::kStraight;
    RayStage rays = RayStage::kPinhole;
    SurfaceStage surface = 0;
    std::vector<LightStage> lights;  ///< of each light of the scene
    bool shadows = false;            ///< a ray asks whether its light arrives
    bool highlights = false;
    ScatterStage scatter = ScatterStage::kNone;
    MissStage miss = MissStage::kColor;
    bool reads_uv = false;  ///< some surface has its texture coordinates read
    std::array<bool, kColumnGroups> needed{};

    ActiveEffects effects;
    std::uint32_t bounces = 0;
    bool general = false;  ///< see Settings::general_stages
    bool single = true;    ///< precision, by which columns are as wide as they are
    /// Pictures of the scene that are read, whose memory is the scene's.
    std::vector<PlannedBytes> pictures;

    [[nodiscard]] bool needs(ColumnGroup group) const {
        return needed[static_cast<std::size_t>(group)];
    }
    [[nodiscard]] bool reflects() const {
        return scatter == ScatterStage::kReflect || scatter == ScatterStage::kReflectAndRefract;
    }
    [[nodiscard]] bool refracts() const {
        return scatter == ScatterStage::kRefract || scatter == ScatterStage::kReflectAndRefract;
    }
};

/// What a render of Cobble's own way would do. Looks at each object once; builds nothing.
RenderPlan plan_render(const ir::Scene& scene, const Settings& settings);

/// The same with the scene's materials prepared for its precision, and one more for objects without
/// any.
template <typename T>
RenderPlan make_plan(const ir::Scene& scene, const Settings& settings,
                     std::span<const PreparedMaterial<T>> materials);

/// Each stage with the form chosen and why, in the order of a ray's life.
std::vector<PlannedStage> stages_of(const RenderPlan& plan);

/// The columns of one batch, of which each worker has one: those needed and those that are not.
std::vector<PlannedBytes> columns_of(const RenderPlan& plan);

/// Of the columns that a batch allocates for `group`, if it is needed.
template <typename T>
std::uint64_t bytes_of(ColumnGroup group);

}  // namespace cobble::renderer
