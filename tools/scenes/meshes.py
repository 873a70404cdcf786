# SPDX-License-Identifier: MIT
"""Meshes from formulas, as OBJ text."""

import math


def _obj(points, coordinates, faces):
    lines = ["v %.6g %.6g %.6g" % p for p in points]
    lines += ["vt %.6g %.6g" % c for c in coordinates]
    lines += ["f " + " ".join("%d/%d" % (i + 1, t + 1) for i, t in face) for face in faces]
    return "\n".join(lines) + "\n"


def _grid(columns, rows, point, wrap_columns, wrap_rows):
    """A grid of quads; texture coordinates do not wrap, so that seams are clean."""
    count_c = columns if wrap_columns else columns + 1
    count_r = rows if wrap_rows else rows + 1
    points = [point(i / columns, j / rows) for j in range(count_r) for i in range(count_c)]
    coordinates = [(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]

    def p(i, j):
        return (j % count_r) * count_c + i % count_c

    def t(i, j):
        return j * (columns + 1) + i

    faces = [[(p(a, b), t(a, b)) for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
             for j in range(rows) for i in range(columns)]
    return _obj(points, coordinates, faces)


def torus_knot(p=2, q=3, columns=192, rows=20, tube=0.32):
    """A tube along the (p, q) torus knot; the frame follows the torus."""

    def center(s):
        a = 2 * math.pi * s
        r = 1.0 + 0.42 * math.cos(q * a)
        return (r * math.cos(p * a), r * math.sin(p * a), 0.42 * math.sin(q * a) * 1.4)

    def point(s, t):
        c, ahead = center(s), center(s + 1e-4)
        tangent = [b - a for a, b in zip(c, ahead)]
        length = math.sqrt(sum(x * x for x in tangent))
        tangent = [x / length for x in tangent]
        side = (c[1] * tangent[2] - c[2] * tangent[1], c[2] * tangent[0] - c[0] * tangent[2],
                c[0] * tangent[1] - c[1] * tangent[0])
        length = math.sqrt(sum(x * x for x in side))
        side = [x / length for x in side]
        up = (tangent[1] * side[2] - tangent[2] * side[1], tangent[2] * side[0] - tangent[0] * side[2],
              tangent[0] * side[1] - tangent[1] * side[0])
        a = -2 * math.pi * t
        return tuple(c[i] + tube * (math.cos(a) * side[i] + math.sin(a) * up[i]) for i in range(3))

    return _grid(columns, rows, point, True, True)


def vase(columns=64, rows=48):
    """A surface of revolution about +y, from the foot up to the lip, and back down inside."""

    def radius(h):
        return 0.42 + 0.34 * math.sin(h * 4.1 + 0.3) * (1 - 0.35 * h) + 0.10 * h ** 6

    def point(s, t):
        a = -2 * math.pi * s
        if t < 0.62:
            h, inward = t / 0.62, 0.0
        else:
            h, inward = max(0.06, 1 - (t - 0.62) / 0.38 * 0.94), 0.05
        r = max(0.02, radius(h) - inward)
        return (r * math.cos(a), 1.9 * h, r * math.sin(a))

    return _grid(columns, rows, point, True, False)


def gem(sides=8):
    """A cut stone: table, crown, girdle, pavilion; flat faces, the point at y = 0."""
    points, faces = [], []

    def ring(count, radius, height, turn):
        first = len(points)
        for k in range(count):
            a = 2 * math.pi * (k + turn) / count
            points.append((radius * math.cos(a), height, radius * math.sin(a)))
        return first

    table, crown, girdle = ring(sides, 0.55, 1.35, 0), ring(sides, 0.86, 1.17, 0.5), ring(sides, 1.0, 0.95, 0)
    tip = len(points)
    points.append((0.0, 0.0, 0.0))
    faces.append([table + k for k in reversed(range(sides))])
    for k in range(sides):
        n, b = (k + 1) % sides, (k - 1) % sides
        faces.append([table + k, table + n, crown + k])
        faces.append([crown + k, girdle + k, table + k])
        faces.append([crown + b, table + k, girdle + k])
        faces.append([crown + k, girdle + n, girdle + k])
        faces.append([girdle + k, girdle + n, tip])
    lines = ["v %.6g %.6g %.6g" % p for p in points]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    return "\n".join(lines) + "\n"


def twisted_column(columns=64, rows=60):
    """A fluted, twisted column of height 2: eight sharp creases between smooth parts."""

    def point(s, t):
        a = -2 * math.pi * s
        flute = 0.08 * abs(math.sin(4 * a))  # its edges lie on columns of the grid
        r = 0.34 + flute + 0.06 * math.sin(math.pi * t)
        return (r * math.cos(a - 2.2 * t), 2 * t, r * math.sin(a - 2.2 * t))

    return _grid(columns, rows, point, True, False)
