// SPDX-License-Identifier: MIT
#include "tools/bench/rays/embree_core.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

namespace cobble::bench {

namespace {

/// The types and calls for packets of N; for N = 1 the single ray's.
template <unsigned N>
struct Calls;

template <>
struct Calls<1> {
    using RayType = RTCRay;
    using RayHitType = RTCRayHit;
    static void closest(const int*, RTCScene s, RTCIntersectContext* c, RTCRayHit* r) {
        rtcIntersect1(s, c, r);
    }
    static void any(const int*, RTCScene s, RTCIntersectContext* c, RTCRay* r) {
        rtcOccluded1(s, c, r);
    }
};
template <>
struct Calls<8> {
    using RayType = RTCRay8;
    using RayHitType = RTCRayHit8;
    static void closest(const int* v, RTCScene s, RTCIntersectContext* c, RTCRayHit8* r) {
        rtcIntersect8(v, s, c, r);
    }
    static void any(const int* v, RTCScene s, RTCIntersectContext* c, RTCRay8* r) {
        rtcOccluded8(v, s, c, r);
    }
};
template <>
struct Calls<16> {
    using RayType = RTCRay16;
    using RayHitType = RTCRayHit16;
    static void closest(const int* v, RTCScene s, RTCIntersectContext* c, RTCRayHit16* r) {
        rtcIntersect16(v, s, c, r);
    }
    static void any(const int* v, RTCScene s, RTCIntersectContext* c, RTCRay16* r) {
        rtcOccluded16(v, s, c, r);
    }
};

/// Our rays leave out their ends and Embree's do not, so that one from a surface would meet it at
/// 0.
float nearest(float t_min) { return t_min > 0 ? t_min : std::numeric_limits<float>::min(); }

/// Rays in packets, the last one filled up with copies that `valid` leaves out.
template <unsigned N>
struct Packets {
    std::vector<typename Calls<N>::RayType> rays;
    std::size_t count = 0;

    template <typename T>
    explicit Packets(const RaySet<T>& set) : count(set.rays.size()) {
        rays.resize((count + N - 1) / N);
        for (std::size_t i = 0; i < rays.size() * N; ++i) {
            const auto& ray = set.rays[i < count ? i : count - 1];
            // A packet is N floats for each field, in the order of RTCRay's own.
            const float fields[12] = {static_cast<float>(ray.origin.x),
                                      static_cast<float>(ray.origin.y),
                                      static_cast<float>(ray.origin.z),
                                      nearest(static_cast<float>(ray.t_min)),
                                      static_cast<float>(ray.direction.x),
                                      static_cast<float>(ray.direction.y),
                                      static_cast<float>(ray.direction.z),
                                      0.0F,
                                      static_cast<float>(ray.t_max),
                                      0,
                                      0,
                                      0};
            auto* const packet = reinterpret_cast<unsigned char*>(&rays[i / N]);
            for (std::size_t f = 0; f < 12; ++f) {
                std::memcpy(packet + (f * N + i % N) * sizeof(float), &fields[f], sizeof(float));
            }
            const unsigned mask = 0xffffffffU;
            std::memcpy(packet + (9 * N + i % N) * sizeof(float), &mask, sizeof(mask));
        }
    }
};

RTCIntersectContext context_for(bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

template <unsigned N>
std::uint64_t trace(RTCScene scene, const Packets<N>& packets, RayKind kind, std::size_t begin,
                    std::size_t end) {
    const FlushDenormals flush;
    RTCIntersectContext context = context_for(kind.coherent);
    alignas(64) int valid[N];
    for (int& v : valid) v = -1;
    std::uint64_t hits = 0;
    for (std::size_t i = begin; i < end; i += N) {
        const std::size_t live = end - i < N ? end - i : N;
        if (live < N) {
            for (std::size_t k = 0; k < N; ++k) valid[k] = k < live ? -1 : 0;
        }
        if (kind.any) {
            auto ray = packets.rays[i / N];
            Calls<N>::any(valid, scene, &context, &ray);
            const auto* const far = reinterpret_cast<const float*>(&ray) + std::size_t{8} * N;
            for (std::size_t k = 0; k < live; ++k) hits += far[k] < 0 ? 1 : 0;
        } else {
            typename Calls<N>::RayHitType both;
            both.ray = packets.rays[i / N];
            auto* const geometry = &both.hit.geomID;
            std::memset(static_cast<void*>(geometry), 0xff, sizeof(both.hit.geomID));
            Calls<N>::closest(valid, scene, &context, &both);
            const auto* const ids = reinterpret_cast<const unsigned*>(geometry);
            for (std::size_t k = 0; k < live; ++k) hits += ids[k] != RTC_INVALID_GEOMETRY_ID;
        }
    }
    return hits;
}

template <unsigned N, typename T>
void add_contestants(const EmbreeScene& robust, const EmbreeScene& fast, const RaySet<T>& rays,
                     std::vector<Contestant>& to) {
    const auto packets = std::make_shared<const Packets<N>>(rays);
    const auto add = [&](const char* name, RTCScene scene) {
        to.push_back({name + std::to_string(N), 1, {}, [=, kind = rays.kind](auto begin, auto end) {
                          return trace<N>(scene, *packets, kind, begin, end);
                      }});
    };
    add("embree-robust-", robust.scene());
    add("embree-fast-", fast.scene());
}

}  // namespace

template <typename T>
std::vector<Contestant> embree_contestants(const EmbreeScene& robust, const EmbreeScene& fast,
                                           const RaySet<T>& rays) {
    std::vector<Contestant> contestants;
    add_contestants<1>(robust, fast, rays, contestants);
    if (rays.kind.coherent) {
        add_contestants<8>(robust, fast, rays, contestants);
        add_contestants<16>(robust, fast, rays, contestants);
    }
    return contestants;
}

template <typename T>
Disagreement count_disagreements(const EmbreeScene& scene, const RaySet<T>& rays) {
    const FlushDenormals flush;
    const Packets<1> packets(rays);
    RTCIntersectContext context = context_for(false);
    Disagreement result;
    for (std::size_t i = 0; i < packets.rays.size(); ++i) {
        RTCRayHit both;
        both.ray = packets.rays[i];
        both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        bool hit = false;
        if (rays.kind.any) {
            rtcOccluded1(scene.scene(), &context, &both.ray);
            hit = both.ray.tfar < 0;
        } else {
            rtcIntersect1(scene.scene(), &context, &both);
            hit = both.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        const auto& want = rays.expected[i];
        if (hit != want.object.valid()) {
            ++result.hits;
        } else if (hit && !rays.kind.any &&
                   std::fabs(both.ray.tfar - static_cast<float>(want.t)) >
                       1e-3F * static_cast<float>(want.t)) {
            ++result.distances;
        }
    }
    return result;
}

template std::vector<Contestant> embree_contestants(const EmbreeScene&, const EmbreeScene&,
                                                    const RaySet<float>&);
template std::vector<Contestant> embree_contestants(const EmbreeScene&, const EmbreeScene&,
                                                    const RaySet<double>&);
template Disagreement count_disagreements(const EmbreeScene&, const RaySet<float>&);
template Disagreement count_disagreements(const EmbreeScene&, const RaySet<double>&);

}  // namespace cobble::bench
