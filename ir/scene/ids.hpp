// SPDX-License-Identifier: MIT
// Typed indices into the arrays of ir::Scene.
#pragma once

#include <cstdint>

namespace cobble::ir {

template <typename Tag>
struct Id {
    std::uint32_t value = kNone;

    static constexpr std::uint32_t kNone = 0xffffffffU;
    [[nodiscard]] constexpr bool valid() const { return value != kNone; }
    friend constexpr auto operator<=>(Id, Id) = default;
};

using LightId = Id<struct LightTag>;
using MaterialId = Id<struct MaterialTag>;
using ImageId = Id<struct ImageTag>;
using CubeMapId = Id<struct CubeMapTag>;
using MeshId = Id<struct MeshTag>;
using ObjectId = Id<struct ObjectTag>;

}  // namespace cobble::ir
