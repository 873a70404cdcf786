// SPDX-License-Identifier: MIT
// The different surfaces that a batch of rays meets: neighbours mostly meet the same few, and what
// is known of one before a ray comes is looked up once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "renderer/geometry/hit.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/shading_scene.hpp"

namespace cobble::renderer {

/// How a surface is computed: by a loop over columns for each of the first four; one by one in
/// stages.hpp; and one by one without lights.
enum class SurfaceForm : std::uint8_t { kFlat, kSmooth, kSphere, kBox, kOther, kUnlit };
inline constexpr std::size_t kSurfaceForms = 6;

/// Slot by slot, in the order in which they are met; at most as many as a batch has rays. One that
/// was not met lately may have a slot twice.
template <typename T>
class MetSurfaces {
  public:
    /// The scene must outlive this.
    explicit MetSurfaces(const ShadingScene<T>& scene);

    /// Of a new batch: none.
    void begin() {
        count_ = 0;
        any_highlight_ = any_scatters_ = any_glass_ = false;
        recent_.fill({});
    }
    /// The slot of what a ray has hit.
    std::size_t slot_of(const Hit<T>& hit) {
        // Neighbouring objects and faces get places of their own.
        Recent& recent = recent_[(hit.object.value * 13 + hit.face) % kRecent];
        if (recent.object != hit.object || recent.face != hit.face) {
            recent = {hit.object, hit.face, static_cast<std::uint32_t>(count_)};
            fill_slot(count_++, hit);
        }
        return recent.slot;
    }

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const SurfaceSlots<T>& columns() const { return *columns_; }
    [[nodiscard]] SurfaceForm form(std::size_t slot) const { return form_[slot]; }
    [[nodiscard]] const PreparedMaterial<T>& material(std::size_t slot) const {
        return *material_[slot];
    }
    /// By slot: 1 if rays go on from there, else 0.
    [[nodiscard]] const std::uint8_t* scatters() const { return scatters_.data(); }
    /// A bit for each form among them.
    [[nodiscard]] std::uint32_t forms() const {
        std::uint32_t forms = 0;
        for (std::size_t slot = 0; slot < count_; ++slot) {
            forms |= 1U << static_cast<std::uint32_t>(form_[slot]);
        }
        return forms;
    }
    // Whether any of them has a highlight, sends rays on, lets them through.
    [[nodiscard]] bool any_highlight() const { return any_highlight_; }
    [[nodiscard]] bool any_scatters() const { return any_scatters_; }
    [[nodiscard]] bool any_glass() const { return any_glass_; }

  private:
    void fill_slot(std::size_t slot, const Hit<T>& hit);
    [[nodiscard]] SurfaceForm form_of(const ir::Object& object, const Hit<T>& hit) const;
    void fill_triangle(std::size_t slot, const std::array<math::Vec3<T>, 3>& vertices);

    const ShadingScene<T>* scene_;
    std::unique_ptr<SurfaceSlots<T>> columns_;
    std::size_t count_ = 0;
    std::array<SurfaceForm, kBatchSize> form_{};
    std::array<const PreparedMaterial<T>*, kBatchSize> material_{};
    std::array<std::uint8_t, kBatchSize> scatters_{};
    /// Slots by a hash of their object and face; the last one with it.
    static constexpr std::size_t kRecent = 64;
    struct Recent {
        ir::ObjectId object;
        std::uint32_t face = 0;
        std::uint32_t slot = 0;
    };
    std::array<Recent, kRecent> recent_{};
    bool any_highlight_ = false;
    bool any_scatters_ = false;
    bool any_glass_ = false;
};

}  // namespace cobble::renderer
