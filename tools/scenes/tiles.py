# SPDX-License-Identifier: MIT
"""Pixel-art tiles of 16 x 16 pixels, painted by rule, and the atlas that holds them.

A tile is a function (x, y) -> (r, g, b), x to the right and y from the top, both 0..15.
"""

import math

from noise import hash01, value_noise

SIZE = 16
COLUMNS = 8  # tiles in a row of the atlas


def shade(color, factor):
    return tuple(max(0, min(255, int(c * factor + 0.5))) for c in color)


def speckled(color, amount, seed, coarse=0.0):
    """One colour with per-pixel brightness noise, and slower noise of strength `coarse`."""

    def tile(x, y):
        fine = (hash01(x, y, seed) - 0.5) * 2 * amount
        slow = (value_noise(x / 4, y / 4, seed + 1, 4) - 0.5) * 2 * coarse
        return shade(color, 1 + fine + slow)

    return tile


GRASS, DIRT, STONE = (104, 160, 62), (134, 96, 67), (127, 127, 130)
PLANK, BARK, LEAF = (176, 138, 84), (92, 70, 44), (62, 112, 44)

grass_top = speckled(GRASS, 0.13, 11, 0.08)
dirt = speckled(DIRT, 0.14, 12, 0.06)
stone = speckled(STONE, 0.06, 13, 0.10)
sand = speckled((219, 207, 160), 0.05, 14, 0.03)
gravel = speckled((136, 128, 122), 0.22, 15, 0.05)
path = speckled((158, 132, 84), 0.10, 16, 0.08)
snow = speckled((238, 244, 250), 0.025, 17, 0.02)


def grass_side(x, y):
    edge = 3 + int(hash01(x, 21) * 3)
    return grass_top(x, y) if y < edge else dirt(x, y)


def cobble(x, y):
    """Round stones: the nearest of jittered points decides, dark where two are equally near."""
    nearest = []
    for j in range(-1, 5):
        for i in range(-1, 5):
            px = (i + 0.2 + 0.6 * hash01(i % 4, j % 4, 31)) * 4
            py = (j + 0.2 + 0.6 * hash01(i % 4, j % 4, 32)) * 4
            nearest.append((math.hypot(x + 0.5 - px, y + 0.5 - py), i % 4, j % 4))
    nearest.sort()
    first, second = nearest[0], nearest[1]
    if second[0] - first[0] < 0.8:
        return shade(STONE, 0.55)
    tone = 0.85 + 0.35 * hash01(first[1], first[2], 33)
    return shade(STONE, tone * (1 + 0.1 * (hash01(x, y, 34) - 0.5)))


def planks(x, y):
    board, row = y // 4, y % 4
    seam = (board * 5 + 3) % SIZE
    tone = 0.92 + 0.14 * hash01(board, 41) + 0.10 * (hash01(x // 3, y, 42) - 0.5)
    if row == 3 or (x == seam and row < 3):
        tone *= 0.68
    return shade(PLANK, tone)


def dark_planks(x, y):
    return shade(planks(x, y), 0.6)


def log_side(x, y):
    tone = 0.8 + 0.5 * hash01(x, y // 5, 51) * (0.5 + 0.5 * hash01(x, 52))
    return shade(BARK, tone)


def log_top(x, y):
    if x in (0, 15) or y in (0, 15):
        return log_side(x, y)
    ring = int(max(abs(x - 7.5), abs(y - 7.5)))
    return shade(PLANK, 1.08 if ring % 2 else 0.84)


def leaves(x, y):
    n = hash01(x // 2, y // 2, 61) * 0.6 + hash01(x, y, 62) * 0.4
    return shade(LEAF, 0.55 + 0.85 * n)


def blossom(x, y):
    if hash01(x, y, 64) > 0.72:
        return shade((246, 178, 200), 0.9 + 0.15 * hash01(x, y, 65))
    return leaves(x, y)


def brick(x, y):
    row = y // 4
    across = (x + (4 if row % 2 else 0)) % 8
    if y % 4 == 3 or across == 7:
        return shade((186, 176, 164), 0.95 + 0.1 * hash01(x, y, 71))
    tone = 0.85 + 0.3 * hash01((x + (4 if row % 2 else 0)) // 8, row, 72)
    return shade((158, 76, 58), tone + 0.08 * (hash01(x, y, 73) - 0.5))


def roof(x, y):
    row = y // 4
    across = (x + (2 if row % 2 else 0)) % 4
    tone = 1.12 - 0.14 * (y % 4) + 0.16 * (hash01((x + (2 if row % 2 else 0)) // 4, row, 76) - 0.5)
    return shade((170, 64, 48), tone * (0.8 if across == 3 else 1))


def slate(x, y):
    return shade((74, 92, 128), sum(roof(x, y)) / 282 * 1.05)


def plaster(x, y):
    return shade((232, 222, 200), 0.96 + 0.06 * hash01(x, y, 81) - 0.05 * value_noise(x / 5, y / 5, 82))


def timber(x, y):
    """Plaster with a dark wooden frame and a cross beam."""
    frame = x < 2 or x > 13 or y < 2 or y > 13 or abs(x - y) < 2
    return shade(dark_planks(x, y), 0.85) if frame else plaster(x, y)


def door(x, y):
    if x in (0, 15) or y == 0:
        return shade(PLANK, 0.5)
    if 3 <= x <= 12 and 3 <= y <= 6 and x not in (7, 8):
        return (150, 196, 214)
    if x == 12 and 9 <= y <= 10:
        return (226, 190, 84)
    return shade(dark_planks(y, x), 1.25)


def window(x, y):
    if x in (0, 1, 14, 15) or y in (0, 1, 14, 15):
        return shade(PLANK, 0.62)
    if x in (7, 8) or y in (7, 8):
        return shade(PLANK, 0.7)
    glow = 0.9 + 0.12 * ((x + y) % 7 in (0, 1))
    return shade((148, 190, 214), glow)


def lit_window(x, y):
    if window(x, y)[2] < 140:
        return window(x, y)
    return shade((255, 214, 120), 0.9 + 0.1 * hash01(x, y, 91))


def bookshelf(x, y):
    if y in (0, 7, 8, 15):
        return planks(x, y)
    hue = hash01(x // 2, y // 8, 95)
    books = ((150, 48, 44), (52, 86, 142), (60, 122, 66), (196, 158, 62), (112, 66, 128))
    height = 1 + int(hash01(x // 2, y // 8, 96) * 3)
    if y % 8 < height:
        return (52, 38, 26)
    return shade(books[int(hue * 5)], 1.0 if x % 2 else 0.78)


def hay(x, y):
    if y in (4, 11):
        return (150, 60, 40)
    return shade((210, 176, 62), 0.8 + 0.35 * hash01(x, y // 3, 101))


def crops(x, y):
    if hash01(x, 106) > 0.45 and y > 2 + 5 * hash01(x, 107):
        return shade((196, 178, 74) if y < 8 else (112, 150, 50), 0.85 + 0.3 * hash01(x, y, 108))
    return shade((96, 132, 44), 0.8 + 0.2 * hash01(x, y, 109))


def farmland(x, y):
    return shade((96, 66, 44), (0.8 if x % 4 == 3 else 1.05) + 0.12 * (hash01(x, y, 111) - 0.5))


def pumpkin(x, y):
    return shade((222, 128, 32), (0.78 if x % 5 == 0 else 1.02) + 0.08 * (hash01(x, y, 116) - 0.5))


def pumpkin_face(x, y):
    eyes = y in (5, 6) and (x in (3, 4, 5) or x in (10, 11, 12))
    mouth = y in (10, 11) and 3 <= x <= 12 and not (y == 10 and x % 3 == 0)
    return (62, 34, 10) if eyes or mouth else pumpkin(x, y)


def wool(color, seed):
    def tile(x, y):
        return shade(color, 0.94 + 0.10 * hash01(x, y, seed) - (0.05 if (x + y) % 4 == 0 else 0))

    return tile


def iron(x, y):
    return shade((84, 88, 96), 0.85 + 0.2 * hash01(x // 2, y, 121) + (0.2 if x in (2, 13) else 0))


def flame(x, y):
    return shade((255, 226, 150), 0.96 + 0.04 * hash01(x, y, 126))


def moss(x, y):
    return grass_top(x, y) if value_noise(x / 3, y / 3, 131, 5) > 0.56 else cobble(x, y)


def crystal(x, y):
    return shade((150, 110, 220), 0.7 + 0.5 * ((x * 3 + y * 5) % 11) / 11)


TILES = [
    ("grass_top", grass_top), ("grass_side", grass_side), ("dirt", dirt), ("stone", stone),
    ("cobble", cobble), ("sand", sand), ("gravel", gravel), ("path", path),
    ("planks", planks), ("dark_planks", dark_planks), ("log_side", log_side), ("log_top", log_top),
    ("leaves", leaves), ("blossom", blossom), ("brick", brick), ("roof", roof),
    ("slate", slate), ("plaster", plaster), ("timber", timber), ("door", door),
    ("window", window), ("lit_window", lit_window), ("bookshelf", bookshelf), ("hay", hay),
    ("crops", crops), ("farmland", farmland), ("pumpkin", pumpkin), ("pumpkin_face", pumpkin_face),
    ("iron", iron), ("flame", flame), ("moss", moss), ("crystal", crystal),
    ("snow", snow), ("red_wool", wool((170, 44, 44), 141)), ("blue_wool", wool((52, 80, 160), 142)),
    ("white_wool", wool((232, 232, 228), 143)),
]
INDEX = {name: i for i, (name, _) in enumerate(TILES)}
ROWS = (len(TILES) + COLUMNS - 1) // COLUMNS


def atlas_pixel(x, y):
    index = (y // SIZE) * COLUMNS + x // SIZE
    if index >= len(TILES):
        return (0, 0, 0)
    return TILES[index][1](x % SIZE, y % SIZE)


def uv_rect(name):
    """(u0, v0, u1, v1) of a tile, v upwards, drawn in by 1/64 texel so that an edge stays inside."""
    index = INDEX[name]
    column, row = index % COLUMNS, index // COLUMNS
    width, height = COLUMNS * SIZE, ROWS * SIZE
    inset = 1 / 64
    return ((column * SIZE + inset) / width, 1 - ((row + 1) * SIZE - inset) / height,
            ((column + 1) * SIZE - inset) / width, 1 - (row * SIZE + inset) / height)
