// SPDX-License-Identifier: MIT
#include "ir/assets/obj/mesh_normals.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

#include "ir/math/elementary.hpp"

namespace cobble::ir {
namespace {

using math::Vec3d;

constexpr std::uint32_t kNone = Mesh::kNone;

double largest_component(Vec3d v) {
    return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z));
}

/// A power of two that brings `size` near 1; at most 2^1000, so that it is finite for subnormals.
double power_near_inverse(double size) {
    return std::ldexp(1.0, std::min(-std::ilogb(size), 1000));
}

/// Not normalised; scaled by a power of two so that it neither overflows nor underflows.
Vec3d scaled_cross(Vec3d a, Vec3d b) {
    const double size = std::max(largest_component(a), largest_component(b));
    if (!(size > 0) || !std::isfinite(size)) return {};
    const double scale = power_near_inverse(size);
    return cross(a * scale, b * scale);
}

bool is_zero(Vec3d v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Per position, the first position at the same place: an open-addressing table of exact bits.
std::vector<std::uint32_t> weld(const std::vector<Vec3d>& positions) {
    const std::size_t capacity = std::bit_ceil(positions.size() * 2 + 1);
    std::vector<std::uint32_t> table(capacity, kNone);
    std::vector<std::uint32_t> first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t hash = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            // + 0.0 makes -0 a 0; the multiplier is 2^64 divided by the golden ratio, odd.
            hash ^= std::bit_cast<std::uint64_t>(positions[i][k] + 0.0);
            hash *= 0x9e3779b97f4a7c15U;
            hash ^= hash >> 29;
        }
        std::size_t slot = hash & (capacity - 1);
        while (table[slot] != kNone && !(positions[table[slot]] == positions[i])) {
            slot = (slot + 1) & (capacity - 1);
        }
        if (table[slot] == kNone) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

void smooth_everywhere(Mesh& mesh, bool unit) {
    mesh.normals.assign(mesh.positions.size(), {});
    for (const auto& face : mesh.faces) {
        const auto& c = face.corners;
        const Vec3d a = mesh.positions[c[0].position];
        Vec3d normal = cross(mesh.positions[c[1].position] - a, mesh.positions[c[2].position] - a);
        if (unit) normal = safe_normalize(normal);
        for (const auto& corner : c) mesh.normals[corner.position] += normal;
    }
    for (Vec3d& normal : mesh.normals) normal = safe_normalize(normal);
    for (auto& face : mesh.faces) {
        bool flat = false;
        for (const auto& corner : face.corners) flat |= is_zero(mesh.normals[corner.position]);
        for (auto& corner : face.corners) corner.normal = flat ? kNone : corner.position;
    }
}

// One face's corner at the vertex in hand, as one end of one of its two edges there.
struct EdgeEnd {
    std::uint32_t other;   ///< the vertex at the other end
    std::uint32_t member;  ///< which of the vertex's corners
};

class CreaseNormals {
  public:
    CreaseNormals(Mesh& mesh, double crease_angle)
        : mesh_(mesh),
          cos_crease_(math::sincos_degrees(crease_angle).cos),
          welded_(weld(mesh.positions)),
          face_normals_(mesh.faces.size()),
          angles_(mesh.faces.size() * 3) {}

    void run() {
        mesh_.normals.clear();
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            measure(f);
            for (auto& corner : mesh_.faces[f].corners) corner.normal = kNone;
        }
        collect_corners();
        for (std::size_t v = 0; v + 1 < starts_.size(); ++v) {
            if (starts_[v + 1] > starts_[v]) vertex(v);
        }
        flatten();
    }

  private:
    /// Corners (3 face + k) by welded vertex: a counting sort.
    void collect_corners() {
        starts_.assign(mesh_.positions.size() + 1, 0);
        for_corners([&](std::uint32_t v, std::uint32_t) { ++starts_[v + 1]; });
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        corners_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for_corners([&](std::uint32_t v, std::uint32_t corner) { corners_[next[v]++] = corner; });
    }
    template <typename Visit>
    void for_corners(Visit&& visit) const {
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            if (is_zero(face_normals_[f])) continue;
            for (std::uint32_t k = 0; k < 3; ++k) {
                visit(welded_[mesh_.faces[f].corners[k].position], f * 3 + k);
            }
        }
    }
    [[nodiscard]] std::uint32_t vertex_of(std::uint32_t corner) const {
        return welded_[mesh_.faces[corner / 3].corners[corner % 3].position];
    }
    [[nodiscard]] static std::uint32_t turn(std::uint32_t corner, std::uint32_t by) {
        return corner - corner % 3 + (corner % 3 + by) % 3;
    }
    std::uint32_t root(std::uint32_t member) {
        while (parents_[member] != member) {
            parents_[member] = parents_[parents_[member]];
            member = parents_[member];
        }
        return member;
    }

    void vertex(std::size_t v) {
        const std::uint32_t first = starts_[v];
        const std::uint32_t count = starts_[v + 1] - first;
        parents_.resize(count);
        std::iota(parents_.begin(), parents_.end(), 0U);
        ends_.clear();
        for (std::uint32_t m = 0; m < count; ++m) {
            const std::uint32_t corner = corners_[first + m];
            ends_.push_back({vertex_of(turn(corner, 1)), m});
            ends_.push_back({vertex_of(turn(corner, 2)), m});
        }
        std::sort(ends_.begin(), ends_.end(), [](EdgeEnd a, EdgeEnd b) {
            return a.other != b.other ? a.other < b.other : a.member < b.member;
        });
        join_across_edges(first);
        sums_.assign(count, {});
        for (std::uint32_t m = 0; m < count; ++m) {
            const std::uint32_t corner = corners_[first + m];
            sums_[root(m)] += face_normals_[corner / 3] * angles_[corner];
        }
        normal_ids_.assign(count, kNone);
        for (std::uint32_t m = 0; m < count; ++m) {
            const std::uint32_t r = root(m);
            if (normal_ids_[r] == kNone) {
                normal_ids_[r] = static_cast<std::uint32_t>(mesh_.normals.size());
                mesh_.normals.push_back(safe_normalize(sums_[r]));
            }
            const std::uint32_t corner = corners_[first + m];
            mesh_.faces[corner / 3].corners[corner % 3].normal = normal_ids_[r];
        }
    }

    /// Joins the faces on each edge that meet at less than the crease angle: every pair, but where
    /// more than eight faces share an edge only those that follow each other, so that a file with
    /// a million faces on one edge takes no million squared steps.
    void join_across_edges(std::uint32_t first) {
        constexpr std::size_t kAllPairs = 8;
        for (std::size_t i = 0; i < ends_.size();) {
            std::size_t end = i + 1;
            while (end < ends_.size() && ends_[end].other == ends_[i].other) ++end;
            const std::size_t reach = end - i <= kAllPairs ? kAllPairs : 1;
            for (std::size_t a = i; a < end; ++a) {
                for (std::size_t b = a + 1; b < end && b - a <= reach; ++b) {
                    const Vec3d na = face_normals_[corners_[first + ends_[a].member] / 3];
                    const Vec3d nb = face_normals_[corners_[first + ends_[b].member] / 3];
                    if (dot(na, nb) > cos_crease_) {
                        parents_[root(ends_[b].member)] = root(ends_[a].member);
                    }
                }
            }
            i = end;
        }
    }

    /// The unit normal of a face and its angles: the cross product of any two sides has the same
    /// length, and with their dot product it gives the angle between them.
    void measure(std::size_t f) {
        const auto& c = mesh_.faces[f].corners;
        std::array<Vec3d, 3> side;  // from each corner to the next
        double size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            side[k] = mesh_.positions[c[(k + 1) % 3].position] - mesh_.positions[c[k].position];
            size = std::max(size, largest_component(side[k]));
        }
        face_normals_[f] = face_normal(mesh_, mesh_.faces[f]);
        if (is_zero(face_normals_[f])) return;
        const double scale = power_near_inverse(size);
        for (Vec3d& s : side) s *= scale;
        const double area = length(cross(side[0], side[1]));
        for (std::size_t k = 0; k < 3; ++k) {
            angles_[3 * f + k] = math::atan2(area, -dot(side[(k + 2) % 3], side[k]));
        }
    }

    /// Faces whose corners all have the face's own normal, to within the rounding of a few sums
    /// (2^-48 is 32 units in the last place), are plainly flat.
    void flatten() {
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            auto& corners = mesh_.faces[f].corners;
            bool flat = true;
            bool missing = false;
            for (const auto& corner : corners) {
                if (corner.normal == kNone || is_zero(mesh_.normals[corner.normal])) {
                    missing = true;
                } else {
                    flat &= length(mesh_.normals[corner.normal] - face_normals_[f]) <= 0x1p-48;
                }
            }
            if (!flat && !missing) continue;
            for (auto& corner : corners) corner.normal = kNone;
        }
        drop_unused();
    }

    void drop_unused() {
        std::vector<std::uint32_t> moved(mesh_.normals.size(), kNone);
        std::vector<Vec3d> kept;
        for (auto& face : mesh_.faces) {
            for (auto& corner : face.corners) {
                if (corner.normal == kNone) continue;
                std::uint32_t& target = moved[corner.normal];
                if (target == kNone) {
                    target = static_cast<std::uint32_t>(kept.size());
                    kept.push_back(mesh_.normals[corner.normal]);
                }
                corner.normal = target;
            }
        }
        mesh_.normals = std::move(kept);
    }

    Mesh& mesh_;
    double cos_crease_;
    std::vector<std::uint32_t> welded_;
    std::vector<Vec3d> face_normals_;
    std::vector<double> angles_;  ///< per corner, radians
    std::vector<std::uint32_t> starts_;
    std::vector<std::uint32_t> corners_;
    // Of the vertex in hand, one entry per corner there.
    std::vector<std::uint32_t> parents_;
    std::vector<EdgeEnd> ends_;
    std::vector<Vec3d> sums_;
    std::vector<std::uint32_t> normal_ids_;
};

}  // namespace

void adopt_normals(Mesh& mesh) {
    for (Vec3d& normal : mesh.normals) normal = safe_normalize(normal);
    for (auto& face : mesh.faces) {
        const bool zero =
            std::any_of(face.corners.begin(), face.corners.end(), [&](const Mesh::Corner& corner) {
                return corner.normal != kNone && is_zero(mesh.normals[corner.normal]);
            });
        if (!zero) continue;
        for (auto& corner : face.corners) corner.normal = kNone;
    }
}

Vec3d safe_normalize(Vec3d v) {
    const double size = largest_component(v);
    if (!(size > 0) || !std::isfinite(size)) return {};
    return normalize(v * power_near_inverse(size));
}

bool has_area(Vec3d a, Vec3d b, Vec3d c) { return !is_zero(scaled_cross(b - a, c - a)); }

Vec3d face_normal(const Mesh& mesh, const Mesh::Face& face) {
    const auto& c = face.corners;
    const Vec3d a = mesh.positions[c[0].position];
    return safe_normalize(
        scaled_cross(mesh.positions[c[1].position] - a, mesh.positions[c[2].position] - a));
}

void compute_normals(Mesh& mesh, NormalRule rule, double crease_angle) {
    switch (rule) {
        case NormalRule::kCreaseAngle:
            CreaseNormals(mesh, crease_angle).run();
            break;
        case NormalRule::kSumOfCrosses:
            smooth_everywhere(mesh, false);
            break;
        case NormalRule::kSumOfUnits:
            smooth_everywhere(mesh, true);
            break;
        case NormalRule::kFlat:
            mesh.normals.clear();
            for (auto& face : mesh.faces) {
                for (auto& corner : face.corners) corner.normal = kNone;
            }
            break;
    }
}

}  // namespace cobble::ir
