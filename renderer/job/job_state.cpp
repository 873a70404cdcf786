// SPDX-License-Identifier: MIT
#include "renderer/job/job_state.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include "renderer/job/state_bytes.hpp"

namespace cobble::renderer {
namespace {

constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kNoObject = ~0U;

constexpr std::string_view kSize = "size";
constexpr std::string_view kDone = "done";
constexpr std::string_view kPlan = "plan";
constexpr std::string_view kKindOfSums = "kind-of-sums";
constexpr std::string_view kSums = "sums";
constexpr std::string_view kTally = "tally";

struct NamedPlane {
    std::string_view name;
    Plane32 Picture::*plane;
};
constexpr NamedPlane kPlanes[] = {{"color", &Picture::color},
                                  {"depth", &Picture::depth},
                                  {"normals", &Picture::normals},
                                  {"albedo", &Picture::albedo},
                                  {"sample-count", &Picture::sample_count}};

/// Counters come before them.
constexpr double JobTally::*kTimes[] = {&JobTally::seconds, &JobTally::render_seconds,
                                        &JobTally::render_processor_seconds};

using Parts = std::map<std::string_view, std::string_view>;

StateWriter size_part(const Plane32& plane) {
    StateWriter part;
    part.put(plane.width);
    part.put(plane.height);
    return part;
}

StateWriter bytes_part(const std::vector<std::uint8_t>& bytes) {
    StateWriter part;
    for (const std::uint8_t byte : bytes) part.put(byte);
    return part;
}

std::vector<std::uint8_t> bytes_of(std::string_view part) { return {part.begin(), part.end()}; }

StateWriter done_part(const std::vector<std::uint8_t>& done) {
    StateWriter part;
    for (std::size_t first = 0; first < done.size(); first += 8) {
        std::uint32_t bits = 0;
        for (std::size_t i = first; i < std::min(first + 8, done.size()); ++i) {
            bits |= (done[i] != 0 ? 1U : 0U) << (i - first);
        }
        part.put(static_cast<std::uint8_t>(bits));
    }
    return part;
}

/// Empty if the part is not `count` bits, with nothing in what is left of the last byte.
std::vector<std::uint8_t> read_done(std::string_view part, std::size_t count) {
    if (part.size() != (count + 7) / 8) return {};
    std::vector<std::uint8_t> done(count);
    for (std::size_t i = 0; i < part.size() * 8; ++i) {
        const std::uint32_t bit = static_cast<std::uint8_t>(part[i / 8]) >> (i % 8) & 1U;
        if (i >= count && bit != 0) return {};
        if (i < count) done[i] = static_cast<std::uint8_t>(bit);
    }
    return done;
}

StateWriter plane_part(const Plane32& plane, const std::vector<std::uint8_t>& done) {
    StateWriter part;
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (done[i] == 0) continue;
        for (std::size_t c = 0; c < plane.channels; ++c) {
            part.put(plane.values[i * plane.channels + c]);
        }
    }
    return part;
}

/// The part is known to be long enough.
void read_plane(std::string_view part, const std::vector<std::uint8_t>& done, Plane32& plane) {
    StateReader reader(part);
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (done[i] == 0) continue;
        for (std::size_t c = 0; c < plane.channels; ++c) {
            plane.values[i * plane.channels + c] = reader.take<float>();
        }
    }
}

std::uint32_t object_at(source::Span span, const ir::Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size() && span.valid(); ++i) {
        if (scene.objects[i].span == span) return static_cast<std::uint32_t>(i);
    }
    return kNoObject;
}

StateWriter tally_part(const JobTally& tally, const ir::Scene& scene) {
    StateWriter part;
    for (const auto counter : kCounters) part.put(tally.counters.*counter);
    for (const auto time : kTimes) part.put(tally.*time);
    for (const double seconds : tally.stages.seconds) part.put(seconds);
    part.put(tally.samples);
    part.put(tally.bad_sample_count);
    part.put(std::uint64_t{tally.bad_samples.size()});
    for (const BadSample& bad : tally.bad_samples) {
        for (const std::uint32_t number : {bad.x, bad.y, bad.sample}) part.put(number);
        part.put(object_at(bad.span, scene));
    }
    return part;
}

bool read_tally(std::string_view bytes, JobTally& tally, const ir::Scene& scene) {
    StateReader part(bytes);
    for (const auto counter : kCounters) tally.counters.*counter = part.take<std::uint64_t>();
    for (const auto time : kTimes) tally.*time = part.take<double>();
    for (double& seconds : tally.stages.seconds) seconds = part.take<double>();
    tally.samples = part.take<std::uint64_t>();
    tally.bad_sample_count = part.take<std::uint64_t>();
    const auto count = part.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < count && part.sound(); ++i) {
        BadSample bad;
        for (std::uint32_t* number : {&bad.x, &bad.y, &bad.sample}) {
            *number = part.take<std::uint32_t>();
        }
        const auto object = part.take<std::uint32_t>();
        if (object < scene.objects.size()) bad.span = scene.objects[object].span;
        tally.bad_samples.push_back(bad);
    }
    return part.sound() && part.at_end();
}

/// Nothing if `state` is not parts from its beginning to its end, each there once.
Parts parts_of(std::string_view state) {
    StateReader reader(state);
    Parts parts;
    if (reader.take<std::uint32_t>() != kVersion) return {};
    while (!reader.at_end()) {
        const auto [name, bytes] = reader.take_part();
        if (!reader.sound() || !parts.emplace(name, bytes).second) return {};
    }
    return reader.sound() ? parts : Parts();
}

/// The part, which is then not among `parts` any more; empty if there is none.
std::string_view take(Parts& parts, std::string_view name) {
    const auto found = parts.find(name);
    if (found == parts.end()) return {};
    const std::string_view bytes = found->second;
    parts.erase(found);
    return bytes;
}

}  // namespace

std::string encode_state(const JobState& state, const ir::Scene& scene) {
    StateWriter all;
    all.put(kVersion);
    all.put_part(kSize, size_part(state.planes.color));
    all.put_part(kDone, done_part(state.done));
    all.put_part(kPlan, bytes_part(state.plan));
    if (state.sums) {
        StateWriter kind;
        kind.put(state.sums->scrambles);
        kind.put(static_cast<std::uint8_t>(state.sums->squares ? 1 : 0));
        all.put_part(kKindOfSums, kind);
        all.put_part(kSums, bytes_part(state.sums->bytes));
    } else {
        for (const auto& [name, member] : kPlanes) {
            const Plane32& plane = state.planes.*member;
            if (!plane.values.empty()) all.put_part(name, plane_part(plane, state.done));
        }
    }
    all.put_part(kTally, tally_part(state.tally, scene));
    return all.take();
}

std::string decode_state(std::string_view bytes, const ir::Scene& scene, JobState& state) {
    Parts parts = parts_of(bytes);
    if (parts.empty()) return "its state is no state of a render";
    if (take(parts, kSize) != size_part(state.planes.color).bytes()) {
        return "its state is of a picture of another size";
    }
    JobState found;
    const std::size_t pixels = std::size_t{state.planes.color.width} * state.planes.color.height;
    found.done = read_done(take(parts, kDone), pixels);
    found.plan = bytes_of(take(parts, kPlan));
    if (found.done.size() != pixels || !read_tally(take(parts, kTally), found.tally, scene)) {
        return "its state is damaged";
    }
    std::vector<std::pair<Plane32 Picture::*, std::string_view>> read;
    if (parts.count(kSums) > 0) {
        StateReader kind(take(parts, kKindOfSums));
        found.sums.emplace();
        found.sums->scrambles = kind.take<std::uint32_t>();
        found.sums->squares = kind.take<std::uint8_t>() != 0;
        found.sums->bytes = bytes_of(take(parts, kSums));
    } else {
        const auto count =
            static_cast<std::size_t>(std::count(found.done.begin(), found.done.end(), 1));
        for (const auto& [name, member] : kPlanes) {
            const Plane32& plane = state.planes.*member;
            if (plane.values.empty()) continue;
            const std::string_view part = take(parts, name);
            if (part.size() != count * plane.channels * sizeof(float)) {
                return "its state has not the pixels that it says are done";
            }
            read.emplace_back(member, part);
        }
    }
    if (!parts.empty()) return "its state has parts that are unknown here";
    found.planes = std::move(state.planes);
    for (const auto& [member, part] : read) read_plane(part, found.done, found.planes.*member);
    state = std::move(found);
    return {};
}

}  // namespace cobble::renderer
