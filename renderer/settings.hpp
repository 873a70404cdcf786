// SPDX-License-Identifier: MIT
// Everything that a caller may choose about a render. Defaults are Cobble's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ir/scene/effects.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

enum class Precision : std::uint8_t { kFloat, kDouble };
enum class PixelFilter : std::uint8_t { kBox, kTent, kGaussian };
enum class Acceleration : std::uint8_t {
    kFast,        ///< batches of rays, SIMD kernels on wide trees
    kBvh,         ///< the reference: one ray, one primitive at a time
    kBruteForce,  ///< the reference without a tree
};

/// Pixels [x0, x1) x [y0, y1), y downwards from the top of the picture.
struct Crop {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// A picture that takes as many samples as it needs: see renderer/passes.
struct ErrorGoal {
    enum class Method : std::uint8_t {
        kAdaptive,   ///< samples decide how many more are taken
        kUnbiased,   ///< other samples decide that, and are thrown away
        kGuarantee,  ///< a bound that holds however values are distributed
    };
    double error = 0.01;  ///< half the width of each pixel's 95 % interval, in display values
    Method method = Method::kAdaptive;
    std::uint32_t most_samples = 1U << 16U;  ///< a pixel; more are not taken, whatever the error
};

// What is added here and changes pixels belongs in fingerprint() and its test.
struct Settings {
    std::uint32_t width = 640;
    std::uint32_t height = 480;
    std::optional<Crop> crop;
    std::uint32_t samples = 16;       ///< per pixel, from 1; 1 is the pixel's centre
    std::uint32_t light_samples = 1;  ///< places on each light with a size, from 1, at each hit
    /// Sets of random numbers, independent of each other, that `samples` are shared out among: more
    /// than one say how large the picture's error is. The first ones take what does not go evenly.
    std::uint32_t scrambles = 1;
    std::optional<ErrorGoal> goal;  ///< if set, `samples` and `scrambles` are not read
    /// The picture is light, and encoded to be shown: its errors are those of what is shown.
    bool shown_as_srgb = false;
    std::uint32_t bounces = 4;
    std::uint64_t seed = 0;
    std::uint64_t salts = 0;  ///< as SamplePass has them: other numbers for some kinds of draws
    PixelFilter filter = PixelFilter::kBox;
    Precision precision = Precision::kFloat;
    Acceleration acceleration = Acceleration::kFast;
    /// Every stage in its most general form, with all the columns, whatever the effects: the same
    /// bits, slower. For tests.
    bool general_stages = false;
    std::uint32_t tile_size = 32;
    bool time_stages = false;  ///< look at the clock between stages: see StageClock
    ir::Effects effects;  ///< what to simulate; ir::derive_effects, then the command line's word
    std::optional<ir::TextureFilter> texture_filter;  ///< over every material's own

    /// What the published programs' flags ask for; read only if the scene's compat is not kNone.
    struct Compat {
        bool shadows = false;
        bool jitter = false;
        bool filter = false;           ///< the 5-tap kernel at 3x3, then the average
        bool casting = false;          ///< project: its ray caster in place of its ray tracer
        bool pixelated = false;        ///< project: nearest texel
        std::optional<double> blurry;  ///< project: thin lens focused here
        double depth_min = 0, depth_max = 1;  ///< for the depth picture
    } compat;

    /// Which of the N interleaved tile sets to render; the others stay empty.
    std::uint32_t shard_index = 0, shard_count = 1;

    /// Extra pictures to keep beside the colour.
    bool want_depth = false, want_normals = false, want_albedo = false, want_sample_count = false;
};

/// The part of the picture that `settings` asks for: the crop clamped to the picture, or all of it.
/// Empty (x0 = x1 or y0 = y1) if they do not meet.
Crop window_of(const Settings& settings);

/// All settings that the pixels of a picture depend on, as text of one line: two settings with
/// one text make one picture of any scene. Left out are how it is made (acceleration, tiles,
/// shards), which leaves no trace, and which pictures are kept beside it. A crop counts as the
/// window that it leaves.
std::string fingerprint(const Settings& settings);

}  // namespace cobble::renderer
