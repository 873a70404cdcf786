// SPDX-License-Identifier: MIT
// Pictures that must not depend on how, or in whose process, they are made: rows 43 and 45 of the
// hard cases. Compilers are compared by the hashes that tests/render/golden.expected holds.
#include <doctest/doctest.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "renderer/intersect/instruction_set.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/mixed.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/record.hpp"
#include "tests/support/with_instruction_set.hpp"

namespace cobble::test {

namespace {

std::string hash_of(const renderer::Picture& picture) {
    BitsHash hash;
    for (const auto* plane : {&picture.color, &picture.depth, &picture.normals, &picture.albedo}) {
        hash.add(plane->values);
    }
    return hash.text();
}

/// As a host sets it that wants no denormals: results that would be one are 0, and so are operands.
class DenormalsFlushed {
  public:
#if defined(__SSE2__)
    // Bits 15 and 6 of the control register.
    DenormalsFlushed() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040U); }
    ~DenormalsFlushed() { _mm_setcsr(before_); }
#elif defined(__aarch64__)
    DenormalsFlushed() {
        asm volatile("mrs %0, fpcr" : "=r"(before_));
        asm volatile("msr fpcr, %0" ::"r"(before_ | std::uint64_t{1} << 24));
    }
    ~DenormalsFlushed() { asm volatile("msr fpcr, %0" ::"r"(before_)); }
#endif
    DenormalsFlushed(const DenormalsFlushed&) = delete;
    DenormalsFlushed& operator=(const DenormalsFlushed&) = delete;

  private:
#if defined(__SSE2__)
    std::uint32_t before_;
#elif defined(__aarch64__)
    std::uint64_t before_;
#endif
};

/// Triangles, spheres and boxes that touch and overlap, `scale` in size.
SceneMaker heap(double scale) {
    SceneMaker make;
    Random random(45);
    for (int i = 0; i < 24; ++i) {
        const Vec3d a = random.point(1).to<float>().to<double>();
        const Vec3d b = random.point(1).to<float>().to<double>();
        const Vec3d c = random.point(1).to<float>().to<double>();
        make.triangle(a * scale, b * scale, c * scale);
        if (i % 3 == 0) make.sphere(b * scale, 0.25 * scale);
        if (i % 4 == 0) make.box(c * scale, (c + Vec3d{0.25, 0.5, 0.125}) * scale);
    }
    return make;
}

/// One picture with one thread and with three, on a host that flushes denormals.
void check_flushed(const ir::Scene& scene, const renderer::Settings& s,
                   const std::string& expected) {
    const DenormalsFlushed flushed;
    CHECK(hash_of(render(scene, s).picture) == expected);
    CHECK(hash_of(render(scene, s, 3).picture) == expected);
}

/// All coordinates in float below the normal range, of which 2^-126 is the end; light too in half
/// of what it falls on.
SceneBuilder below_normal() {
    constexpr double kUnit = 0x1p-130;
    SceneBuilder b;
    b.camera(Vec3d{0, 0.5, 7} * kUnit, {0, 0, -1}, 0.6);
    b.material({0.8, 0.6, 0.4});
    b.mesh(smooth_tetrahedron());
    for (Vec3d& p : b.scene().meshes[0].positions) p = p * kUnit;
    b.triangle(Vec3d{-3, 0, -1} * kUnit, Vec3d{-1, 0, -2} * kUnit, Vec3d{-2.5, 3, -1.5} * kUnit);
    b.material({0x1p-140, 0x1p-130, 0.5});
    b.sphere(Vec3d{2, 1, 0.5} * kUnit, 0.9 * kUnit);
    b.box(Vec3d{-0.5, -1.5, 1} * kUnit, Vec3d{1.5, -0.75, 2} * kUnit);
    b.point_light(Vec3d{-3, 6, 4} * kUnit, {0.7, 0.7, 0.7});
    b.sun({0.4, -1, -0.3}, {0.3, 0.3, 0.3});
    return b;
}

/// How many numbers are there below the normal range, but not 0.
std::ptrdiff_t count_denormals(const std::vector<float>& values) {
    return std::count_if(values.begin(), values.end(),
                         [](float x) { return std::fpclassify(x) == FP_SUBNORMAL; });
}

/// What a scene is to rays at everything in it.
struct Found {
    std::size_t notes = 0;
    std::vector<renderer::Hit<float>> hits;
};

Found look_into(const ir::Scene& scene, renderer::Acceleration acceleration) {
    renderer::PrepareOptions options;
    options.acceleration = acceleration;
    const auto prepared = renderer::prepare<float>(scene, options);
    Found found{prepared.notes.size(), {}};
    renderer::Counters counters;
    for (int i = 0; i < 400; ++i) {
        const Vec3d at = Vec3d{0.3 * (i % 20 - 10), 0.3 * (i / 20 - 10), 0} * 0x1p-130;
        renderer::Ray<float> r;
        r.origin = prepared.to_local(scene.camera.center);
        r.direction = math::normalize(at - scene.camera.center).to<float>();
        found.hits.push_back(closest_hit(prepared, r, {}, counters));
    }
    return found;
}

std::ptrdiff_t count_differences(const Found& a, const Found& b) {
    std::ptrdiff_t differ = 0;
    for (std::size_t i = 0; i < a.hits.size(); ++i) differ += same(a.hits[i], b.hits[i]) ? 0 : 1;
    return differ;
}

/// A heap, the same in another size, and rays at vertices, edges and anywhere, in both.
template <typename T>
struct Scaled {
    SceneMaker one = heap(1);
    SceneMaker other;
    std::vector<std::array<renderer::Ray<T>, 2>> rays;

    /// The directions too, or not: then t is scaled.
    Scaled(int exponent, bool scale_direction) : other(heap(std::ldexp(1.0, exponent))) {
        const auto a = renderer::prepare<T>(one.scene);
        const auto power = static_cast<T>(std::ldexp(1.0, exponent));
        Random random(100);
        for (int i = 0; i < 600; ++i) {
            const auto& v = one.scene.triangles[random.below(24)].keys[0];
            const Vec3d at = i % 3 == 0   ? v[random.below(3)]
                             : i % 3 == 1 ? lerp(v[0], v[1], random.unit())
                                          : random.point(1);
            renderer::Ray<T> r;
            r.origin = a.to_local(random.point(3));
            r.direction = a.to_local(at) - r.origin;
            renderer::Ray<T> s = r;
            s.origin = r.origin * power;
            if (scale_direction) s.direction = r.direction * power;
            rays.push_back({r, s});
        }
    }
};

/// Rays whose hits in a heap of another scale are not the same but for t.
template <typename T>
int scaled_differ(int exponent, bool scale_direction, std::string* cores) {
    const Scaled<T> scaled(exponent, scale_direction);
    const auto a = renderer::prepare<T>(scaled.one.scene);
    Questions<T> q(scaled.other.scene);
    renderer::Counters counters;
    int differ = 0;
    for (const auto& [r, s] : scaled.rays) {
        const auto p = closest_hit(a, r, {}, counters);
        auto hit = q.ask(s);
        if (!scale_direction) hit.t = hit.t / static_cast<T>(std::ldexp(1.0, exponent));
        differ += same(p, hit) ? 0 : 1;
    }
    if (cores != nullptr) *cores = q.differences();
    return differ;
}

/// Rays that do not meet the same object, by kernels that may be wrong.
int scaled_differ_by(const Kernels& kernels) {
    const Scaled<float> scaled(-100, false);
    const auto a = renderer::prepare<float>(scaled.one.scene);
    const auto b = renderer::prepare<float>(scaled.other.scene);
    int differ = 0;
    for (const auto& [r, s] : scaled.rays) {
        differ += kernels(a, r).object == kernels(b, s).object ? 0 : 1;
    }
    return differ;
}

}  // namespace

TEST_CASE("row 43: threads, tiles and instruction sets leave no trace in a picture") {
    SceneBuilder b = everything();
    renderer::Settings s = full(26, 19, 2);
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        s.precision = precision;
        s.tile_size = 32;
        s.acceleration = renderer::Acceleration::kBvh;
        const std::string expected = hash_of(render(b.scene(), s).picture);
        s.acceleration = renderer::Acceleration::kFast;
        for (const std::string& name : renderer::instruction_sets()) {
            CAPTURE(name);
            const WithInstructionSet with(name);
            for (const std::uint32_t threads : {1U, 2U, 3U, 7U}) {
                for (const std::uint32_t tile : {8U, 128U}) {
                    CAPTURE(threads);
                    CAPTURE(tile);
                    s.tile_size = tile;
                    CHECK(hash_of(render(b.scene(), s, threads).picture) == expected);
                }
            }
        }
        record(43, "one hash by " + counted(std::ssize(renderer::instruction_sets())) +
                       " instruction sets, 4 counts of threads, 2 sizes of tiles, " +
                       (precision == renderer::Precision::kFloat ? "float" : "double"));
        // The hash is one of something.
        s.seed = 1;
        CHECK(hash_of(render(b.scene(), s).picture) != expected);
        s.seed = 0;
    }
}

TEST_CASE(
    "row 45: a host that flushes denormals gets the same picture from every instruction set") {
    SceneBuilder b = everything();
    const renderer::Settings s = full(24, 18, 2);
    const std::string expected = hash_of(render(b.scene(), s).picture);
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet with(name);
        check_flushed(b.scene(), s, expected);
    }
}

TEST_CASE("row 45: numbers below the normal range count, whatever the host has set") {
    SceneBuilder b = below_normal();
    renderer::Settings s = full(24, 18, 2);
    s.acceleration = renderer::Acceleration::kBvh;
    const renderer::Picture picture = render(b.scene(), s).picture;
    CHECK(count_denormals(picture.depth.values) > 50);
    CHECK(count_denormals(picture.color.values) > 20);
    const std::string expected = hash_of(picture);
    s.acceleration = renderer::Acceleration::kFast;
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet with(name);
        check_flushed(b.scene(), s, expected);
    }
    // In the host's mode, as it would be if nobody set another, there is something else to see.
    for (const auto acceleration : {renderer::Acceleration::kBvh, renderer::Acceleration::kFast}) {
        const Found kept = look_into(b.scene(), acceleration);
        const auto hits = std::count_if(kept.hits.begin(), kept.hits.end(),
                                        [](const auto& hit) { return bool(hit); });
        CHECK(hits > 50);
        const DenormalsFlushed flushed;
        const Found lost = look_into(b.scene(), acceleration);
        CHECK(lost.notes > kept.notes);
        CHECK(count_differences(kept, lost) == hits);
    }
}

TEST_CASE("row 45: a scene scaled by 2^-100 keeps its hits, by every core") {
    for (const bool scale_direction : {false, true}) {
        CAPTURE(scale_direction);
        std::string cores;
        CHECK(scaled_differ<float>(-100, scale_direction, &cores) == 0);
        CHECK(cores == "");
        CHECK(scaled_differ<double>(-100, scale_direction, &cores) == 0);
        CHECK(cores == "");
        CHECK(scaled_differ<float>(60, scale_direction, nullptr) == 0);
    }
    record(45, "0 of 2,400 hits differ at 2^-100");
    // Kernels that know how small is too small are found.
    CHECK(scaled_differ_by({}) == 0);
    Kernels wrong;
    wrong.triangle = absolute_epsilon;
    CHECK(scaled_differ_by(wrong) > 100);
    wrong = {};
    wrong.sphere = plain_sphere;
    CHECK(scaled_differ_by(wrong) > 100);
}

}  // namespace cobble::test
