// SPDX-License-Identifier: MIT
// What must not change an answer, or change it in a known way: the metamorphic tests.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "tests/hard/scenes.hpp"
#include "tests/render/scene_builder.hpp"

namespace cobble::test {

namespace {

/// How a scene is written down differently.
struct Change {
    double scale = 1;
    Vec3d offset{};
    std::array<std::size_t, 3> axes{0, 1, 2};  ///< where each new coordinate comes from
    bool reversed = false;
    bool split = false;  ///< triangles at the middle of their first edge

    [[nodiscard]] Vec3d direction(Vec3d d) const { return {d[axes[0]], d[axes[1]], d[axes[2]]}; }
    [[nodiscard]] Vec3d point(Vec3d p) const { return offset + direction(p) * scale; }
};

/// A mesh, spheres, triangles and boxes among glass and mirrors, on a floor and before a point
/// light; all numbers are multiples of 2^-10 that float holds with bits to spare. No falloff, no
/// noise, no textures.
ir::Scene plain_scene(const Change& change, int triangles = 60) {
    Random random(77);
    const auto coarse = [&](double half) {
        const Vec3d p = random.point(half);
        return Vec3d{std::floor(p.x * 1024) / 1024, std::floor(p.y * 1024) / 1024,
                     std::floor(p.z * 1024) / 1024};
    };
    SceneMaker make;
    auto& camera = make.scene.camera;
    camera.center = change.point({0.5, 0.25, 6});
    camera.forward = change.direction({0, 0, -1});
    camera.up = camera.up_as_written = change.direction({0, 1, 0});
    camera.right = change.direction({1, 0, 0});
    camera.angle = 0.75;
    make.scene.background = {{0.25, 0.5, 0.75}, {0.125, 0.125, 0.125}, {}, {}};
    ir::Light light;
    light.position = change.point({2, 4, 5});
    light.color = {0.75, 0.75, 0.5};
    make.scene.lights.push_back(light);
    make.scene.materials[0].diffuse = {0.75, 0.5, 0.25};
    ir::Material mirror;
    mirror.diffuse = {0.25, 0.25, 0.25};
    mirror.specular = {0.5, 0.5, 0.5};
    mirror.shininess = 20;
    ir::Material glass = mirror;
    glass.refraction_index = 1.5;
    make.scene.materials.push_back(mirror);
    make.scene.materials.push_back(glass);
    const auto of = [&](std::uint32_t material) {
        make.scene.objects.back().material = ir::MaterialId{material};
    };
    const auto triangle = [&](Vec3d a, Vec3d b, Vec3d c, std::uint32_t material) {
        if (change.reversed) std::swap(b, c);
        if (!change.split) {
            make.triangle(change.point(a), change.point(b), change.point(c));
            of(material);
            return;
        }
        const Vec3d m = (a + b) * 0.5;
        make.triangle(change.point(a), change.point(m), change.point(c));
        of(material);
        make.triangle(change.point(m), change.point(b), change.point(c));
        of(material);
    };
    for (int i = 0; i < triangles; ++i) {
        const Vec3d a = coarse(2);
        const Vec3d b = coarse(2);
        const Vec3d c = coarse(2);
        const auto material = static_cast<std::uint32_t>(i % 4 == 0);
        triangle(a, b, c, material);
        if (change.split) continue;
        if (i % 5 == 0) {
            make.sphere(change.point(c), 0.25 * change.scale);
            of(static_cast<std::uint32_t>(i % 3));
        }
        if (i % 7 == 0) {
            const Vec3d lo = change.point(b);
            const Vec3d hi = change.point(b + Vec3d{0.25, 0.5, 0.125});
            make.box(lo, hi);
            of(2);
        }
    }
    Solid star = random_star(1, 8);
    for (auto& p : star.positions) {
        p = change.point({std::floor(p.x * 512) / 1024, std::floor(p.y * 512) / 1024,
                          std::floor(p.z * 512) / 1024});
    }
    for (auto& f : star.faces) {
        if (change.reversed) std::swap(f[1], f[2]);
    }
    make.mesh(star);
    of(0);
    const Vec3d up = change.direction({0, 1, 0});
    make.plane(up, dot(up, change.point({0, -2, 0})));
    of(0);
    return make.scene;
}

renderer::Settings plain_settings() {
    auto s = settings(
        64, 48, 1,
        effects({Effect::kShadows, Effect::kReflection, Effect::kRefraction, Effect::kHighlights}));
    s.want_depth = true;
    return s;
}

/// One ray for each of many places, all numbers multiples of 2^-10; hits of `a` and of `b` go to
/// `compare`, the ray of `b` being the changed one.
template <typename Compare>
int compare_hits(const ir::Scene& a, const ir::Scene& b, const Change& change, Compare compare) {
    const auto x = renderer::prepare<float>(a);
    const auto y = renderer::prepare<float>(b);
    Random random(1);
    renderer::Counters counters;
    int hits = 0;
    for (int i = 0; i < 6000; ++i) {
        const auto coarse = [&](double half) {
            const Vec3d p = random.point(half);
            return Vec3d{std::floor(p.x * 1024) / 1024, std::floor(p.y * 1024) / 1024,
                         std::floor(p.z * 1024) / 1024};
        };
        const Vec3d o = coarse(4);
        const Vec3d d = coarse(1);
        if (d == Vec3d{}) continue;
        renderer::Ray<float> r;
        r.origin = x.to_local(o);
        r.direction = d.to<float>();
        renderer::Ray<float> m;
        m.origin = y.to_local(change.point(o));
        m.direction = change.direction(d).to<float>();
        const auto p = closest_hit(x, r, {}, counters);
        const auto q = closest_hit(y, m, {}, counters);
        hits += p ? 1 : 0;
        compare(p, q);
    }
    return hits;
}

bool same_bits(const renderer::Plane32& a, const renderer::Plane32& b) {
    return a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

/// Of the values, how many are farther apart than a thousandth; the worst of the rest.
struct Difference {
    std::size_t far = 0;
    double worst = 0;
};
Difference difference(const renderer::Plane32& a, const renderer::Plane32& b) {
    REQUIRE(a.values.size() == b.values.size());
    Difference result;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double off = std::fabs(double{a.values[i]} - double{b.values[i]});
        if (off > 1e-3) {
            ++result.far;
        } else {
            result.worst = std::max(result.worst, off);
        }
    }
    return result;
}

/// Within one step of float of each other.
bool next_to(float a, float b) { return a == b || std::nextafter(a, b) == b; }

}  // namespace

TEST_CASE("metamorphic: a scene scaled by 2^k, |k| <= 30, has the same hits and the same picture") {
    const auto source = plain_scene({});
    const auto base = render(source, plain_settings());
    for (const int k : {-30, -29, -20, -7, -1, 1, 2, 11, 23, 30}) {
        CAPTURE(k);
        Change change;
        change.scale = std::ldexp(1.0, k);
        const auto scaled = plain_scene(change);
        int wrong = 0;
        const int hits = compare_hits(source, scaled, change, [&](auto p, auto q) {
            q.t = std::ldexp(q.t, -k);
            wrong += same(p, q) ? 0 : 1;
        });
        CHECK(hits > 2000);
        CHECK(wrong == 0);
        auto picture = render(scaled, plain_settings()).picture;
        CHECK(same_bits(picture.color, base.picture.color));
        for (float& depth : picture.depth.values) depth = std::ldexp(depth, -k);
        CHECK(same_bits(picture.depth, base.picture.depth));
    }
}

TEST_CASE("metamorphic: permuted axes permute the answers") {
    // Sums of three have an order, so that only their last bits may differ.
    const auto source = plain_scene({});
    const auto base = render(source, plain_settings());
    for (const auto& axes :
         {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}) {
        CAPTURE(axes[0]);
        CAPTURE(axes[1]);
        Change change;
        change.axes = axes;
        const auto permuted = plain_scene(change);
        int wrong = 0;
        const int hits = compare_hits(source, permuted, change, [&](auto p, auto q) {
            bool right = p.object == q.object;
            if (right && p) {
                std::uint32_t face = q.face;
                if (source.objects[p.object.value].kind == ir::ShapeKind::kBox) {
                    face = static_cast<std::uint32_t>(2 * axes[q.face / 2] + q.face % 2);
                }
                right = p.face == face && next_to(p.t, q.t) && std::fabs(p.u - q.u) <= 0x1p-22F &&
                        std::fabs(p.v - q.v) <= 0x1p-22F;
            }
            wrong += right ? 0 : 1;
        });
        CHECK(hits > 2000);
        CHECK(wrong == 0);
        const auto picture = render(permuted, plain_settings()).picture;
        const auto off = difference(picture.color, base.picture.color);
        // Behind glass and mirrors a last bit may grow, and cross an edge.
        CHECK(off.far <= 3);
        CHECK(off.worst < 1e-3);
    }
}

TEST_CASE("metamorphic: reversed winding changes no hit") {
    const auto source = plain_scene({});
    Change change;
    change.reversed = true;
    int wrong = 0;
    int triangles = 0;
    const int hits = compare_hits(source, plain_scene(change), change, [&](auto p, auto q) {
        const bool right = p.object == q.object && p.face == q.face &&
                           (!p || (p.t == q.t && p.u == q.v && p.v == q.u));
        wrong += right ? 0 : 1;
        triangles += p && p.u > 0 ? 1 : 0;
    });
    CHECK(hits > 2000);
    CHECK(triangles > 500);
    CHECK(wrong == 0);
}

TEST_CASE("metamorphic: where every coordinate moves exactly, t, id, u and v stay") {
    const auto source = plain_scene({});
    const auto base = renderer::prepare<float>(source);
    bool stayed = false;
    bool moved = false;
    // By whole steps of the grid that local coordinates are made on, and by less than one.
    for (const Vec3d offset : {Vec3d{1024, -4096, 8192}, Vec3d{30000000, 64, -30000000},
                               Vec3d{0.5, 0.25, -0.125}, Vec3d{1.5, -1, 0.75}}) {
        CAPTURE(offset.x);
        Change change;
        change.offset = offset;
        const auto other = plain_scene(change);
        const auto origin = renderer::prepare<float>(other).origin;
        (origin == base.origin ? stayed : moved) = true;
        int wrong = 0;
        const int hits = compare_hits(source, other, change,
                                      [&](auto p, auto q) { wrong += same(p, q) ? 0 : 1; });
        CHECK(hits > 2000);
        CHECK(wrong == 0);
        const auto a = render(source, plain_settings()).picture;
        const auto b = render(other, plain_settings()).picture;
        if (origin == base.origin + offset) CHECK(same_bits(a.color, b.color));
    }
    CHECK(stayed);
    CHECK(moved);
}

TEST_CASE("metamorphic: triangles split at an exact midpoint give the same picture") {
    Change change;
    change.split = true;
    // The same order of objects, so that what is tied stays tied the same way.
    const auto halves = plain_scene(change);
    auto whole = halves;
    whole.triangles.clear();
    std::vector<ir::Object> objects;
    for (std::size_t i = 0; i < halves.objects.size(); ++i) {
        ir::Object object = halves.objects[i];
        if (object.kind == ir::ShapeKind::kTriangle) {
            if (object.shape % 2 == 1) continue;
            const auto& first = halves.triangles[object.shape].keys[0];
            const auto& second = halves.triangles[object.shape + 1].keys[0];
            object.shape = static_cast<std::uint32_t>(whole.triangles.size());
            whole.triangles.push_back({{{first[0], second[1], first[2]}}});
        }
        objects.push_back(object);
    }
    whole.objects = objects;
    REQUIRE(whole.triangles.size() == 60);
    REQUIRE(halves.triangles.size() == 120);
    const auto a = render(whole, plain_settings()).picture;
    const auto b = render(halves, plain_settings()).picture;
    CHECK(difference(a.color, b.color).far == 0);
    CHECK(difference(a.color, b.color).worst < 1e-5);
    CHECK(difference(a.depth, b.depth).far == 0);
    // And rays at the very edge that is new.
    const auto x = renderer::prepare<float>(whole);
    const auto y = renderer::prepare<float>(halves);
    REQUIRE(x.origin == y.origin);
    Random random(5);
    renderer::Counters counters;
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto& half = halves.triangles[2 * random.below(60)].keys[0];
        renderer::Ray<float> r;
        r.origin = x.to_local(random.point(4));
        r.direction = x.to_local(lerp(half[1], half[2], random.in(0.01, 0.99))) - r.origin;
        const auto p = closest_hit(x, r, {}, counters);
        const auto q = closest_hit(y, r, {}, counters);
        wrong += p && q && next_to(p.t, q.t) ? 0 : 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("metamorphic: an instance is its baked copy but for the rounding of its map") {
    Random random(64);
    renderer::Counters counters;
    const Solid solid = random_star(1, 4);
    int both = 0;
    int unlike = 0;
    double worst = 0;
    int unexplained = 0;
    for (int i = 0; i < 100; ++i) {
        math::Affined shear;
        shear.rows[0][1] = random.in(-1, 1);
        const double spread = i % 2 == 0 ? 2 : 30;
        const auto s = [&] { return std::pow(spread, random.in(-1, 1)); };
        const Vec3d by{s(), i % 3 == 0 ? -s() : s(), s()};
        const auto map =
            translation(random.point(3)) * rotation(random.direction(), 2) * shear * scaling(by);
        SceneMaker placed;
        placed.mesh(solid);
        placed.place_last({map});
        SceneMaker baked;
        Solid copy = solid;
        for (auto& p : copy.positions) p = map.point(p);
        baked.mesh(copy);
        const auto a = renderer::prepare<float>(placed.scene);
        const auto b = renderer::prepare<float>(baked.scene);
        const double condition = math::condition(map, *math::inverse(map));
        const Vec3d center = map.point({});
        double reach = 0;
        for (const Vec3d p : copy.positions) reach = std::max(reach, length(p - center));
        for (int k = 0; k < 200; ++k) {
            const Vec3d o = center + random.direction() * (3 * reach);
            // Every other one at an edge, where the two may differ.
            const auto& f = solid.faces[random.below(80)];
            const Vec3d at =
                k % 2 == 0 ? random.point(0.7)
                           : lerp(solid.positions[f[0]], solid.positions[f[1]], random.unit());
            const Vec3d d = normalize(map.point(at) - o);
            renderer::Ray<float> r;
            r.origin = a.to_local(o);
            r.direction = d.to<float>();
            renderer::Ray<float> q = r;
            // The same ray, though the two may count from different origins.
            q.origin = b.to_local(a.to_world(r.origin));
            const double scale = length(a.to_world(r.origin) - a.origin) +
                                 length(center - a.origin) + reach +
                                 length(a.to_world(r.origin) - b.origin);
            const double bound = 64 * 0x1p-24 * condition * scale;
            const auto x = closest_hit(a, r, {}, counters);
            const auto y = closest_hit(b, q, {}, counters);
            if (x && y && x.face == y.face) {
                ++both;
                const Vec3d p = a.to_world(surface_at(a, r, x).position);
                const Vec3d e = b.to_world(surface_at(b, q, y).position);
                // Along the ray a point moves by more, the more the surface is grazed.
                const Vec3d n = surface_at(b, q, y).geometric_normal.to<double>();
                worst = std::max(worst, std::fabs(dot(p - e, n)) / bound);
                continue;
            }
            if (!x && !y) continue;
            ++unlike;
            // Some edge must be as near to the line as the bound says.
            double nearest = std::numeric_limits<double>::infinity();
            const Vec3d from = a.to_world(r.origin);
            const Vec3d along = r.direction.to<double>();
            for (const auto& face : copy.faces) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const Vec3d p = copy.positions[face[c]];
                    const Vec3d e = copy.positions[face[(c + 1) % 3]] - p;
                    // Least squares for the points p + m e and from + n along, m held to the edge.
                    const Vec3d e_off = e - along * (dot(e, along) / dot(along, along));
                    const Vec3d w = from - p;
                    const Vec3d w_off = w - along * (dot(w, along) / dot(along, along));
                    const double m = std::clamp(dot(w_off, e_off) / dot(e_off, e_off), 0.0, 1.0);
                    nearest = std::min(nearest, length(w_off - e_off * m));
                }
            }
            unexplained += nearest <= bound ? 0 : 1;
        }
    }
    CHECK(both > 8000);
    CHECK(worst <= 1);
    CHECK(unlike > 10);
    CHECK(unexplained == 0);
}

TEST_CASE("metamorphic: a mirrored camera sees the mirrored picture") {
    auto scene = plain_scene({});
    const auto a = render(scene, plain_settings()).picture;
    scene.camera.right = -scene.camera.right;
    const auto b = render(scene, plain_settings()).picture;
    int wrong = 0;
    std::uint32_t seen = 0;
    for (std::uint32_t y = 0; y < 48; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                wrong += a.color.at(x, y, c) == b.color.at(63 - x, y, c) ? 0 : 1;
            }
            seen += a.color.at(x, y, 0) == a.color.at(63 - x, y, 0) ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    // It is not its own mirror image.
    CHECK(seen > 500);
}

}  // namespace cobble::test
