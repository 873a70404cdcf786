# SPDX-License-Identifier: MIT
"""PNG files of 8-bit RGB pixels, with nothing but the standard library."""

import struct
import zlib


def _chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data
            + struct.pack(">I", zlib.crc32(kind + data)))


def write(path, width, height, pixel):
    """Writes `pixel(x, y) -> (r, g, b)` in 0..255, y from the top."""
    rows = bytearray()
    for y in range(height):
        rows.append(0)  # no row filter
        for x in range(width):
            rows.extend(max(0, min(255, int(c))) for c in pixel(x, y))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header)
                   + _chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + _chunk(b"IEND", b""))
