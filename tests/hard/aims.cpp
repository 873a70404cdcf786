// SPDX-License-Identifier: MIT
#include "tests/hard/aims.hpp"

#include <utility>

#include "tests/hard/mixed.hpp"

namespace cobble::test {

namespace {

/// From around the middle of a closed solid at its edges or vertices. The faces of all of them are
/// farther than 0.1 from the middle.
std::function<AimedRay(Random&)> from_within(Solid solid, Vec3d center, double scale,
                                             Vec3d flatness = {1, 1, 1}) {
    return [=, solid = std::move(solid)](Random& random) {
        const Vec3d by = random.point(random.below(4) == 0 ? 0 : 0.05) * scale;
        const Vec3d from = center + Vec3d{by.x * flatness.x, by.y * flatness.y, by.z * flatness.z};
        return AimedRay{from, on_edge(solid, random, random.below(2) == 0)};
    };
}

void add_solids(std::vector<Aim>& all, int row, const std::string& name, double scale,
                Vec3d center) {
    for (const Solid& unit : closed_solids()) {
        const Solid solid = transformed(unit, scale, center);
        SceneMaker make;
        make.mesh(solid);
        if (center.x != 0) {
            // Specks that keep the coordinates from being brought near.
            for (const double side : {-1.0, 0.0}) {
                const Vec3d at = center * side;
                make.triangle(at, at + Vec3d{1e-3, 0, 0}, at + Vec3d{0, 1e-3, 0});
            }
        }
        all.push_back({row, name + ", " + std::to_string(solid.faces.size()) + " faces", make.scene,
                       true, from_within(solid, center, scale)});
    }
}

/// Solids that are a thousandth to a millionth as high as wide: slivers all around.
void add_slivers(std::vector<Aim>& all) {
    for (const double flat : {1e-3, 1e-6}) {
        Solid solid = random_star(2, 6);
        for (auto& p : solid.positions) p.z *= flat;
        SceneMaker make;
        make.mesh(solid);
        all.push_back({9, "a solid as flat as " + std::to_string(flat), make.scene, true,
                       from_within(solid, {}, 1, {1, 1, flat})});
    }
}

/// The sides of a hollow cube of blocks, seen from within: at where blocks meet.
void add_blocks(std::vector<Aim>& all) {
    SceneMaker make;
    for (int i = 0; i < 343; ++i) {
        const Vec3d at{double(i % 7), double(i / 7 % 7), double(i / 49)};
        const bool inside = at.x > 0 && at.x < 6 && at.y > 0 && at.y < 6 && at.z > 0 && at.z < 6;
        if (!inside) make.box(at, at + Vec3d{1, 1, 1});
    }
    all.push_back(
        {23, "a hollow cube of blocks", make.scene, true, [](Random& random) {
             Vec3d from = Vec3d{3.5, 3.5, 3.5} + random.point(random.below(3) == 0 ? 0 : 2);
             // On the cavity's walls, at corners and edges of their blocks.
             Vec3d at;
             for (std::size_t i = 0; i < 3; ++i) {
                 at[i] = random.below(3) == 0 ? random.in(1, 6) : 1 + random.below(6);
             }
             at[random.below(3)] = random.below(2) == 0 ? 1 : 6;
             // Some in the plane of a lattice, which is that of faces.
             const std::size_t axis = random.below(3);
             if (random.below(3) == 0) {
                 at[axis] = 1 + random.below(6);
                 from[axis] = at[axis];
             }
             return AimedRay{from, at};
         }});
    all.push_back({4, "along the edges of blocks", make.scene, true, [](Random& random) {
                       // From within, with zeros in the direction, in the planes of faces.
                       Vec3d from;
                       for (std::size_t i = 0; i < 3; ++i) {
                           from[i] = random.below(3) == 0 ? random.in(1, 6) : 1 + random.below(6);
                       }
                       const std::size_t axis = random.below(3);
                       from[axis] = random.in(1.1, 5.9);
                       Vec3d to = from;
                       to[axis] += random.below(2) == 0 ? 1 : -1;
                       return AimedRay{from, to};
                   }});
}

void add_floors(std::vector<Aim>& all) {
    for (const bool tilted : {false, true}) {
        SceneMaker make;
        Random random(7);
        for (const auto& t : cut_floor(tilted, random)) make.triangle(t[0], t[1], t[2]);
        all.push_back({7, tilted ? "a tilted floor of T-vertices" : "a floor of T-vertices",
                       make.scene, true, [tilted](Random& r) {
                           const Vec3d from = r.point(2) + Vec3d{4, 9, 4};
                           const Vec3d at = on_cut_floor(tilted, r.below(4), r);
                           // Of any length: where t is not 1 it is rounded.
                           return AimedRay{from, lerp(from, at, r.in(0.1, 1))};
                       }});
    }
}

void add_placed(std::vector<Aim>& all) {
    Random random(14);
    for (int i = 0; i < 3; ++i) {
        const math::Affined map = deep_map(random, i == 0 ? 2 : 1e3);
        Solid solid = random_star(1, 4);
        SceneMaker make;
        make.mesh(solid);
        make.place_last({map});
        all.push_back({14, "a solid through three maps", make.scene, true,
                       [=, next = from_within(solid, {}, 1)](Random& r) {
                           const AimedRay within = next(r);
                           return AimedRay{map.point(within.origin), map.point(within.target)};
                       }});
    }
}

void add_spheres(std::vector<Aim>& all) {
    for (const double radius : {1e-3, 1.0, 3e5}) {
        SceneMaker make;
        Random places(17);
        std::vector<Vec3d> centers;
        for (int i = 0; i < 100; ++i) {
            centers.push_back(places.point(6 * radius));
            make.sphere(centers.back(), radius);
        }
        all.push_back({17, "at the outlines of spheres", make.scene, false,
                       [radius, centers](Random& random) {
                           const Vec3d c = centers[random.below(100)];
                           const Vec3d eye = random.direction() * (radius * 1000);
                           const Vec3d side = normalize(cross(c - eye, random.direction()));
                           const int bits = static_cast<int>(random.below(30));
                           const double f = 1 + std::ldexp(random.in(-1, 1), -bits);
                           return AimedRay{eye, c + side * (radius * f)};
                       }});
    }
}

/// A closed solid whose vertices move: its triangles one by one, with shared corners.
void add_moving(std::vector<Aim>& all) {
    const Solid solid = icosphere(2);
    const auto at = [&](std::uint32_t vertex, int key) {
        Random shift(vertex * 2 + static_cast<std::uint64_t>(key));
        return (solid.positions[vertex] + shift.point(0.1)).to<float>().to<double>();
    };
    SceneMaker make;
    for (const auto& f : solid.faces) {
        make.moving_triangle(
            {{at(f[0], 0), at(f[1], 0), at(f[2], 0)}, {at(f[0], 1), at(f[1], 1), at(f[2], 1)}});
    }
    const auto keys = make.scene.triangles;
    all.push_back({41, "a solid whose vertices move", make.scene, true, [keys](Random& random) {
                       const auto& k =
                           keys[random.below(static_cast<std::uint32_t>(keys.size()))].keys;
                       const double time = random.below(3) == 0 ? 0.5 : random.unit();
                       const double along = random.below(2) == 0 ? 0 : random.unit();
                       const Vec3d a = lerp(k[0][0], k[1][0], time);
                       const Vec3d b = lerp(k[0][1], k[1][1], time);
                       return AimedRay{random.point(0.05), lerp(a, b, along), time};
                   }});
}

}  // namespace

std::array<AimedRay, kBundle> bundle_of(const Aim& aim, Random& random) {
    const AimedRay middle = aim.next(random);
    const Vec3d way = middle.target - middle.origin;
    std::array<AimedRay, kBundle> rays;
    rays.fill(middle);
    for (AimedRay& r : rays) {
        // By a share of each coordinate, so that all go into one octant, or along an axis.
        const auto off = [&](int least) {
            const Vec3d by =
                random.point(std::ldexp(1.0, -least - static_cast<int>(random.below(30))));
            return Vec3d{way.x * by.x, way.y * by.y, way.z * by.z};
        };
        if (random.below(4) == 0) continue;
        r.target = r.target + off(10);
        // So little that it stays within the flattest of solids.
        if (random.below(2) == 0) r.origin = r.origin + off(30);
    }
    return rays;
}

std::vector<Solid> closed_solids() {
    return {icosphere(2), icosphere(0), square_prism(), random_star(1, 5), random_star(2, 6)};
}

Vec3d on_edge(const Solid& solid, Random& random, bool vertex) {
    const auto& f = solid.faces[random.below(static_cast<std::uint32_t>(solid.faces.size()))];
    const Vec3d a = solid.positions[f[0]];
    const Vec3d b = solid.positions[f[1]];
    return vertex ? a : lerp(a, b, random.unit());
}

std::vector<std::array<Vec3d, 3>> cut_floor(bool tilted, Random& random) {
    std::vector<std::array<Vec3d, 3>> all;
    const auto at = [&](double x, double y) {
        return tilted ? Vec3d{x, 0.25 * x + 0.5 * y, y} : Vec3d{x, 0.0, y};
    };
    for (int i = 0; i < 64; ++i) {
        const double x = i % 8;
        const double y = i / 8;
        const Vec3d a = at(x, y);
        const Vec3d b = at(x + 1, y);
        const Vec3d c = at(x + 1, y + 1);
        const Vec3d d = at(x, y + 1);
        const Vec3d m = at(x + 0.5, y + 0.5);
        if (i % 3 == 0) {
            all.insert(all.end(), {{a, b, m}, {b, c, m}, {c, d, m}, {d, a, m}});
        } else {
            const Vec3d e = at(x + 0.5, y);  // on the neighbour's edge
            all.insert(all.end(), {{a, e, d}, {e, b, c}, {e, c, d}});
        }
    }
    const auto count = all.size();
    for (std::size_t i = 0; i < count; ++i) all.push_back({all[i][0], all[i][2], all[i][1]});
    for (std::size_t i = all.size(); i > 1; --i) {
        std::swap(all[i - 1], all[random.below(static_cast<std::uint32_t>(i))]);
    }
    return all;
}

Vec3d on_cut_floor(bool tilted, std::uint32_t i, Random& random) {
    const double x = 0.5 * (1 + random.below(15));
    const double y = i % 2 == 0 ? random.in(0.1, 7.9) : 0.5 * (1 + random.below(15));
    const bool across = i % 4 == 0;
    const Vec3d on{across ? y : x, 0, across ? x : y};
    return on + Vec3d{0, tilted ? 0.25 * on.x + 0.5 * on.z : 0, 0};
}

math::Affined deep_map(Random& random, double spread) {
    math::Affined map;
    for (int i = 0; i < 3; ++i) {
        math::Affined shear;
        shear.rows[0][1] = random.in(-1, 1);
        const double s = std::pow(spread, random.in(-1.0, 1.0) / 3);
        map = map * rotation(random.direction(), random.in(0, 6)) * shear *
              scaling({s, random.in(0.5, 2), i == 1 ? -1.0 : 1.0}) * translation(random.point(2));
    }
    return map;
}

std::vector<Aim> aims() {
    std::vector<Aim> all;
    add_solids(all, 1, "solids at zero", 1, {});
    add_solids(all, 3, "solids of 100 far from zero", 100, {148376, 1234, -223423});
    add_solids(all, 3, "solids of 1e-6", 1e-6, {});
    add_solids(all, 11, "solids of 1e18", 1e18, {});
    add_solids(all, 10, "solids of 1e-12", 1e-12, {});
    add_slivers(all);
    add_blocks(all);
    add_floors(all);
    add_placed(all);
    add_spheres(all);
    add_moving(all);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        all.push_back({6, "everything mixed", mixed_scene(seed), false, [](Random& random) {
                           const auto r = any_ray<double>(random);
                           return AimedRay{r.origin, r.origin + r.direction, r.time};
                       }});
    }
    return all;
}

}  // namespace cobble::test
