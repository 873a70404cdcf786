// SPDX-License-Identifier: MIT
#include "renderer/compat/compat_renderer.hpp"

#include "ir/math/elementary.hpp"
#include "renderer/compat/camera.hpp"
#include "renderer/compat/filter.hpp"
#include "renderer/compat/trace.hpp"
#include "renderer/sampling/hash.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/tile/pixel_mask.hpp"

namespace cobble::renderer {
namespace {

/// Rays through the lens for each sample of a picture with -blurry.
constexpr std::uint32_t kLensRays = 16;

std::uint32_t rays_per_sample(const CompatRules& rules) { return rules.focus ? kLensRays : 1; }

/// In [0, 1), by sample of the high-resolution picture, ray through the lens, and use.
double uniform(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t ray,
               std::uint32_t use) {
    constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio
    std::uint64_t state = mix64(seed + kStep);
    state = mix64(state + kStep + (std::uint64_t{y} << 32 | x));
    state = mix64(state + kStep + (std::uint64_t{use} << 32 | ray));
    return static_cast<double>(state >> 11) * 0x1p-53;
}

CompatRules without_grid(CompatRules rules) {
    rules.grid = 1;
    return rules;
}

enum Use : std::uint32_t { kJitterX, kJitterY, kLensRadius, kLensAngle };

/// A tile on its way: samples 0 to `next` are there, and the next one perhaps half.
class PausedTile : public PausedWork {
  public:
    PausedTile(const CompatRules& rules, const Settings& settings, const Tile& tile)
        : grid(rules, settings.width, settings.height, tile.x0, tile.y0, tile.x1, tile.y1) {}

    SampleGrid grid;
    std::uint64_t pixel = 0;  ///< of the tile, row by row: those before it are finished
    std::uint64_t next = 0;
    std::uint32_t lens_ray = 0;
    ir::Color lens_sum;
    bool tracing = false;
    CompatTrace trace;
};

/// The published programs' rays begin where theirs did, one after the other: there is nothing to
/// batch, so they stay on the plain tree.
Acceleration reference(Acceleration wanted) {
    return wanted == Acceleration::kFast ? Acceleration::kBvh : wanted;
}

class CompatRenderer : public TileRenderer {
  public:
    CompatRenderer(const ir::Scene& scene, const Settings& settings,
                   const std::atomic<bool>* cancelled)
        : settings_(settings),
          prepared_(
              prepare<double>(scene, {reference(settings.acceleration), true, {cancelled, {}}})),
          scene_{&scene, &prepared_, rules_of(scene.compat, settings)},
          camera_(scene.camera, scene_.rules, settings.width, settings.height),
          plain_camera_(scene.camera, without_grid(scene_.rules), settings.width, settings.height) {
    }

    [[nodiscard]] std::uint64_t bytes() const { return prepared_.bytes(); }

    [[nodiscard]] const std::vector<PreparationNote>& notes() const override {
        return prepared_.notes;
    }

    void render_tile(TileWork& work, Film& film, StopCheck& stop) const override {
        if (work.done()) return;
        work.clock.enter(TimedStage::kRayByRay);
        if (!work.paused) {
            work.paused = std::make_unique<PausedTile>(scene_.rules, settings_, work.tile);
        }
        auto& state = static_cast<PausedTile&>(*work.paused);
        while (!work.done()) {
            const std::uint32_t y = work.tile.y(state.pixel);
            const std::uint64_t needed = state.grid.needed_for_row(y);
            while (state.next < needed) {
                if (stop(work.counters.box_tests + work.counters.primitive_tests)) return;
                advance(state, work);
            }
            finish_pixel(state, work, film);
        }
        work.paused.reset();
    }

  private:
    /// One ray more of the sample that is due.
    void advance(PausedTile& state, TileWork& work) const {
        const std::uint32_t x = state.grid.x(state.next);
        const std::uint32_t y = state.grid.y(state.next);
        if (!state.tracing) {
            start_ray(state, x, y);
            ++work.counters.camera_rays;
        }
        state.trace.step(scene_, work.counters);
        state.tracing = !state.trace.done();
        if (state.tracing) return;
        if (finite(state.trace.color())) {
            state.lens_sum += state.trace.color();
        } else {
            report(state, work, x / scene_.rules.grid, y / scene_.rules.grid);
        }
        const std::uint32_t rays = rays_per_sample(scene_.rules);
        if (++state.lens_ray < rays) return;
        state.grid.set(state.next, state.lens_sum / static_cast<double>(rays));
        state.lens_sum = {};
        state.lens_ray = 0;
        ++state.next;
    }

    void start_ray(PausedTile& state, std::uint32_t x, std::uint32_t y) const {
        const auto random = [&](std::uint32_t ray, Use use) {
            return uniform(settings_.seed, x, y, ray, use);
        };
        double dx = 0;
        double dy = 0;
        if (scene_.rules.jitter) {
            dx = random(0, kJitterX) - 0.5;
            dy = random(0, kJitterY) - 0.5;
        }
        const math::Vec3d direction = camera_.direction(x, y, dx, dy);
        CompatCamera::Ray ray = camera_.ray(direction);
        if (scene_.rules.focus) {
            const double radius = std::sqrt(random(state.lens_ray, kLensRadius));
            const math::SinCos angle =
                math::sincos(2 * math::kPi * random(state.lens_ray, kLensAngle));
            ray = camera_.lens_ray(direction, radius * angle.cos, radius * angle.sin);
        }
        state.trace.start(scene_, ray.origin, ray.direction);
    }

    /// Only a tile that owns the pixel reports it: samples around a tile are computed twice.
    void report(const PausedTile& state, TileWork& work, std::uint32_t x, std::uint32_t y) const {
        const Tile& tile = work.tile;
        if (x < tile.x0 || x >= tile.x1 || y < tile.y0 || y >= tile.y1) return;
        if (work.pass.active != nullptr && !work.pass.active->has(x, y)) return;
        BadSample bad{x, y, state.lens_ray, {}};
        const ir::ObjectId object = state.trace.first_object();
        if (object.valid()) bad.span = scene_.scene->objects[object.value].span;
        work.report(bad);
    }

    void finish_pixel(PausedTile& state, TileWork& work, Film& film) const {
        const std::uint32_t x = work.tile.x(state.pixel);
        const std::uint32_t y = work.tile.y(state.pixel);
        ++state.pixel;
        if (work.pass.active != nullptr && !work.pass.active->has(x, y)) return;
        Pixel pixel;
        pixel.color = state.grid.pixel(x, y);
        pixel.samples = scene_.rules.grid * scene_.rules.grid * rays_per_sample(scene_.rules);
        if (settings_.want_depth || settings_.want_normals || settings_.want_albedo) {
            add_first_hit(x, y, pixel, work.counters);
        }
        film.set_pixel(x, y, pixel);
        work.samples_done += pixel.samples;
        ++work.pixels_done;
    }

    /// Depth and normals are those at the pixel's place in the plain picture, whatever the grid.
    void add_first_hit(std::uint32_t x, std::uint32_t y, Pixel& pixel, Counters& counters) const {
        const CompatCamera::Ray ray = plain_camera_.ray(plain_camera_.direction(x, y, 0, 0));
        const CompatFirstHit first = compat_first_hit(scene_, ray.origin, ray.direction, counters);
        ++counters.camera_rays;
        if (!first.hit) return;
        pixel.depth = first.distance;
        pixel.normal = first.normal;
        pixel.albedo = first.albedo;
    }

    Settings settings_;
    PreparedScene<double> prepared_;
    CompatScene scene_;
    CompatCamera camera_;
    CompatCamera plain_camera_;  ///< of the picture without a grid
};

}  // namespace

std::unique_ptr<TileRenderer> make_compat_renderer(const ir::Scene& scene, const Settings& settings,
                                                   std::uint64_t& bytes,
                                                   const std::atomic<bool>* cancelled) {
    auto renderer = std::make_unique<CompatRenderer>(scene, settings, cancelled);
    bytes = renderer->bytes();
    return renderer;
}

std::uint32_t compat_samples_per_pixel(const ir::Scene& scene, const Settings& settings) {
    const CompatRules rules = rules_of(scene.compat, settings);
    return rules.grid * rules.grid * rays_per_sample(rules);
}

}  // namespace cobble::renderer
