"""PNG pictures made smaller: half as wide and high, fewer colours. Reads what tramline writes: 8-bit RGB, not interlaced."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
COLOUR_STEP = 16  # colours are rounded to multiples of this: flat land compresses to nothing


def chunks(data):
    at = len(SIGNATURE)
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8:at + 8 + size]
        at += 12 + size


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def unfiltered(kind, line, above):
    """One row of pixels, three bytes each, from what its filter left."""
    row = bytearray(line)
    if kind == 2:
        return bytearray((x + b) & 255 for x, b in zip(row, above))
    if kind:
        for i, x in enumerate(row):
            a, b, c = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            row[i] = (x + (a if kind == 1 else (a + b) // 2 if kind == 3 else paeth(a, b, c))) & 255
    return row


def rows_of(data):
    parts = list(chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if not data.startswith(SIGNATURE) or (depth, colour, interlaced) != (8, 2, 0):
        raise ValueError("not an 8-bit RGB picture")
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    size, above, rows = 3 * width, bytes(3 * width), []
    for y in range(height):
        start = y * (size + 1)
        above = unfiltered(raw[start], raw[start + 1:start + 1 + size], above)
        rows.append(above)
    return rows


def rounded(total):
    return min(255, (total // 4 + COLOUR_STEP // 2) // COLOUR_STEP * COLOUR_STEP)


def halved(rows):
    """Means of four pixels each."""
    table = bytes(rounded(total) for total in range(4 * 255 + 1))
    out = []
    for upper, lower in zip(rows[::2], rows[1::2]):
        both = [a + b for a, b in zip(upper, lower)]
        size = len(both) // 6 * 6
        row = bytearray(size // 2)
        for channel in range(3):
            row[channel::3] = bytes(table[a + b] for a, b in zip(both[channel:size:6], both[channel + 3:size:6]))
        out.append(bytes(row))
    return out


def written(rows):
    """The picture with a palette, if it has 256 colours at most, else RGB."""
    width = len(rows[0]) // 3
    pixels = [[row[i:i + 3] for i in range(0, len(row), 3)] for row in rows]
    palette = sorted({pixel for row in pixels for pixel in row})
    parts = []
    if len(palette) <= 256:
        number = {pixel: i for i, pixel in enumerate(palette)}
        parts.append((b"PLTE", b"".join(palette)))
        rows = [bytes(number[pixel] for pixel in row) for row in pixels]
    header = struct.pack(">IIBBBBB", width, len(rows), 8, 3 if parts else 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    out = SIGNATURE
    for kind, data in [(b"IHDR", header), *parts, (b"IDAT", body), (b"IEND", b"")]:
        out += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return out


def shrink(file):
    file.write_bytes(written(halved(rows_of(file.read_bytes()))))
