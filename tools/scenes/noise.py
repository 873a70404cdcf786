# SPDX-License-Identifier: MIT
"""Deterministic random numbers: a hash of integers, and smooth noise made of it."""


def hash01(*keys):
    """A number in [0, 1) that depends on the integers `keys` alone (a murmur-style mix)."""
    h = 0x9E3779B97F4A7C15
    for key in keys:
        h ^= key & 0xFFFFFFFFFFFFFFFF
        h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCD & 0xFFFFFFFFFFFFFFFF
        h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53 & 0xFFFFFFFFFFFFFFFF
        h ^= h >> 33
    return (h >> 11) / float(1 << 53)


def _fade(t):
    return t * t * (3 - 2 * t)


def value_noise(x, y, seed, period=None):
    """Smooth value noise in [0, 1) over the unit lattice; `period` makes it tile."""
    x0, y0 = int(x // 1), int(y // 1)
    fx, fy = _fade(x - x0), _fade(y - y0)

    def corner(i, j):
        if period:
            i, j = i % period, j % period
        return hash01(i, j, seed)

    low = corner(x0, y0) + fx * (corner(x0 + 1, y0) - corner(x0, y0))
    high = corner(x0, y0 + 1) + fx * (corner(x0 + 1, y0 + 1) - corner(x0, y0 + 1))
    return low + fy * (high - low)


def value_noise3(x, y, z, seed):
    """The same in three dimensions."""
    x0, y0, z0 = int(x // 1), int(y // 1), int(z // 1)
    f = _fade(z - z0)

    def slab(k):
        fx, fy = _fade(x - x0), _fade(y - y0)
        a = hash01(x0, y0, k, seed)
        b = hash01(x0 + 1, y0, k, seed)
        c = hash01(x0, y0 + 1, k, seed)
        d = hash01(x0 + 1, y0 + 1, k, seed)
        low, high = a + fx * (b - a), c + fx * (d - c)
        return low + fy * (high - low)

    return slab(z0) + f * (slab(z0 + 1) - slab(z0))
