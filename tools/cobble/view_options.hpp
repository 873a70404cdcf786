// SPDX-License-Identifier: MIT
// The options that say what picture a scene makes: those of `render`, of which `pick` shares most.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/scene/effects.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"
#include "tools/cobble/option_values.hpp"
#include "tools/driver/load.hpp"

namespace CLI {
class App;
}

namespace cobble {

struct ViewOptions {
    std::string scene;
    std::string stdin_path;
    Size size;
    std::optional<renderer::Crop> crop;
    std::string compat;
    std::string transfer = "none";
    std::string precision = "float";
    std::string texture_filter;
    std::optional<DepthRange> depth_range;
    std::uint32_t samples = 16;
    std::uint32_t light_samples = 1;
    std::uint32_t bounces = 4;
    std::uint64_t seed = 0;
    double aperture = -1;
    double focus_distance = -1;
    bool keep_going = false;
    /// Of `render`: the names of its options that were given, such as "--samples".
    std::vector<std::string> given;
    /// Above 0: asked for; below: switched off.
    std::array<int, ir::kEffectCount> effects{};

    // What the original programs' spellings become.
    bool original_shadows = false, original_jitter = false, original_filter = false;
    bool original_casting = false, original_pixelated = false;
    double original_blurry = -1;
};

void add_view_options(CLI::App& sub, ViewOptions& options);

/// Those among them that decide what is simulated: each effect by its name, lens, bounces,
/// precision.
void add_effect_options(CLI::App& sub, ViewOptions& options);

/// --compat and what the original programs' spellings become.
void add_compat_options(CLI::App& sub, ViewOptions& options);

/// --size alone, for commands that look at a scene and make no picture.
void add_size_option(CLI::App& sub, ViewOptions& options);

/// One scene as the options ask for it, ready to be rendered.
struct View {
    driver::LoadedScene loaded;
    renderer::Settings settings;
    ir::Compat compat = ir::Compat::kNone;
    int status = 0;  ///< other than 0: why there is nothing to render was said on standard error
};

/// Loads the scene and says on standard error what is wrong with it: all of it, or with `quiet`
/// only what stops the render. `command` is whose options they are.
View make_view(std::string_view command, const ViewOptions& options, bool quiet);

ir::Compat compat_of(const ViewOptions& options);

/// What to simulate of a scene: what it calls for, and what the options say. The camera gets their
/// lens first; `problem` is what is wrong with it, or "".
ir::Effects choose_effects(ir::Scene& scene, const ViewOptions& options, std::string& problem);

/// Writes the findings for people to standard error.
void report_to_error(const driver::LoadedScene& loaded, bool errors_only);

}  // namespace cobble
