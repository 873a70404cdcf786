// SPDX-License-Identifier: MIT
// What the tests of one ray look at, and how it is computed for many rays at once: the divisions of
// eight rays cost little more than those of one.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_RAY_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_RAY_ROWS_INL
#undef COBBLE_RAY_ROWS_INL
#else
#define COBBLE_RAY_ROWS_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// RayShear's axes: kx, ky, kz.
struct ShearAxes {
    std::uint8_t x, y, z;
};

/// A ray as the kernels see it.
template <typename T>
struct RayLanes {
    SlabLanes<T> slabs;
    ShearAxes axes;
    T sx, sy;
    /// 1 over the direction's length and over its square; in float alone.
    T per_length, per_square;
    std::uint32_t signs;  ///< a bit for each axis along which the ray runs backward
    const T* origin;
    const T* direction;
    const T* inverse;  ///< of axis a at [a * stride]
    const T* inverse_far;
    std::size_t stride;
    const bool* parallel;  ///< of RaySlabs; null if along no axis

    /// The forms stay where they are as long as this is used. Without `meets_spheres` what only
    /// their test looks at is left out.
    RayLanes(const RayForms<T>& forms, bool meets_spheres)
        : axes{static_cast<std::uint8_t>(forms.shear.kx), static_cast<std::uint8_t>(forms.shear.ky),
               static_cast<std::uint8_t>(forms.shear.kz)},
          sx(forms.shear.sx),
          sy(forms.shear.sy),
          per_length(0),
          per_square(0),
          signs(0),
          origin(&forms.slabs.origin.x),
          direction(&forms.shear.direction.x),
          inverse(&forms.slabs.inverse.x),
          inverse_far(&forms.slabs.inverse_far.x),
          stride(1),
          parallel(forms.slabs.any_parallel ? forms.slabs.parallel : nullptr) {
        for (std::uint32_t a = 0; a < 3; ++a) signs |= std::uint32_t{forms.slabs.negative[a]} << a;
        if (meets_spheres) {
            const T square = (direction[0] * direction[0] + direction[1] * direction[1]) +
                             direction[2] * direction[2];
            per_square = 1 / square;
            per_length = 1 / std::sqrt(square);
        }
        spread();
    }

    RayLanes(const T* from, const T* along, const T* inverses, const T* far_inverses,
             std::size_t step, std::uint32_t backward, ShearAxes of_shear, T x, T y, T over_length,
             T over_square)
        : axes(of_shear),
          sx(x),
          sy(y),
          per_length(over_length),
          per_square(over_square),
          signs(backward),
          origin(from),
          direction(along),
          inverse(inverses),
          inverse_far(far_inverses),
          stride(step),
          parallel(nullptr) {
        spread();
    }

  private:
    HWY_INLINE void spread() {
        const typename SlabLanes<T>::D d;
        for (std::size_t a = 0; a < 3; ++a) {
            slabs.origin[a] = hn::Set(d, origin[a]);
            slabs.inverse[a] = hn::Set(d, inverse[a * stride]);
            slabs.inverse_far[a] = hn::Set(d, inverse_far[a * stride]);
        }
        slabs.rows = &kSlabRows<T>[signs];
    }
};

/// RayForms, computed when something first asks for them.
template <typename T>
class FormsOnDemand {
  public:
    explicit FormsOnDemand(const Ray<T>& ray) : ray_(&ray) {}
    explicit FormsOnDemand(const RayForms<T>& forms) : forms_(&forms) {}

    const RayForms<T>& get() {
        if (forms_ == nullptr) forms_ = &own_.emplace(ray_->origin, ray_->direction);
        return *forms_;
    }

  private:
    const Ray<T>* ray_ = nullptr;
    const RayForms<T>* forms_ = nullptr;
    std::optional<RayForms<T>> own_;
};

/// RayLanes of up to kRays rays: the arithmetic of RaySlabs and RayShear, a lane each.
template <typename T>
class RayRows {
  public:
    static constexpr std::size_t kRays = 16;

    RayRows(const Ray<T>* rays, std::size_t count) : rays_(rays) {
        alignas(64) T direction[3][kRays];
        for (std::size_t i = 0; i < kRays; ++i) {
            const Ray<T>& ray = rays[i < count ? i : 0];
            direction[0][i] = ray.direction.x;
            direction[1][i] = ray.direction.y;
            direction[2][i] = ray.direction.z;
        }
        for (std::size_t at = 0; at < kRays; at += kLanes) fill(direction, at);
    }

    /// It runs along an axis, or nearly so: its rows mean nothing.
    [[nodiscard]] bool odd(std::size_t i) const { return codes_[i] >= kOdd; }

    /// Not for odd ones. Refers to this.
    [[nodiscard]] HWY_INLINE RayLanes<T> lanes(std::size_t i) const {
        const auto code = static_cast<std::uint32_t>(codes_[i]);
        return {&rays_[i].origin.x,
                &rays_[i].direction.x,
                &inverse_[0][i],
                &inverse_far_[0][i],
                kRays,
                code & 7,
                kAxes[code >> 3],
                sx_[i],
                sy_[i],
                sizeof(T) == sizeof(float) ? per_length_[i] : T(0),
                sizeof(T) == sizeof(float) ? per_square_[i] : T(0)};
    }

  private:
    // No more than this: the widest registers slow down what comes after them.
    using D = hn::CappedTag<T, 8>;
    using DU = hn::RebindToUnsigned<D>;
    using U = hn::TFromD<DU>;
    static constexpr std::size_t kLanes = hn::MaxLanes(D());
    static constexpr U kOdd = 64;
    /// By the main axis and, from 4 on, if the ray runs against it.
    static constexpr ShearAxes kAxes[] = {{1, 2, 0}, {2, 0, 1}, {0, 1, 2}, {},
                                          {2, 1, 0}, {0, 2, 1}, {1, 0, 2}, {}};

    HWY_INLINE void fill(const T (&direction)[3][kRays], std::size_t at) {
        const D d;
        const DU du;
        const auto zero = hn::Zero(d);
        const auto most = hn::Set(d, std::numeric_limits<T>::max());
        const auto flag = [&](auto mask, U value) HWY_ATTR {
            return hn::IfThenElseZero(hn::RebindMask(du, mask), hn::Set(du, value));
        };
        auto code = hn::Zero(du);
        for (std::size_t a = 0; a < 3; ++a) {
            const auto inverse = hn::Div(hn::Set(d, T(1)), hn::Load(d, direction[a] + at));
            const auto inverse_far = hn::Mul(inverse, hn::Set(d, kFarSlack<T>));
            const auto odd = hn::Not(hn::Le(hn::Abs(inverse_far), most));
            code = hn::Or(code, hn::Or(flag(odd, kOdd), flag(hn::Lt(inverse, zero), U{1} << a)));
            hn::Store(inverse, d, inverse_[a] + at);
            hn::Store(inverse_far, d, inverse_far_[a] + at);
        }
        const auto x = hn::Load(d, direction[0] + at);
        const auto y = hn::Load(d, direction[1] + at);
        const auto z = hn::Load(d, direction[2] + at);
        if constexpr (sizeof(T) == sizeof(float)) {
            const auto square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
            const auto one = hn::Set(d, T(1));
            hn::Store(hn::Div(one, square), d, per_square_ + at);
            hn::Store(hn::Div(one, hn::Sqrt(square)), d, per_length_ + at);
        }
        const auto x_over_y = hn::Gt(hn::Abs(x), hn::Abs(y));
        const auto main_x = hn::And(x_over_y, hn::Gt(hn::Abs(x), hn::Abs(z)));
        const auto main_y = hn::And(hn::Not(x_over_y), hn::Gt(hn::Abs(y), hn::Abs(z)));
        const auto of_main = [&](auto if_x, auto if_y, auto if_z) HWY_ATTR {
            return hn::IfThenElse(main_x, if_x, hn::IfThenElse(main_y, if_y, if_z));
        };
        const auto along = of_main(x, y, z);
        const auto next = of_main(y, z, x);
        const auto after = of_main(z, x, y);
        const auto backward = hn::Lt(along, zero);
        code = hn::Or(code, hn::Or(flag(main_y, U{1} << 3), flag(backward, U{4} << 3)));
        code = hn::Or(code, flag(hn::Not(hn::Or(main_x, main_y)), U{2} << 3));
        hn::Store(code, du, codes_ + at);
        const auto slope = [&](auto across) HWY_ATTR {
            const auto s = hn::Div(across, along);
            return hn::IfThenElseZero(hn::Ge(hn::Abs(s), hn::Set(d, detail::kEdgeThreshold<T>)), s);
        };
        hn::Store(slope(hn::IfThenElse(backward, after, next)), d, sx_ + at);
        hn::Store(slope(hn::IfThenElse(backward, next, after)), d, sy_ + at);
    }

    const Ray<T>* rays_;
    alignas(64) T inverse_[3][kRays];
    alignas(64) T inverse_far_[3][kRays];
    alignas(64) T sx_[kRays];
    alignas(64) T sy_[kRays];
    alignas(64) T per_length_[kRays];
    alignas(64) T per_square_[kRays];
    /// The signs, the place in kAxes, and kOdd, packed.
    alignas(64) U codes_[kRays];
};

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
