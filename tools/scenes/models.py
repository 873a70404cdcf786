# SPDX-License-Identifier: MIT
"""Models made of boxes with tiles of the atlas on their faces."""

from blocks import FACES, tile_of
import tiles


def boxes_mesh(boxes):
    """OBJ text of (low, high, block) boxes."""
    points, coordinates, faces = [], [], []
    for low, high, block in boxes:
        for face, (_, corners) in FACES.items():
            u0, v0, u1, v1 = tiles.uv_rect(tile_of(block, face))
            first = len(points)
            for corner in corners:
                points.append(tuple(h if c else l for c, l, h in zip(corner, low, high)))
            coordinates += [(u0, v0), (u1, v0), (u1, v1), (u0, v1)]
            faces.append("f " + " ".join("%d/%d" % (first + k, first + k) for k in range(1, 5)))
    lines = ["v %.6g %.6g %.6g" % p for p in points]
    lines += ["vt %.8g %.8g" % c for c in coordinates]
    return "\n".join(lines + faces) + "\n"


def lamp():
    """A lantern on a post, its foot at the origin; the cage is open, the flame stands apart."""
    rods = [((x, 2.3, z), (x + 0.06, 2.82, z + 0.06), "iron")
            for x in (-0.25, 0.19) for z in (-0.25, 0.19)]
    return boxes_mesh(rods + [
        ((-0.11, 0, -0.11), (0.11, 2.24, 0.11), "dark_planks"),
        ((-0.2, 0, -0.2), (0.2, 0.18, 0.2), "cobble"),
        ((-0.27, 2.24, -0.27), (0.27, 2.3, 0.27), "iron"),
        ((-0.31, 2.82, -0.31), (0.31, 2.92, 0.31), "iron"),
        ((-0.15, 2.92, -0.15), (0.15, 3.02, 0.15), "iron"),
    ])


def boat():
    """A small rowing boat, floating at y = 0."""
    return boxes_mesh([
        ((-0.6, -0.2, -1.2), (0.6, -0.05, 1.2), "planks"),
        ((-0.72, -0.2, -1.2), (-0.58, 0.25, 1.2), "dark_planks"),
        ((0.58, -0.2, -1.2), (0.72, 0.25, 1.2), "dark_planks"),
        ((-0.6, -0.2, -1.36), (0.6, 0.3, -1.2), "dark_planks"),
        ((-0.6, -0.2, 1.2), (0.6, 0.3, 1.36), "dark_planks"),
        ((-0.58, 0.05, -0.5), (0.58, 0.13, -0.2), "planks"),
        ((-0.58, 0.05, 0.4), (0.58, 0.13, 0.7), "planks"),
    ])


def grass_block():
    return boxes_mesh([((0, 0, 0), (1, 1, 1), "grass")])
