// SPDX-License-Identifier: MIT
// Loops over columns by themselves, at every instruction set: what is too rare to be in a picture.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "renderer/film/accumulator.hpp"
#include "renderer/integrator/column_loops.hpp"
#include "renderer/sampling/hash.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/with_instruction_set.hpp"

using namespace cobble;
using namespace cobble::test;
using namespace cobble::renderer;

namespace {

/// Even in [-1, 1).
double number(std::uint64_t key) { return static_cast<double>(mix64(key) >> 11U) * 0x1p-52 - 1; }

template <typename T>
bool same_bits(math::Vec3<T> a, math::Vec3<T> b) {
    const auto same = [](T x, T y) { return x == y && std::signbit(x) == std::signbit(y); };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// One direction of 2^17 is not what the quick way gives at first.
constexpr std::uint64_t kDirections = std::uint64_t{1} << 19U;

/// Runs `check` on batches of columns that are as large as any, at each instruction set.
template <typename Check>
void at_every_set(Check check) {
    for (const std::string& name : instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet only(name);
        check();
    }
}

template <typename T>
void check_sums(std::size_t samples) {
    const auto colors = std::make_unique<Columns3<T>>();
    const auto sums = std::make_unique<PixelSums>();
    const std::size_t pixels = kBatchSize / samples;
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        // Sizes far apart, some that cancel what came before, some a zero of either sign.
        const auto size = static_cast<T>(std::ldexp(number(3 * i), static_cast<int>(i * 7 % 71)));
        const T cancels = i % 3 == 2 ? -colors->x[i - 1] : size;
        colors->set(i, {cancels, i % 5 == 0 ? T(-0.0) : size, T(-0.0)});
    }
    column_loops<T>().sum_pixels(*colors, samples, pixels, *sums);
    int wrong = 0;
    int with_rest = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
        CompensatedSum x, y, z;
        for (std::size_t k = 0; k < samples; ++k) {
            const math::Vec3<T> color = colors->at(p * samples + k);
            x.add(0.0 + static_cast<double>(color.x));
            y.add(0.0 + static_cast<double>(color.y));
            z.add(0.0 + static_cast<double>(color.z));
        }
        wrong += same_bits(sums->sum.at(p), Vec3d{x.sum(), y.sum(), z.sum()}) ? 0 : 1;
        wrong += same_bits(sums->rest.at(p), Vec3d{x.rest(), y.rest(), z.rest()}) ? 0 : 1;
        with_rest += x.rest() != 0 ? 1 : 0;
    }
    CHECK(wrong == 0);
    if (samples > 8) CHECK(with_rest > 0);
}

}  // namespace

TEST_CASE("loops over columns point to lights as their definition does") {
    PreparedLight light;
    light.position = {0.3, 2, -0.7};
    light.color = {1, 1, 1};
    const auto hits = std::make_unique<HitColumns<float>>();
    const auto answers = std::make_unique<LightColumns<float>>();
    at_every_set([&] {
        int wrong = 0;
        for (std::uint64_t first = 0; first < kDirections; first += kBatchSize) {
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                const std::uint64_t key = 3 * (first + i);
                hits->position.set(
                    i, Vec3d{number(key), number(key + 1), number(key + 2)}.to<float>());
            }
            column_loops<float>().to_point_light(light, *hits, *answers, kBatchSize);
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                const Vec3d to = light.position - hits->position.at(i).to<double>();
                wrong += same_bits(answers->direction.at(i), normalize(to).to<float>()) ? 0 : 1;
            }
        }
        CHECK(wrong == 0);
    });
}

TEST_CASE("loops over columns go through a pinhole as their definition does") {
    SceneBuilder b;
    const PreparedCamera camera(b.camera({0, 0, 0}, {0.3, -0.2, -1}, 1).scene().camera, 640, 480);
    const auto samples = std::make_unique<CameraColumns>();
    const auto directions = std::make_unique<Columns3<float>>();
    at_every_set([&] {
        int wrong = 0;
        for (std::uint64_t first = 0; first < kDirections; first += kBatchSize) {
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                samples->x[i] = 320 + 320 * number(2 * (first + i));
                samples->y[i] = 240 + 240 * number(2 * (first + i) + 1);
            }
            column_loops<float>().through_pinhole(camera, *samples, *directions, kBatchSize);
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                const CameraRay ray = camera.pinhole(samples->x[i], samples->y[i]);
                wrong += same_bits(directions->at(i), ray.direction.to<float>()) ? 0 : 1;
            }
        }
        CHECK(wrong == 0);
    });
}

TEST_CASE_TEMPLATE("loops over columns add pixels up as the film does", T, float, double) {
    at_every_set([] {
        for (const std::size_t samples : {1U, 3U, 16U, 42U, 128U}) {
            CAPTURE(samples);
            check_sums<T>(samples);
        }
    });
}

TEST_CASE_TEMPLATE("loops over columns find the one that is no number", T, float, double) {
    const auto columns = std::make_unique<Columns3<T>>();
    for (std::size_t i = 0; i < kBatchSize; ++i) columns->set(i, {T(1), T(-2), T(0)});
    columns->x[5] = std::numeric_limits<T>::max();
    columns->y[6] = std::numeric_limits<T>::lowest();
    at_every_set([&] {
        CHECK(column_loops<T>().all_finite(*columns, kBatchSize));
        int missed = 0;
        for (const T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                            -std::numeric_limits<T>::infinity()}) {
            for (std::size_t i = 0; i < 3 * kBatchSize; ++i) {
                T* const axes[] = {columns->x, columns->y, columns->z};
                T& place = axes[i % 3][i / 3];
                const T before = place;
                place = bad;
                missed += column_loops<T>().all_finite(*columns, kBatchSize) ? 1 : 0;
                place = before;
            }
        }
        CHECK(missed == 0);
    });
}
