// SPDX-License-Identifier: MIT
// Sums of samples, in sample order, and the pixel that comes of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "ir/math/vec.hpp"

namespace cobble::renderer {

/// A sum that keeps what each addition rounds away (Neumaier, ZAMM 54, 1974; here with Knuth's sum
/// of two, which has the same exact rest without asking which of them is larger). A plain sum of a
/// million equal numbers is off by 1e-11 of itself; this one by 2 ulp, however long.
class CompensatedSum {
  public:
    CompensatedSum() = default;
    /// One that was kept elsewhere.
    CompensatedSum(double sum, double rest) : sum_(sum), rest_(rest) {}

    void add(double value) {
        const double sum = sum_ + value;
        // What did not fit into `sum`, exactly (Knuth, The Art of Computer Programming, 4.2.2).
        const double added = sum - sum_;
        rest_ += (sum_ - (sum - added)) + (value - added);
        sum_ = sum;
    }
    [[nodiscard]] double value() const { return sum_ + rest_; }
    [[nodiscard]] double sum() const { return sum_; }
    [[nodiscard]] double rest() const { return rest_; }

  private:
    double sum_ = 0;
    double rest_ = 0;
};

class CompensatedSum3 {
  public:
    CompensatedSum3() = default;
    CompensatedSum3(CompensatedSum x, CompensatedSum y, CompensatedSum z) : x_(x), y_(y), z_(z) {}

    void add(math::Vec3d value) {
        x_.add(value.x);
        y_.add(value.y);
        z_.add(value.z);
    }
    [[nodiscard]] math::Vec3d value() const { return {x_.value(), y_.value(), z_.value()}; }

  private:
    CompensatedSum x_, y_, z_;
};

/// What one sample of a pixel saw.
struct Sample {
    math::Vec3d color;
    bool hit = false;
    double depth = 0;    ///< distance along the camera ray; read only if `hit`
    math::Vec3d normal;  ///< shading normal; 0 0 0 unless `hit`
    math::Vec3d albedo;  ///< surface colour before lighting; 0 0 0 unless `hit`
};

/// A finished pixel.
struct Pixel {
    math::Vec3d color;
    double depth = std::numeric_limits<double>::infinity();
    math::Vec3d normal;
    math::Vec3d albedo;
    std::uint32_t samples = 0;  ///< those that count
    std::uint32_t hits = 0;     ///< those of them that hit something
};

/// Colour, normal and albedo are means over all samples; depth is the mean over those that hit.
class PixelAccumulator {
  public:
    /// False, and nothing added, if any number of the sample is NaN or infinite.
    [[nodiscard]] bool add(const Sample& sample) {
        if (!finite(sample.color) || !finite(sample.normal) || !finite(sample.albedo) ||
            (sample.hit && !std::isfinite(sample.depth))) {
            return false;
        }
        ++samples_;
        color_.add(sample.color);
        if (sample.hit) {
            ++hits_;
            depth_.add(sample.depth);
            normal_.add(sample.normal);
            albedo_.add(sample.albedo);
        }
        return true;
    }

    /// add() of a sample whose other pictures nobody wants, and which are sound if its colour is.
    [[nodiscard]] bool add_color(math::Vec3d color) {
        if (!finite(color)) return false;
        ++samples_;
        color_.add(color);
        return true;
    }

    [[nodiscard]] Pixel pixel() const {
        Pixel result;
        result.samples = samples_;
        if (samples_ > 0) {
            const double n = samples_;
            result.color = color_.value() / n;
            result.normal = normal_.value() / n;
            result.albedo = albedo_.value() / n;
        }
        result.hits = hits_;
        if (hits_ > 0) result.depth = depth_.value() / static_cast<double>(hits_);
        return result;
    }

  private:
    CompensatedSum3 color_, normal_, albedo_;
    CompensatedSum depth_;
    std::uint32_t samples_ = 0;
    std::uint32_t hits_ = 0;
};

}  // namespace cobble::renderer
