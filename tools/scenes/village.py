# SPDX-License-Identifier: MIT
"""The village: land with a river, houses, trees, fields, lamps."""

import math

from blocks import World
from noise import hash01, value_noise

SIZE = 52
WATER_LEVEL = 4


def river_distance(x, z):
    """How far (x, z) is from the middle of the river that crosses the land."""
    middle = 15 + 6 * math.sin(z / 9.0) + 3 * math.sin(z / 4.3 + 1)
    return abs(x - middle)


def ground_height(x, z):
    hills = 5.2 + 3.0 * (value_noise(x / 13.0, z / 13.0, 201) - 0.35)
    back = max(0.0, (16 - z) / 16.0) ** 2 * 10 * (0.5 + value_noise(x / 9.0, z / 9.0, 202))
    far = max(0.0, (x - 44) / 8.0) ** 2 * 3
    village = math.exp(-(((x - 31) / 13.0) ** 4 + ((z - 31) / 12.0) ** 4))
    height = hills + back + far
    height += village * (5.6 - height)
    river = river_distance(x, z)
    if river < 5.5:
        height = min(height, 2.2 + max(0.0, river - 1.6) * 0.95)
    return int(height)


def make_ground(world):
    for x in range(SIZE):
        for z in range(SIZE):
            height = ground_height(x, z)
            shore = river_distance(x, z) < 5.4 and height <= WATER_LEVEL + 0
            for y in range(height):
                deep = y < height - 3
                world.set(x, y, z, "stone" if deep else "dirt")
            top = "grass"
            if shore:
                top = "sand" if hash01(x, z, 210) > 0.25 else "gravel"
            elif height > 11:
                top = "snow" if hash01(x, z, 211) > 0.2 else "stone"
            elif height > 9:
                top = "stone" if hash01(x, z, 212) > 0.35 else "grass"
            world.set(x, height, z, top)
            for y in range(height + 1, WATER_LEVEL + 1):
                world.set(x, y, z, "water")


def tree(world, x, z, crown="leaves", height=4):
    base = world.top(x, z)
    if base is None or world.get(x, base, z) != "grass":
        return
    for dy in range(1, height + 1):
        world.set(x, base + dy, z, "log")
    for dy in range(height - 1, height + 3):
        radius = 2 if dy < height + 1 else 1
        for dx in range(-radius, radius + 1):
            for dz in range(-radius, radius + 1):
                corner = abs(dx) == radius and abs(dz) == radius
                if corner and (dy > height or hash01(x + dx, dy, z + dz, 221) > 0.35):
                    continue
                spot = (x + dx, base + dy, z + dz)
                if world.get(*spot) is None:
                    world.set(*spot, crown)


def house(world, x, z, width, depth, storeys=1, walls="timber", roof="roof", door="south"):
    """A house on the ground with its lower corner at (x, z)."""
    floor = 5
    height = 3 * storeys + 1
    world.fill((x - 1, floor + 1, z - 1), (x + width, floor + height + 6, z + depth), None)
    world.fill((x, floor - 1, z), (x + width - 1, floor, z + depth - 1), "cobble")
    for y in range(floor + 1, floor + height + 1):
        for i in range(x, x + width):
            for k in range(z, z + depth):
                edge_x, edge_z = i in (x, x + width - 1), k in (z, z + depth - 1)
                if not (edge_x or edge_z):
                    continue
                if edge_x and edge_z:
                    block = "log"
                elif y == floor + 1:
                    block = "cobble"
                elif (y - floor) % 3 == 1 and storeys > 1 and y > floor + 1:
                    block = "dark_planks"
                else:
                    block = walls
                    along = i - x if edge_z else k - z
                    span = width if edge_z else depth
                    lit = hash01(i, y, k, 231) > 0.6
                    if (y - floor) % 3 == 2 and along % 2 == 0 and 0 < along < span - 1:
                        block = "lit_window" if lit else "window"
                world.set(i, y, k, block)
    middle = x + width // 2
    if door == "south":
        place = (middle, z + depth - 1, 0, 1)
    elif door == "north":
        place = (middle, z, 0, -1)
    elif door == "west":
        place = (x, z + depth // 2, -1, 0)
    else:
        place = (x + width - 1, z + depth // 2, 1, 0)
    world.set(place[0], floor + 1, place[1], "dark_planks")
    world.set(place[0], floor + 2, place[1], "door")
    world.set(place[0] + place[2], floor, place[1] + place[3], "path")
    # The ridge runs along the longer side; the roof hangs over by one.
    along_x = width >= depth
    half = ((depth if along_x else width) + 2) // 2
    for step in range(half + 1):
        y = floor + height + step
        if along_x:
            low, high = z - 1 + step, z + depth - step
            if low > high:
                break
            for i in range(x - 1, x + width + 1):
                world.set(i, y, low, roof)
                world.set(i, y, high, roof)
            for k in range(low + 1, high):  # the gables
                world.set(x, y, k, walls if step else "log")
                world.set(x + width - 1, y, k, walls if step else "log")
        else:
            low, high = x - 1 + step, x + width - step
            if low > high:
                break
            for k in range(z - 1, z + depth + 1):
                world.set(low, y, k, roof)
                world.set(high, y, k, roof)
            for i in range(low + 1, high):
                world.set(i, y, z, walls if step else "log")
                world.set(i, y, z + depth - 1, walls if step else "log")


def chimney(world, x, z, low, high):
    world.fill((x, low, z), (x, high, z), "brick")


def street(world, points):
    """Paths of width two between neighbouring points."""
    for (x0, z0), (x1, z1) in zip(points, points[1:]):
        steps = max(abs(x1 - x0), abs(z1 - z0), 1)
        for s in range(steps + 1):
            x, z = round(x0 + (x1 - x0) * s / steps), round(z0 + (z1 - z0) * s / steps)
            for dx in (0, 1):
                for dz in (0, 1):
                    y = world.top(x + dx, z + dz)
                    if y is not None and world.get(x + dx, y, z + dz) in ("grass", "dirt", "path"):
                        if hash01(x + dx, z + dz, 241) > 0.08:
                            world.set(x + dx, y, z + dz, "path")


def bridge(world, z):
    spots = [x for x in range(SIZE) if river_distance(x, z) < 6.2]
    for x in range(min(spots), max(spots) + 1):
        for dz in (0, 1, 2):
            world.set(x, WATER_LEVEL + 2, z + dz, "planks")
            if dz != 1 and (x - min(spots)) % 3 == 0:
                world.set(x, WATER_LEVEL + 3, z + dz, "log")
    return min(spots), max(spots)


def field(world, x, z, width, depth):
    for i in range(x, x + width):
        for k in range(z, z + depth):
            y = world.top(i, k)
            edge = i in (x, x + width - 1) or k in (z, z + depth - 1)
            if edge:
                world.set(i, y, k, "log")
            elif i == x + width // 2:
                world.set(i, y, k, "water")
            else:
                world.set(i, y, k, "farmland")
                world.set(i, y + 1, k, "crops")


def well(world, x, z):
    y = 5
    world.fill((x, y, z), (x + 2, y + 1, z + 2), "moss")
    world.set(x + 1, y + 1, z + 1, "water")
    world.set(x + 1, y, z + 1, "water")
    for dx in (0, 2):
        for dz in (0, 2):
            world.set(x + dx, y + 2, z + dz, "log")
            world.set(x + dx, y + 3, z + dz, "log")
    world.fill((x, y + 4, z), (x + 2, y + 4, z + 2), "slate")
    world.set(x + 1, y + 5, z + 1, "slate")



def build():
    world = World()
    make_ground(world)
    house(world, 34, 28, 8, 6, storeys=2, walls="timber", roof="roof", door="west")
    chimney(world, 40, 30, 12, 17)
    house(world, 24, 22, 7, 6, storeys=1, walls="planks", roof="slate", door="south")
    house(world, 35, 39, 7, 6, storeys=1, walls="plaster", roof="roof", door="north")
    house(world, 25, 43, 6, 5, storeys=1, walls="brick", roof="slate", door="north")
    house(world, 33, 18, 6, 7, storeys=1, walls="timber", roof="slate", door="south")
    chimney(world, 34, 20, 9, 13)
    well(world, 28, 30)
    street(world, [(20, 36), (26, 36), (33, 36), (42, 37)])
    street(world, [(27, 42), (27, 36), (27, 28)])
    street(world, [(31, 36), (31, 27), (36, 26)])
    street(world, [(38, 38), (38, 36)])
    bridge(world, 36)
    field(world, 42, 41, 7, 8)
    for x, z, kind, height in (
            (22, 47, "leaves", 4), (32, 47, "blossom", 4), (45, 34, "leaves", 5),
            (44, 24, "blossom", 4), (29, 15, "leaves", 5), (41, 15, "leaves", 4),
            (47, 20, "leaves", 5), (22, 20, "blossom", 4), (5, 30, "leaves", 5),
            (8, 40, "leaves", 4), (3, 46, "leaves", 5), (6, 20, "leaves", 4),
            (24, 12, "leaves", 5), (49, 29, "leaves", 4), (10, 47, "blossom", 4),
            (36, 10, "leaves", 4), (46, 11, "leaves", 5), (2, 38, "leaves", 4)):
        tree(world, x, z, kind, height)
    for x, z, block in ((32, 44, "hay"), (33, 44, "hay"), (29, 38, "jack"), (30, 38, "pumpkin"),
                        (33, 46, "pumpkin"), (32, 45, "hay"), (32, 44, "hay")):
        world.set(x, world.top(x, z) + 1, z, block)
    return world
