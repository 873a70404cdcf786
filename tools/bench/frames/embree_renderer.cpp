// SPDX-License-Identifier: MIT
#include "tools/bench/frames/embree_renderer.hpp"

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

#include "ir/math/elementary.hpp"
#include "tools/bench/clock.hpp"
#include "tools/bench/embree/embree_scene.hpp"

namespace cobble::bench {

using math::Vec3d;
using math::Vec3f;

namespace {

constexpr unsigned kLanes = 16;
constexpr unsigned kTile = 32;

struct View {
    Vec3f right, up, corner;  ///< steps of a subpixel, and the direction to the first one's middle
    Vec3f light, ambient, diffuse, background;
};

View view_of(const ir::Scene& scene, const ScenePlan& plan, unsigned side) {
    const ir::Camera& camera = scene.camera;
    const auto half = math::sincos(camera.angle / 2);
    const double step = 2 * half.sin / half.cos / (plan.height * side);
    const Vec3d right = camera.right * step;
    const Vec3d up = camera.up * step;
    View view;
    view.right = right.to<float>();
    view.up = up.to<float>();
    view.corner = (camera.forward - right * (0.5 * (plan.width * side - 1.0)) +
                   up * (0.5 * (plan.height * side - 1.0)))
                      .to<float>();
    view.light = (scene.lights[0].position - camera.center).to<float>();
    view.diffuse = (scene.materials[0].diffuse * scene.lights[0].color).to<float>();
    view.ambient = (scene.materials[0].diffuse * scene.background.ambient).to<float>();
    view.background = scene.background.color.to<float>();
    return view;
}

/// Sixteen subpixels from (x, y) on, 4 x 4, with their light.
class Packet {
  public:
    Packet(RTCScene scene, const View& view) : scene_(scene), view_(view) {
        rtcInitIntersectContext(&context_);
        context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (int& v : all_) v = -1;
    }

    void trace(unsigned x, unsigned y) {
        RTCRay16& ray = camera_.ray;
        std::memset(&ray, 0, sizeof(ray));
        std::memset(&camera_.hit.geomID, 0xff, sizeof(camera_.hit.geomID));
        for (unsigned i = 0; i < kLanes; ++i) {
            const Vec3f way = view_.corner + view_.right * static_cast<float>(x + i % 4) -
                              view_.up * static_cast<float>(y + i / 4);
            const float scale = 1 / std::sqrt(dot(way, way));
            ray.dir_x[i] = way.x * scale;
            ray.dir_y[i] = way.y * scale;
            ray.dir_z[i] = way.z * scale;
            ray.tfar[i] = std::numeric_limits<float>::infinity();
            ray.mask[i] = 0xffffffffU;
        }
        rtcIntersect16(all_, scene_, &context_, &camera_);
        light();
    }

    [[nodiscard]] Vec3f color(unsigned i) const {
        if (camera_.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) return view_.background;
        return view_.ambient + view_.diffuse * lambert_[i];
    }

  private:
    void light() {
        std::memset(&shadow_, 0, sizeof(shadow_));
        bool any = false;
        for (unsigned i = 0; i < kLanes; ++i) {
            lambert_[i] = 0;
            valid_[i] = 0;
            if (camera_.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
            const Vec3f way{camera_.ray.dir_x[i], camera_.ray.dir_y[i], camera_.ray.dir_z[i]};
            Vec3f normal{camera_.hit.Ng_x[i], camera_.hit.Ng_y[i], camera_.hit.Ng_z[i]};
            normal = normal * (1 / std::sqrt(dot(normal, normal)));
            if (dot(normal, way) > 0) normal = -normal;
            const Vec3f point = way * camera_.ray.tfar[i];
            const Vec3f to_light = view_.light - point;
            const float cosine = dot(normal, to_light) / std::sqrt(dot(to_light, to_light));
            if (!(cosine > 0)) continue;
            lambert_[i] = cosine;
            valid_[i] = -1;
            any = true;
            shadow_.org_x[i] = point.x;
            shadow_.org_y[i] = point.y;
            shadow_.org_z[i] = point.z;
            shadow_.dir_x[i] = to_light.x;
            shadow_.dir_y[i] = to_light.y;
            shadow_.dir_z[i] = to_light.z;
            // A guess, as such renderers make one: a ten-thousandth of the way.
            shadow_.tnear[i] = 1e-4F;
            shadow_.tfar[i] = 1;
            shadow_.mask[i] = 0xffffffffU;
        }
        if (!any) return;
        rtcOccluded16(valid_, scene_, &context_, &shadow_);
        for (unsigned i = 0; i < kLanes; ++i) {
            if (valid_[i] != 0 && shadow_.tfar[i] < 0) lambert_[i] = 0;
        }
    }

    RTCScene scene_;
    const View& view_;
    RTCIntersectContext context_;
    RTCRayHit16 camera_;
    RTCRay16 shadow_;
    alignas(64) int all_[kLanes];
    alignas(64) int valid_[kLanes];
    float lambert_[kLanes] = {};
};

void render_tile(Packet& packet, const ScenePlan& plan, unsigned side, unsigned x0, unsigned y0,
                 std::vector<float>& pixels) {
    // One subpixel a pixel: a packet is 4 x 4 pixels. Sixteen: it is one pixel.
    const unsigned step = side == 1 ? 4 : 1;
    for (unsigned y = y0; y < y0 + kTile && y < plan.height; y += step) {
        for (unsigned x = x0; x < x0 + kTile && x < plan.width; x += step) {
            packet.trace(x * side, y * side);
            Vec3f sum;
            for (unsigned i = 0; i < kLanes; ++i) {
                const Vec3f c = packet.color(i);
                sum += c;
                const unsigned px = x + i % 4;
                const unsigned py = y + i / 4;
                if (side != 1 || px >= plan.width || py >= plan.height) continue;
                float* const to = &pixels[(std::size_t{py} * plan.width + px) * 3];
                to[0] = c.x;
                to[1] = c.y;
                to[2] = c.z;
            }
            if (side == 1) continue;
            float* const to = &pixels[(std::size_t{y} * plan.width + x) * 3];
            to[0] = sum.x / kLanes;
            to[1] = sum.y / kLanes;
            to[2] = sum.z / kLanes;
        }
    }
}

}  // namespace

EmbreeFrame render_with_embree(const Input& input, const ScenePlan& plan, unsigned threads) {
    EmbreeFrame frame;
    const Stopwatch making;
    const ir::Scene& scene = input.for_peers();
    const EmbreeScene built(scene, scene.camera.center, true, threads);
    frame.prepare_seconds = built.wall_seconds();
    frame.make_seconds = making.wall_seconds() - frame.prepare_seconds;

    const Stopwatch rendering;
    const unsigned side = plan.samples == 1 ? 1 : 4;
    const View view = view_of(scene, plan, side);
    frame.color.width = plan.width;
    frame.color.height = plan.height;
    frame.color.values.resize(std::size_t{plan.width} * plan.height * 3);
    const unsigned across = (plan.width + kTile - 1) / kTile;
    const unsigned down = (plan.height + kTile - 1) / kTile;
    std::atomic<unsigned> next{0};
    const auto work = [&] {
        const FlushDenormals flush;
        Packet packet(built.scene(), view);
        for (unsigned i = next++; i < across * down; i = next++) {
            render_tile(packet, plan, side, i % across * kTile, i / across * kTile,
                        frame.color.values);
        }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    frame.render_seconds = rendering.wall_seconds();
    frame.render_cpu = rendering.process_seconds();
    frame.camera_rays = static_cast<double>(plan.width) * plan.height * plan.samples;
    return frame;
}

}  // namespace cobble::bench
