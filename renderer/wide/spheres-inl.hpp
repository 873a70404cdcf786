// SPDX-License-Identifier: MIT
// A block of spheres at once.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SPHERES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SPHERES_INL
#undef COBBLE_SPHERES_INL
#else
#define COBBLE_SPHERES_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

template <class D, class V = hn::Vec<D>>
HWY_INLINE V dot_lanes(D, V x0, V y0, V z0, V x1, V y1, V z1) {
    return hn::Add(hn::Add(hn::Mul(x0, x1), hn::Mul(y0, y1)), hn::Mul(z0, z1));
}

/// The lanes of a block that belong to an object.
template <typename T>
HWY_INLINE std::uint32_t spheres_of(const SphereBlock<T>& block, ir::ObjectId object) {
    using D = hn::CappedTag<std::uint32_t, kSphereLanes>;
    const D d;
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kSphereLanes; part += hn::MaxLanes(D())) {
        const auto of = hn::Load(d, &block.object[part].value);
        bits |= bits_of(d, hn::Eq(of, hn::Set(d, object.value))) << part;
    }
    return bits;
}
/// The lanes that hold a sphere.
template <typename T>
HWY_INLINE std::uint32_t all_spheres(const SphereBlock<T>& block) {
    return ~spheres_of(block, {}) & ((1U << kSphereLanes) - 1);
}

/// What float tells of a block of spheres.
struct SphereGuess {
    std::uint32_t open;  ///< may hold a better hit: all others surely do not
    std::uint32_t sure;  ///< those of them that surely are hits, were nothing nearer
    /// The t of the sure ones: not below, not above.
    alignas(32) float least[kSphereLanes];
    alignas(32) float most[kSphereLanes];
};

/// Left open are those that are not surely missed, behind, too far, or what the ray leaves for the
/// outside. In float, with room for what float rounds away.
///
/// With f from the centre to the origin, u half the distance from 1 to the next number, l from the
/// centre to where the line comes nearest, and lengths in units of the direction's: f is off by 1 u
/// of itself and the nearest t by 9 u |f|, so that l is off by less than 24 u |f| and its square by
/// less than 51 u f^2. Half of what the line spans inside is the root of r^2 - l^2: with 64 u
/// (f^2 + r^2) added or taken away it is too wide or too narrow by at least 13 u f^2 / 2 h, and 64
/// u of itself, h, more. The least that both can be together is 40 u |f|, well above the error of
/// the nearest t, of the slabs of the sphere's box and of the sums here.
HWY_INLINE void guess_spheres(const SphereBlock<float>& block, const RayLanes<float>& ray,
                              Search<float>& search, SphereGuess& guess) {
    using D = hn::CappedTag<float, kSphereLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    constexpr float kSlack = 64 * kRounding<float>;
    const std::uint32_t there = all_spheres(block);
    search.primitive_tests += hwy::PopCount(there);
    guess.open = there;
    guess.sure = 0;
    // Beyond these the bounds above do not hold.
    if (!(ray.per_square >= 0x1p-100F && ray.per_square <= 0x1p100F)) return;
    guess.open = 0;
    const std::uint32_t left = spheres_of(block, search.exclude.object);
    const float* const v = ray.direction;
    const auto inverse = hn::Set(d, ray.per_square);
    const auto inverse_length = hn::Set(d, ray.per_length);
    const auto dx = hn::Set(d, v[0]);
    const auto dy = hn::Set(d, v[1]);
    const auto dz = hn::Set(d, v[2]);
    const auto slack = hn::Set(d, kSlack);
    const auto zero = hn::Zero(d);
    const auto t_min = hn::Set(d, search.t_min);
    const auto best = hn::Set(d, search.best.t);
    for (std::size_t part = 0; part < kSphereLanes; part += kLanes) {
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::Set(d, ray.origin[axis]), hn::Load(d, block.center[axis] + part));
        };
        const auto fx = relative(0);
        const auto fy = relative(1);
        const auto fz = relative(2);
        const auto r = hn::Load(d, block.radius + part);
        const auto q = hn::Mul(hn::Neg(dot_lanes(d, fx, fy, fz, dx, dy, dz)), inverse);
        const auto lx = hn::Add(fx, hn::Mul(dx, q));
        const auto ly = hn::Add(fy, hn::Mul(dy, q));
        const auto lz = hn::Add(fz, hn::Mul(dz, q));
        const auto square = hn::Mul(r, r);
        const auto rest = hn::Sub(square, dot_lanes(d, lx, ly, lz, lx, ly, lz));
        const auto off =
            hn::Add(hn::Mul(slack, hn::Add(dot_lanes(d, fx, fy, fz, fx, fy, fz), square)),
                    hn::Set(d, std::numeric_limits<float>::min()));
        const auto most = hn::Add(rest, off);
        const auto least = hn::Sub(rest, off);
        const auto missed = hn::And(hn::Lt(most, zero),
                                    hn::Ge(most, hn::Set(d, std::numeric_limits<float>::lowest())));
        if (hn::AllTrue(d, missed)) continue;
        const auto meets = hn::Gt(least, zero);
        // What is no number stays none, and leaves the lane open.
        const auto half =
            hn::Mul(hn::Sqrt(hn::IfThenZeroElse(hn::Lt(most, zero), most)), inverse_length);
        const auto inner_half = hn::Mul(hn::Sqrt(hn::IfThenElseZero(meets, least)), inverse_length);
        const auto wide = hn::Mul(slack, hn::Add(hn::Abs(q), half));
        const auto outer = hn::Add(half, wide);
        const auto inner = hn::Sub(inner_half, wide);
        const auto near_least = hn::Sub(q, outer);
        const auto near_most = hn::Sub(q, inner);
        const auto far_least = hn::Add(q, inner);
        const auto far_most = hn::Add(q, outer);
        const auto out = hn::Or(missed, hn::Or(hn::Gt(near_least, best), hn::Lt(far_most, t_min)));
        guess.open |= bits_of(d, hn::Not(out)) << part;
        const auto leaves = mask_of(d, left >> part);
        const auto enters = hn::AndNot(leaves, hn::Gt(near_least, t_min));
        const auto decided = hn::Or(enters, hn::Or(leaves, hn::Le(near_most, t_min)));
        const auto t_least = hn::IfThenElse(enters, near_least, far_least);
        const auto t_most = hn::IfThenElse(enters, near_most, far_most);
        hn::Store(t_least, d, guess.least + part);
        hn::Store(t_most, d, guess.most + part);
        const auto sure =
            hn::And(hn::And(meets, decided), hn::And(hn::Gt(t_least, t_min), hn::Lt(t_most, best)));
        guess.sure |= bits_of(d, sure) << part;
    }
    guess.open &= search.exclude.goes_inside ? there : there & ~left;
    guess.sure &= guess.open;
}

template <typename T>
HWY_INLINE void test_lane(const SphereBlock<T>& block, std::size_t lane, FormsOnDemand<T>& forms,
                          Search<T>& search) {
    test_sphere(forms.get(), {block.center[0][lane], block.center[1][lane], block.center[2][lane]},
                block.radius[lane], block.object[lane], search);
}

/// The nearest sphere so far, as float has it: its t is not computed before something comes near.
class WaitingSphere {
  public:
    /// The closest hit of a block.
    HWY_INLINE void meet(const SphereBlock<float>& block, const RayLanes<float>& ray,
                         FormsOnDemand<float>& forms, Search<float>& search) {
        SphereGuess guess;
        guess_spheres(block, ray, search, guess);
        std::uint32_t bits = guess.open;
        while (bits != 0) {
            const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
            bits &= bits - 1;
            if (HWY_LIKELY((guess.sure >> i & 1) != 0)) {
                const float nearest = block_ != nullptr ? least_ : search.best.t;
                if (guess.most[i] < nearest) {
                    block_ = &block;
                    lane_ = i;
                    least_ = guess.least[i];
                    search.best.t = guess.most[i];
                    continue;
                }
                if (guess.least[i] > search.best.t) continue;
            }
            settle(forms, search);
            test_lane(block, i, forms, search);
        }
    }
    /// Computes what waits.
    HWY_INLINE void settle(FormsOnDemand<float>& forms, Search<float>& search) {
        if (block_ == nullptr) return;
        // It is nearer than what it has put aside.
        search.best.t = std::numeric_limits<float>::max();
        search.best.object = {};
        test_lane(*block_, lane_, forms, search);
        block_ = nullptr;
    }

  private:
    const SphereBlock<float>* block_ = nullptr;
    std::size_t lane_ = 0;
    float least_ = 0;
};

/// True if any hit is asked for and found.
template <bool kAny, typename T>
HWY_INLINE bool test_spheres(const SphereBlock<T>& block, const RayLanes<T>& ray,
                             FormsOnDemand<T>& forms, Search<T>& search) {
    std::uint32_t bits;
    if constexpr (sizeof(T) == sizeof(float)) {
        SphereGuess guess;
        guess_spheres(block, ray, search, guess);
        bits = guess.open;
        if (kAny && guess.sure != 0) {
            search.best.object = block.object[hwy::Num0BitsBelowLS1Bit_Nonzero32(guess.sure)];
            return true;
        }
    } else {
        bits = all_spheres(block);
    }
    while (bits != 0) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        test_lane(block, i, forms, search);
        if (kAny && search.best.object.valid()) return true;
    }
    return false;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
