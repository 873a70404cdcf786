// SPDX-License-Identifier: MIT
// The render loop of a scene by itself, for a profiler that counts instructions:
//
//   valgrind --tool=callgrind --collect-atstart=no --toggle-collect=cobble_render_loop
//       loop SCENE SIZE SAMPLES INSTRUCTION_SET [EFFECT...]
//
// renders the scene in one tile on one thread, SIZE wide and three quarters of that high, with the
// effects named switched off, and prints a hash of the picture. Everything but the loop is outside
// of the function that is counted. "none" in place of effects: all of them are off.
#include <fmt/core.h>

#include <atomic>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

#include "ir/effects.hpp"
#include "renderer/film/film.hpp"
#include "renderer/integrator/scene_renderer.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/fp_environment.hpp"
#include "renderer/sampling/sample_pass.hpp"
#include "tools/driver/load.hpp"

using namespace cobble;

namespace {

using Renderer = renderer::SceneRenderer<float>;

std::uint32_t number(std::string_view text) {
    std::uint32_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

int fail(const std::string& problem) {
    fmt::print(stderr, "loop: {}\n", problem);
    return 2;
}

/// False if there is no such effect.
bool switch_off(ir::Effects& effects, std::string_view name) {
    bool found = false;
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        if (name != "none" && name != ir::name_of(static_cast<ir::Effect>(i))) continue;
        effects.states[i].on = false;
        found = true;
    }
    return found;
}

std::uint64_t hash_of(const renderer::Picture& picture) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const float value : picture.color.values) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 1099511628211U;
    }
    return hash;
}

}  // namespace

/// What is counted.
extern "C" __attribute__((noinline)) void cobble_render_loop(const Renderer& of,
                                                             renderer::TileWork& work,
                                                             renderer::Film& film,
                                                             renderer::StopCheck& stop) {
    of.render_tile(work, film, stop);
}

int main(int argc, char** argv) {
    if (argc < 5) return fail("usage: loop SCENE SIZE SAMPLES INSTRUCTION_SET [EFFECT...|none]");
    const driver::LoadedScene loaded = driver::load_scene(argv[1], {}, {});
    if (loaded.session == nullptr) return fail(loaded.problem);
    if (driver::has_errors(loaded.diagnostics)) return fail("the scene has errors");
    if (!renderer::use_instruction_set(argv[4])) return fail("there is no such instruction set");
    const ir::Scene& scene = loaded.lowered.scene;
    renderer::Settings settings;
    settings.width = number(argv[2]);
    settings.height = settings.width * 3 / 4;
    settings.samples = number(argv[3]);
    settings.effects = ir::derive_effects(scene);
    for (int i = 5; i < argc; ++i) {
        if (!switch_off(settings.effects, argv[i])) return fail("there is no such effect");
    }
    const renderer::FpEnvironment environment;
    const Renderer of(renderer::prepare_shading<float>(scene, settings), settings);
    renderer::Film film(settings);
    renderer::TileWork work;
    work.tile = {0, 0, settings.width, settings.height};
    work.pass = renderer::whole_pass(settings.seed, settings.samples);
    work.pixels = work.tile.pixels();
    const std::atomic<bool> cancelled = false;
    renderer::StopCheck stop(cancelled, renderer::Deadline::max());
    cobble_render_loop(of, work, film, stop);
    if (work.counters.camera_rays != work.pixels * settings.samples)
        return fail("the picture is not complete");
    fmt::print("{:016x}\n", hash_of(film.picture()));
    return 0;
}
