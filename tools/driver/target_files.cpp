// SPDX-License-Identifier: MIT
#include "tools/driver/target_files.hpp"

#include <cstdint>

#include "renderer/compat/compat_renderer.hpp"
#include "renderer/picture/picture_io.hpp"
#include "tools/driver/pictures.hpp"
#include "tools/driver/shards.hpp"

namespace cobble::driver {
namespace {

// As many as each pixel is to take; a published program takes what its flags say.
std::uint32_t samples_of(const TargetStyle& style) {
    if (style.most_samples > 0) return style.most_samples;
    return style.scene.compat == ir::Compat::kNone
               ? style.settings.samples
               : renderer::compat_samples_per_pixel(style.scene, style.settings);
}

// What an 8-bit file shows of it.
renderer::Plane32 shown(const RenderTarget& target, const renderer::Plane32& plane,
                        const TargetStyle& style) {
    if (target.plane == &renderer::Picture::depth) {
        return depth_as_grey(plane, style.scene.compat, style.depth_range);
    }
    if (target.plane == &renderer::Picture::normals) {
        return normals_as_color(plane, style.scene.compat);
    }
    if (target.plane == &renderer::Picture::sample_count) {
        return counts_as_grey(plane, samples_of(style));
    }
    return plane;
}

}  // namespace

std::string write_target(const RenderTarget& target, const renderer::Picture& picture,
                         const TargetStyle& style) {
    renderer::EncodeOptions encode;
    if (style.scene.compat != ir::Compat::kNone) encode.quantise = renderer::Quantise::kTruncate;
    const bool color =
        target.plane == &renderer::Picture::color || target.plane == &renderer::Picture::albedo;
    encode.encode_srgb = style.transfer == "srgb" && color;
    if (style.is_shard) {
        encode.comment = to_text(
            shard_note(style.scene, style.settings, target.name, style.transfer, picture.complete));
    }
    const renderer::Plane32& plane = picture.*target.plane;
    return keeps_bytes(target.path)
               ? write_picture(target.path, shown(target, plane, style), encode)
               : write_picture(target.path, plane, encode);
}

}  // namespace cobble::driver
