// SPDX-License-Identifier: MIT
// Columns of a batch that a render has only if its plan needs them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "renderer/geometry/hit.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/integrator/render_plan.hpp"

namespace cobble::renderer {

/// The rays that ask whether one light arrives, and their answers.
template <typename T>
struct ShadowRays {
    ShadowColumns<T> of_entries;
    RayBatch<T> rays;
    std::array<std::uint32_t, kBatchSize> asker{};  ///< entry, by ray
    std::array<Hit<T>, kBatchSize> hidden_by{};     ///< by ray
};

/// Null if the plan does not need the group.
template <typename Columns>
std::unique_ptr<Columns> columns_if_needed(const RenderPlan& plan, ColumnGroup group) {
    return plan.needs(group) ? std::make_unique<Columns>() : nullptr;
}

}  // namespace cobble::renderer
