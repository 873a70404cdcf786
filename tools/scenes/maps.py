# SPDX-License-Identifier: MIT
"""Larger pictures: a brick wall with its normal map, a rough height map, a checker, a test chart."""

import math

import tiles
from noise import hash01, value_noise

WALL = 128


def _wall_height(x, y):
    """Height of the brick wall in 0..1; tiles in both directions."""
    x, y = x % WALL, y % WALL
    row = int(y // 16)
    shift = 16 if row % 2 else 0
    across, up = (x + shift) % 32, y % 16
    edge = min(across, 32 - across, up, 16 - up)
    brick = max(0.0, min(1.0, (edge - 1.2) / 1.8))
    rough = value_noise(x / 4, y / 4, 301, 32) * 0.6 + value_noise(x / 2, y / 2, 302, 64) * 0.4
    tilt = (hash01(int((x + shift) // 32) % 4, row, 303) - 0.5) * 0.3
    return brick * (0.75 + tilt * across / 32) + 0.22 * rough


def wall_color(x, y):
    row = int(y // 16)
    shift = 16 if row % 2 else 0
    column = int((x + shift) // 32) % 4
    across, up = (x + shift) % 32, y % 16
    edge = min(across, 32 - across, up, 16 - up)
    rough = 0.86 + 0.28 * value_noise(x / 3, y / 3, 304, 43)
    if edge < 1.6:
        return tiles.shade((196, 188, 176), rough)
    return tiles.shade((172, 86, 62), rough * (0.82 + 0.36 * hash01(column, row, 305)))


def wall_normal(x, y):
    strength = 2.4
    dx = (_wall_height(x + 1, y) - _wall_height(x - 1, y)) * strength
    dy = (_wall_height(x, y - 1) - _wall_height(x, y + 1)) * strength  # v runs upwards
    length = math.sqrt(dx * dx + dy * dy + 1)
    return tuple(128 + 127 * c / length for c in (-dx, -dy, 1))


def ripples_height(x, y):
    """Rings around two drops, as a height map of 256 x 256."""
    total = 0.0
    for cx, cy, scale in ((90, 110, 5.0), (180, 160, 7.0)):
        r = math.hypot(x - cx, y - cy)
        total += math.sin(r / scale) * math.exp(-r / 70)
    value = 128 + 90 * total / 2
    return (value, value, value)


def checker(x, y):
    even = (x // 16 + y // 16) % 2 == 0
    return (226, 222, 214) if even else (74, 82, 96)


def chart(x, y):
    """Letters of the four corners: red grows with u, green with v, with a frame and an arrow up."""
    if x < 2 or y < 2 or x > 61 or y > 61:
        return (20, 20, 24)
    arrow = (abs(x - 31.5) < 2 and 14 <= y <= 50) or (abs(x - 31.5) < (y - 8) and 8 <= y <= 20)
    if arrow:
        return (250, 250, 250)
    return (40 + 3 * x, 40 + 3 * (63 - y), 110)
