#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes every texture and mesh under scenes/: `tools/scenes/generate.py [FOLDER]`.

Pictures and meshes come from the rules in this folder alone, the same on every machine.
"""

import pathlib
import sys

import maps
import meshes
import models
import png
import sky
import tiles
import village

SKY_SIZE = 256
LONE_TILES = ("grass_top", "dirt", "stone", "cobble", "sand", "planks", "dark_planks", "log_side",
              "leaves", "brick", "window", "bookshelf", "hay", "pumpkin", "pumpkin_face", "iron",
              "flame", "crystal", "red_wool", "blue_wool", "white_wool", "path")


def write_pictures(folder):
    (folder / "tiles").mkdir(parents=True, exist_ok=True)
    png.write(folder / "blocks.png", tiles.COLUMNS * tiles.SIZE, tiles.ROWS * tiles.SIZE,
              tiles.atlas_pixel)
    painted = dict(tiles.TILES)
    for name in LONE_TILES:
        png.write(folder / "tiles" / (name + ".png"), tiles.SIZE, tiles.SIZE, painted[name])
    png.write(folder / "wall.png", maps.WALL, maps.WALL, maps.wall_color)
    png.write(folder / "wall_normal.png", maps.WALL, maps.WALL, maps.wall_normal)
    png.write(folder / "ripples.png", 256, 256, maps.ripples_height)
    png.write(folder / "checker.png", 64, 64, maps.checker)
    png.write(folder / "chart.png", 64, 64, maps.chart)
    for name, rule in FACE_TEXTURES.items():
        png.write(folder / "tiles" / (name + ".png"), 8, 8, rule)


def _face(skin, eye, mouth, rows):
    """An 8 x 8 face drawn in `rows` of letters: . skin, e eye, w white, m mouth, h hair."""

    def pixel(x, y):
        letter = rows[y][x]
        return {".": skin, "e": eye, "w": (244, 244, 240), "m": mouth, "h": (66, 42, 26),
                "n": tuple(int(c * 0.86) for c in skin)}[letter]

    return pixel


FACE_TEXTURES = {
    "face_miner": _face((222, 176, 140), (58, 92, 150), (150, 84, 74), (
        "hhhhhhhh", "hhhhhhhh", "h......h", ".we..ew.", "...nn...", "..hhhh..", "..hmmh..", "...hh...")),
    "face_gardener": _face((176, 122, 86), (52, 96, 52), (128, 62, 56), (
        "hhhhhhhh", "hh....hh", "h......h", ".we..ew.", "........", "...nn...", "..m..m..", "...mm...")),
    "face_sheep": _face((206, 178, 156), (34, 30, 30), (176, 120, 120), (
        "........", "........", "w......w", "ew....we", "........", "...mm...", "...mm...", "........")),
    "face_fox": _face((214, 118, 46), (30, 26, 24), (40, 30, 28), (
        "........", "........", "e.e..e.e", "........", "ww....ww", "wwwmmwww", "wwwwwwww", "wwwwwwww")),
}


def write_skies(folder):
    for name, rule in (("day", sky.day), ("night", sky.night)):
        (folder / name).mkdir(parents=True, exist_ok=True)
        for face in sky.FACES:
            png.write(folder / name / (face + ".png"), SKY_SIZE, SKY_SIZE,
                      sky.face_pixel(rule, face, SKY_SIZE))


def write_meshes(folder):
    folder.mkdir(parents=True, exist_ok=True)
    world = village.build()
    for name, text in (
            ("knot", meshes.torus_knot()), ("vase", meshes.vase()), ("gem", meshes.gem()),
            ("column", meshes.twisted_column()), ("lamp", models.lamp()), ("boat", models.boat()),
            ("grass_block", models.grass_block()),
            ("village_land", world.mesh(lambda block: block != "water")),
            ("village_water", world.mesh(lambda block: block == "water", inset=0.12))):
        (folder / (name + ".obj")).write_text(text, encoding="ascii")


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else (
        pathlib.Path(__file__).resolve().parents[2] / "scenes")
    write_pictures(root / "textures")
    write_skies(root / "sky")
    write_meshes(root / "meshes")


if __name__ == "__main__":
    main()
