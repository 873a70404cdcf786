// SPDX-License-Identifier: MIT
#include "renderer/wide/wide.hpp"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/wide/wide.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h, as Highway wants it.
#include "renderer/wide/single-inl.hpp"
#if HWY_TARGET != HWY_SCALAR
#include "renderer/wide/gather-inl.hpp"
#include "renderer/wide/packet_walk-inl.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

template <bool kAny, typename T>
void search_singly(const WideQuery<T>& q, std::size_t first, std::size_t count, Hit<T>* hits,
                   Counters& counters) {
    if (q.rays != nullptr) {
        search_singly<kAny>(*q.geometry, q.rays + first, q.excludes + first, count, hits + first,
                            counters);
        return;
    }
    constexpr std::size_t kAtOnce = 64;
    std::array<Ray<T>, kAtOnce> rays;
    std::array<Exclude, kAtOnce> excludes;
    for (const std::size_t end = first + count; first < end; first += kAtOnce) {
        const std::size_t some = std::min(kAtOnce, end - first);
        for (std::size_t i = 0; i < some; ++i) {
            rays[i] = q.columns->ray(first + i);
            excludes[i] = q.columns->exclude(first + i);
        }
        search_singly<kAny>(*q.geometry, rays.data(), excludes.data(), some, hits + first,
                            counters);
    }
}

#if HWY_TARGET == HWY_SCALAR
/// With one lane there is nothing that packets could share.
template <bool kAny>
void search_packets(const WideQuery<float>& q, Hit<float>* hits, Counters& counters) {
    search_singly<kAny>(q, 0, q.count, hits, counters);
}
#else
template <bool kAny>
void search_packets(const WideQuery<float>& q, Hit<float>* hits, Counters& counters) {
    Packet packet;
    // After a packet that fell apart, so many others of the call are not tried.
    constexpr std::size_t kPause = 7;
    std::size_t pause = 0;
    std::size_t count = 0;
    for (std::size_t first = 0; first < q.count; first += count) {
        count = std::min(kPacketRays, q.count - first);
        if (pause > 0) {
            --pause;
            search_singly<kAny>(q, first, count, hits, counters);
            continue;
        }
        std::size_t alike = 0;
        if (count >= kFewestTogether) alike = gather<kAny>(q, first, count, hits + first, packet);
        // The next packet begins with the first ray that goes another way.
        while (alike >= kFewestTogether && alike < count) {
            count = alike;
            alike = gather<kAny>(q, first, count, hits + first, packet);
        }
        if (alike < kFewestTogether) {
            search_singly<kAny>(q, first, count, hits, counters);
            continue;
        }
        test_planes<kAny>(*q.geometry, packet);
        const bool found = walk_packet<kAny>(*q.geometry, packet);
        counters.box_tests += packet.box_tests;
        counters.primitive_tests += packet.primitive_tests;
        if (!found) {
            pause = kPause;
            search_singly<kAny>(q, first, count, hits, counters);
            continue;
        }
        counters.packet_rays += count;
        if (kAny && !packet.stayed_together()) pause = kPause;
    }
}
#endif

void search_float(const WideQuery<float>& q, Hit<float>* hits, Counters& counters) {
    if (q.coherent) {
        if (q.any) {
            search_packets<true>(q, hits, counters);
        } else {
            search_packets<false>(q, hits, counters);
        }
    } else if (q.any) {
        search_singly<true>(q, 0, q.count, hits, counters);
    } else {
        search_singly<false>(q, 0, q.count, hits, counters);
    }
}

void search_double(const WideQuery<double>& q, Hit<double>* hits, Counters& counters) {
    if (q.any) {
        search_singly<true>(q, 0, q.count, hits, counters);
    } else {
        search_singly<false>(q, 0, q.count, hits, counters);
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cobble::renderer {

HWY_EXPORT(search_float);
HWY_EXPORT(search_double);

void search_wide(const WideQuery<float>& query, Hit<float>* hits, Counters& counters) {
    HWY_DYNAMIC_DISPATCH(search_float)(query, hits, counters);
}
void search_wide(const WideQuery<double>& query, Hit<double>* hits, Counters& counters) {
    HWY_DYNAMIC_DISPATCH(search_double)(query, hits, counters);
}

}  // namespace cobble::renderer
#endif
