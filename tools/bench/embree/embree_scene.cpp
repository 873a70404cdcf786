// SPDX-License-Identifier: MIT
#include "tools/bench/embree/embree_scene.hpp"

#include <fmt/format.h>
#include <xmmintrin.h>

#include <array>
#include <utility>

#include "tools/bench/clock.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

void push_point(std::vector<float>& to, Vec3d p) {
    to.push_back(static_cast<float>(p.x));
    to.push_back(static_cast<float>(p.y));
    to.push_back(static_cast<float>(p.z));
}

/// Corner i of a box takes its upper side of axis a if bit a of i is set; outwards
/// counter-clockwise.
constexpr std::array<std::uint32_t, 36> kBoxIndices{0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
                                                    0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                                    0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

}  // namespace

FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
    // Intel SDM volume 1, 10.2.3: bit 15 flushes results to zero, bit 6 takes denormals for zero.
    _mm_setcsr(before_ | 0x8040U);
}
FlushDenormals::~FlushDenormals() { _mm_setcsr(before_); }

EmbreeScene::EmbreeScene(const ir::Scene& source, Vec3d origin, bool robust, unsigned threads) {
    device_ = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    scene_ = new_scene(robust);

    const FlushDenormals flush;
    const auto mesh_buffers = [](const ir::Mesh& mesh, Vec3d from) {
        Buffers buffers;
        for (const Vec3d& p : mesh.positions) push_point(buffers.vertices, p - from);
        for (const ir::Mesh::Face& face : mesh.faces) {
            for (const auto& corner : face.corners) buffers.indices.push_back(corner.position);
        }
        return buffers;
    };
    std::vector<RTCScene> of_mesh(source.meshes.size(), nullptr);
    Buffers loose;
    Buffers spheres;
    double wall = 0;
    double cpu = 0;
    const auto commit = [&](RTCScene scene) {
        const Stopwatch watch;
        rtcCommitScene(scene);
        wall += watch.wall_seconds();
        cpu += watch.process_seconds();
    };
    for (const ir::Object& object : source.objects) {
        switch (object.kind) {
            case ir::ShapeKind::kMesh: {
                const ir::Mesh& mesh = source.meshes[object.shape];
                if (object.placement.count == 0) {
                    attach_triangles(scene_, mesh_buffers(mesh, origin));
                    break;
                }
                RTCScene& inside = of_mesh[object.shape];
                if (inside == nullptr) {
                    inside = new_scene(robust);
                    placed_.push_back(inside);
                    attach_triangles(inside, mesh_buffers(mesh, {}));
                    commit(inside);
                }
                attach_instance(inside, source.placements[object.placement.first], origin);
                break;
            }
            case ir::ShapeKind::kTriangle:
                for (const Vec3d& p : source.triangles[object.shape].keys[0]) {
                    loose.indices.push_back(static_cast<std::uint32_t>(loose.vertices.size() / 3));
                    push_point(loose.vertices, p - origin);
                }
                break;
            case ir::ShapeKind::kBox: {
                const ir::Box& box = source.boxes[object.shape];
                const auto first = static_cast<std::uint32_t>(loose.vertices.size() / 3);
                for (std::uint32_t i = 0; i < 8; ++i) {
                    push_point(loose.vertices, Vec3d{(i & 1) != 0 ? box.max.x : box.min.x,
                                                     (i & 2) != 0 ? box.max.y : box.min.y,
                                                     (i & 4) != 0 ? box.max.z : box.min.z} -
                                                   origin);
                }
                for (const std::uint32_t i : kBoxIndices) loose.indices.push_back(first + i);
                break;
            }
            case ir::ShapeKind::kSphere: {
                const ir::Sphere::Key& key = source.spheres[object.shape].keys[0];
                push_point(spheres.vertices, key.center - origin);
                spheres.vertices.push_back(static_cast<float>(key.radius));
                break;
            }
            case ir::ShapeKind::kPlane:
                break;
        }
    }
    if (!loose.indices.empty()) attach_triangles(scene_, std::move(loose));
    if (!spheres.vertices.empty()) {
        buffers_.push_back(std::move(spheres));
        const std::vector<float>& all = buffers_.back().vertices;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                   all.data(), 0, 4 * sizeof(float), all.size() / 4);
        attach(scene_, geometry);
    }
    commit(scene_);
    wall_seconds_ = wall;
    cpu_seconds_ = cpu;
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    for (RTCScene scene : placed_) rtcReleaseScene(scene);
    rtcReleaseDevice(device_);
}

RTCScene EmbreeScene::new_scene(bool robust) {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    return scene;
}

void EmbreeScene::attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void EmbreeScene::attach_triangles(RTCScene scene, Buffers moved) {
    // Embree reads vertices 16 bytes at a time.
    const std::size_t points = moved.vertices.size() / 3;
    moved.vertices.push_back(0);
    buffers_.push_back(std::move(moved));
    const Buffers& buffers = buffers_.back();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               buffers.vertices.data(), 0, 3 * sizeof(float), points);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               buffers.indices.data(), 0, 3 * sizeof(std::uint32_t),
                               buffers.indices.size() / 3);
    attach(scene, geometry);
}

void EmbreeScene::attach_instance(RTCScene inside, const ir::Placement& placement, Vec3d origin) {
    const auto& rows = placement.object_to_world.rows;
    std::array<float, 12> columns{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const double moved = column == 3 ? origin[row] : 0;
            columns[column * 3 + row] = static_cast<float>(rows[row][column] - moved);
        }
    }
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, inside);
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    attach(scene_, geometry);
}

bool EmbreeScene::count_bytes(void* self, ssize_t bytes, bool /*post*/) {
    static_cast<EmbreeScene*>(self)->bytes_ += bytes;
    return true;
}

}  // namespace cobble::bench
