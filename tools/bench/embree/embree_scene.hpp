// SPDX-License-Identifier: MIT
// A scene of ours as Embree's: the peer that the ray core is measured against.
//
// Coordinates are local (world minus `origin`), narrowed to float as the renderer narrows them.
// Meshes, triangles, spheres and boxes (twelve triangles each), meshes placed by matrices as
// Embree's instances; nothing moves. Vertices stay in buffers of ours, so that the bytes counted
// are Embree's own.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::bench {

/// While it lives, this thread flushes denormals to zero, as Embree's manual asks for.
class FlushDenormals {
  public:
    FlushDenormals();
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
    ~FlushDenormals();

  private:
    std::uint32_t before_;
};

class EmbreeScene {
  public:
    /// Builds with medium quality; `threads` is how many Embree may use for that.
    EmbreeScene(const ir::Scene& scene, math::Vec3d origin, bool robust, unsigned threads);
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;
    ~EmbreeScene();

    [[nodiscard]] RTCScene scene() const { return scene_; }
    /// Of committing all geometries and scenes: wall time, and processor time of all threads.
    [[nodiscard]] double wall_seconds() const { return wall_seconds_; }
    [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }
    /// What Embree holds after building.
    [[nodiscard]] std::int64_t bytes() const { return bytes_.load(); }

  private:
    struct Buffers {
        std::vector<float> vertices;  ///< with room behind the last, which Embree may read
        std::vector<std::uint32_t> indices;
    };

    RTCScene new_scene(bool robust);
    void attach(RTCScene scene, RTCGeometry geometry);
    void attach_triangles(RTCScene scene, Buffers buffers);
    void attach_instance(RTCScene inside, const ir::Placement& placement, math::Vec3d origin);
    static bool count_bytes(void* self, ssize_t bytes, bool post);

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<RTCScene> placed_;
    std::vector<Buffers> buffers_;
    double wall_seconds_ = 0, cpu_seconds_ = 0;
    std::atomic<std::int64_t> bytes_ = 0;
};

}  // namespace cobble::bench
