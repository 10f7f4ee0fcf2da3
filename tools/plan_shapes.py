"""Shapes in a plan file, measured: for findings.py."""

import contextlib
import math
import sqlite3
import struct

STRAIGHT_M = 1.0  # a side may bend by so much and still be one edge: registers cut straight edges into many


def polygon_rings(blob):
    """The rings of a polygon in GeoPackage's encoding: a header, an envelope, little-endian WKB."""
    at = 8 + {0: 0, 1: 32, 2: 48, 3: 48, 4: 64}[blob[3] >> 1 & 7]
    order, kind, count = struct.unpack_from("<BII", blob, at)
    if (order, kind) != (1, 3):
        raise ValueError(f"not a little-endian polygon: {order}, {kind}")
    at, rings = at + 9, []
    for _ in range(count):
        size = struct.unpack_from("<I", blob, at)[0]
        numbers = struct.unpack_from(f"<{2 * size}d", blob, at + 4)
        rings.append(list(zip(numbers[0:-2:2], numbers[1:-2:2])))  # the last point repeats the first
        at += 4 + 16 * size
    return rings


def bearing(a, b):
    """Clockwise from the north of the field's plane, in [0, 180)."""
    return math.degrees(math.atan2(b[0] - a[0], b[1] - a[1])) % 180


def from_line(p, a, b):
    return abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / math.dist(a, b)


def longest_edge(ring):
    """The two vertices farthest apart between which the ring stays within STRAIGHT_M of a straight line."""
    best = (ring[0], ring[1])
    for i, start in enumerate(ring):
        for steps in range(1, len(ring)):
            end = ring[(i + steps) % len(ring)]
            between = [ring[(i + k) % len(ring)] for k in range(1, steps)]
            if start == end or any(from_line(p, start, end) > STRAIGHT_M for p in between):
                break
            if math.dist(start, end) > math.dist(*best):
                best = (start, end)
    return best


def extent(ring, degrees):
    x, y = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    reach = [p[0] * x + p[1] * y for p in ring]
    return max(reach) - min(reach)


def corners_above(ring, threshold, inside):
    """How many corners are larger, seen from the field, which lies inside the ring or round it."""
    turn, count = 1 if sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) > 0 else -1, 0
    for before, here, after in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1]):
        bend = math.degrees(math.atan2(after[1] - here[1], after[0] - here[0])
                            - math.atan2(here[1] - before[1], here[0] - before[0])) * turn
        corner = 180 - ((bend + 180) % 360 - 180)
        count += (corner if inside else 360 - corner) > threshold + 1e-9
    return count


def measure(file, decomposition):
    """How a plan's main subfield, the largest, lies to the longest edge of the field, and what the field is like."""
    with contextlib.closing(sqlite3.connect(file)) as plan:
        outer = polygon_rings(plan.execute("SELECT geom FROM field").fetchone()[0])[0]
        holes = [polygon_rings(row[0])[0] for row in plan.execute("SELECT geom FROM obstacles")]
        main = plan.execute("SELECT direction_deg FROM subfields ORDER BY area_m2 DESC").fetchone()[0]
    edge = longest_edge(outer)
    along = bearing(*edge)
    return {"edge_m": math.dist(*edge), "along_m": extent(outer, along), "across_m": extent(outer, along + 90),
            "angle": abs((main - along + 90) % 180 - 90), "reach_m": extent(outer, main),
            "corners": corners_above(outer, decomposition, True)
            + sum(corners_above(hole, decomposition, False) for hole in holes)}
