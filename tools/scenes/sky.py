# SPDX-License-Identifier: MIT
"""Cube maps of a day and a night sky.

The direction of a texel follows the language's rule for cube maps: the face by the largest
component, u and v as in `face_direction`.
"""

import math

from noise import hash01, value_noise3

FACES = ("left", "right", "up", "down", "front", "back")


def face_direction(face, u, v):
    """Direction seen at (u, v) in 0..1, v upwards, before normalising."""
    s, t = 2 * u - 1, 2 * v - 1
    return {
        "right": (1, t, s), "left": (-1, t, -s),
        "up": (s, 1, t), "down": (s, -1, t),
        "front": (-s, t, 1), "back": (s, t, -1),
    }[face]


def mix(a, b, f):
    f = max(0.0, min(1.0, f))
    return tuple(x + (y - x) * f for x, y in zip(a, b))


def unit(d):
    length = math.sqrt(sum(c * c for c in d))
    return tuple(c / length for c in d)


def clouds(d, cell, height, cover, seed):
    """Blocky clouds: cells of a flat layer at `height`, full or empty."""
    if d[1] < 0.04:
        return 0.0
    x, z = d[0] / d[1] * height, d[2] / d[1] * height
    i, j = math.floor(x / cell), math.floor(z / cell)
    dense = value_noise3(i / 3.1, j / 3.1, 0.5, seed) + 0.35 * hash01(i, j, seed + 1)
    fade = min(1.0, (d[1] - 0.04) / 0.2)
    return fade if dense > cover else 0.0


def day(d):
    d = unit(d)
    sky = mix((186, 214, 240), (72, 128, 210), max(0.0, d[1]) ** 0.6)
    if d[1] < 0:
        sky = mix((186, 214, 240), (120, 138, 140), min(1.0, -d[1] * 4))
    sun = unit((0.55, 0.62, 0.45))
    toward = sum(a * b for a, b in zip(d, sun))
    sky = mix(sky, (255, 244, 214), max(0.0, (toward - 0.93) / 0.07) ** 3 * 0.8)
    if toward > 0.9985:
        sky = (255, 252, 236)
    return mix(sky, (250, 252, 255), 0.85 * clouds(d, 0.55, 3.0, 0.92, 7))


def night(d):
    d = unit(d)
    sky = mix((34, 40, 72), (8, 11, 30), max(0.0, d[1]) ** 0.5)
    if d[1] < 0:
        sky = mix((34, 40, 72), (12, 14, 26), min(1.0, -d[1] * 4))
    band = abs(d[0] * 0.5 + d[1] * 0.2 - d[2] * 0.6)
    milky = max(0.0, 1 - band / 0.35) * (0.4 + 0.6 * value_noise3(d[0] * 5, d[1] * 5, d[2] * 5, 3))
    sky = mix(sky, (64, 66, 110), 0.5 * milky * (d[1] > 0))
    cell = 60
    i, j, k = (math.floor(c * cell) for c in d)
    if d[1] > 0.02 and hash01(i, j, k, 17) > 0.962 - 0.03 * milky:
        center = tuple((c + 0.2 + 0.6 * hash01(i, j, k, 18 + n)) / cell for n, c in enumerate((i, j, k)))
        near = math.dist(center, d) * cell
        bright = 0.35 + 0.65 * hash01(i, j, k, 22)
        sky = mix(sky, (235, 238, 255), bright * max(0.0, 1 - near / 0.28) ** 0.7)
    moon = unit((0.20, 0.21, -0.90))
    right = unit((moon[2], 0.0, -moon[0]))
    above = tuple(a * b2 - c * b1 for a, b2, c, b1 in (
        (moon[1], right[2], moon[2], right[1]),
        (moon[2], right[0], moon[0], right[2]),
        (moon[0], right[1], moon[1], right[0])))
    toward = sum(a * b for a, b in zip(d, moon))
    if toward > 0:
        x = sum(a * b for a, b in zip(d, right)) / toward
        y = sum(a * b for a, b in zip(d, above)) / toward
        size = 0.055
        if abs(x) < size and abs(y) < size:  # a square moon, as in any world of blocks
            px, py = int((x / size + 1) * 4), int((y / size + 1) * 4)
            return tuple(c * (0.86 + 0.14 * hash01(px, py, 29)) for c in (236, 240, 250))
        sky = mix(sky, (120, 130, 170), 0.5 * max(0.0, 1 - max(abs(x), abs(y)) / 0.3) ** 2)
    return sky


def face_pixel(sky, face, size):
    def pixel(x, y):
        return sky(face_direction(face, (x + 0.5) / size, 1 - (y + 0.5) / size))

    return pixel
