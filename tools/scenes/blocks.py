# SPDX-License-Identifier: MIT
"""Worlds of unit blocks, and the meshes of their visible faces."""

import tiles

# block -> tiles of (top, side, bottom)
KINDS = {
    "grass": ("grass_top", "grass_side", "dirt"),
    "log": ("log_top", "log_side", "log_top"),
    "bookshelf": ("planks", "bookshelf", "planks"),
    "hay": ("hay", "hay", "hay"),
    "farmland": ("farmland", "dirt", "dirt"),
    "path": ("path", "dirt", "dirt"),
    "pumpkin": ("pumpkin", "pumpkin", "pumpkin"),
    "jack": ("pumpkin", "pumpkin_face", "pumpkin"),
    "door": ("dark_planks", "door", "dark_planks"),
}
CLEAR = ("water", "glass")  # blocks that do not hide their neighbours

# face -> (neighbour, four corners counter-clockwise from outside, from the lower left of the tile)
FACES = {
    "top": ((0, 1, 0), ((0, 1, 1), (1, 1, 1), (1, 1, 0), (0, 1, 0))),
    "bottom": ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
    "south": ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
    "north": ((0, 0, -1), ((1, 0, 0), (0, 0, 0), (0, 1, 0), (1, 1, 0))),
    "east": ((1, 0, 0), ((1, 0, 1), (1, 0, 0), (1, 1, 0), (1, 1, 1))),
    "west": ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
}


def tile_of(block, face):
    top, side, bottom = KINDS.get(block, (block, block, block))
    return top if face == "top" else bottom if face == "bottom" else side


class World:
    """Blocks by integer position. Only what is set exists."""

    def __init__(self):
        self.blocks = {}

    def set(self, x, y, z, block):
        if block is None:
            self.blocks.pop((x, y, z), None)
        else:
            self.blocks[(x, y, z)] = block

    def get(self, x, y, z):
        return self.blocks.get((x, y, z))

    def fill(self, low, high, block):
        """Sets every position from `low` to `high`, both inclusive."""
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                for z in range(low[2], high[2] + 1):
                    self.set(x, y, z, block)

    def top(self, x, z):
        """Height of the highest solid block of a column, or None."""
        heights = [p[1] for p, b in self.blocks.items()
                   if p[0] == x and p[2] == z and b not in CLEAR]
        return max(heights, default=None)

    def _quads(self, chosen):
        for position, block in sorted(self.blocks.items()):
            if not chosen(block):
                continue
            for face, (step, corners) in FACES.items():
                neighbour = self.get(*(p + s for p, s in zip(position, step)))
                hidden = neighbour == block if block in CLEAR else (
                    neighbour is not None and neighbour not in CLEAR)
                at_floor = face == "bottom" and position[1] == 0
                if not hidden and not at_floor:
                    yield position, block, face, corners

    def mesh(self, chosen, inset=0.0):
        """OBJ text of the visible faces of the blocks for which `chosen(block)`.

        A clear block's surface is drawn in by `inset`, so that water does not touch its bed.
        """
        vertices, coordinates, faces = {}, {}, []

        def number(table, key):
            return table.setdefault(key, len(table) + 1)

        for position, block, face, corners in self._quads(chosen):
            u0, v0, u1, v1 = tiles.uv_rect(tile_of(block, face)) if block not in CLEAR else (
                0, 0, 1, 1)
            indices = []
            for corner, uv in zip(corners, ((u0, v0), (u1, v0), (u1, v1), (u0, v1))):
                point = [p + c for p, c in zip(position, corner)]
                if block == "water" and corner[1] == 1 and (
                        self.get(position[0], position[1] + 1, position[2]) != "water"):
                    point[1] -= inset
                indices.append("%d/%d" % (number(vertices, tuple(point)), number(coordinates, uv)))
            faces.append("f " + " ".join(indices))
        lines = ["v %g %g %g" % v for v in vertices]
        lines += ["vt %.8g %.8g" % c for c in coordinates]
        return "\n".join(lines + faces) + "\n"
