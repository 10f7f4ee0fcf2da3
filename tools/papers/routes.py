"""Drives for Zhang's tables: logs in examples/papers.

The eleven routes over the pentagon of Zhang §3.1 are those of `tests/coverage/pentagon_routes.cpp`, where their areas are
worked out by polygon booleans; the irregular one is that of `bench/irregular_route.cpp`.
"""

import math
from dataclasses import dataclass

from draw_examples import closed, feature, write_geojson

WIDTH_M, STEP_M = 4, 1
A1, A2, A3, A4, A5 = (7.5, 5), (32.5, 5), (42.5, 30), (5, 37.5), (2, 20)
PENTAGON = [A1, A2, A3, A4, A5]


@dataclass
class Route:
    edge: str  # along which the first row lies, in the direction it is driven
    ends: str  # of rows: "strip", as far as there is field in the row's strip; "centre", where its centre line ends
    legs: str  # between rows: "none", "direct", "square" to both, or "along": along the edge where the field widens
    covered_m2: float  # by polygon booleans, to 0.0005
    repeated_m2: float
    missed_m2: float

    @property
    def name(self):
        return f"pentagon-{self.edge}-{self.ends}-{self.legs}".lower()


ROUTES = [
    Route("A3A2", "strip", "none", 1074.437, 0, 0), Route("A3A2", "strip", "direct", 1169.827, 95.391, 0),
    Route("A3A2", "strip", "square", 1241.916, 72.000, 0), Route("A3A4", "strip", "none", 1055.267, 0, 0),
    Route("A3A4", "strip", "direct", 1113.551, 58.284, 0), Route("A3A4", "strip", "square", 1136.524, 56.000, 0),
    Route("A1A2", "strip", "none", 1090.743, 0, 0), Route("A1A2", "strip", "direct", 1180.402, 89.659, 0),
    Route("A1A2", "strip", "square", 1245.981, 64.000, 0), Route("A1A2", "centre", "direct", 1076.732, 91.284, 12.499),
    Route("A1A2", "centre", "along", 1127.151, 58.370, 12.499)]
EDGES = {"A3A2": (A3, A2), "A3A4": (A3, A4), "A1A2": (A1, A2)}


class Frame:
    """The pentagon seen along an edge: how far along it and how deep in the field."""

    def __init__(self, a, b):
        length = math.dist(a, b)
        self.origin, self.u = a, ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        self.n = (-self.u[1], self.u[0])
        if self.depth((20, 20)) < 0:
            self.n = (self.u[1], -self.u[0])

    def along(self, p):
        return (p[0] - self.origin[0]) * self.u[0] + (p[1] - self.origin[1]) * self.u[1]

    def depth(self, p):
        return (p[0] - self.origin[0]) * self.n[0] + (p[1] - self.origin[1]) * self.n[1]

    def place(self, along, depth):
        return tuple(self.origin[i] + along * self.u[i] + depth * self.n[i] for i in (0, 1))


def extent(frame, low, high):
    """From where to where the pentagon reaches along the edge between two depths; None: nowhere."""
    found = [frame.along(p) for p in PENTAGON if low - 1e-9 < frame.depth(p) < high + 1e-9]
    for a, b in zip(PENTAGON, PENTAGON[1:] + PENTAGON[:1]):
        for depth in (low, high):
            if (frame.depth(a) < depth) != (frame.depth(b) < depth):
                share = (depth - frame.depth(a)) / (frame.depth(b) - frame.depth(a))
                found.append(frame.along(a) + share * (frame.along(b) - frame.along(a)))
    return [min(found), max(found)] if found else None


def rows_of(frame, ends):
    rows, strip = [], ends == "strip"
    while True:
        row = extent(frame, (len(rows) + (0 if strip else 0.5)) * WIDTH_M, (len(rows) + (1 if strip else 0.5)) * WIDTH_M)
        if row is None:
            return rows
        rows.append(row)


def lengthened(rows, legs):
    """Rows made longer so that legs can be square to them; even rows are driven towards the high end."""
    for i, (row, following) in enumerate(zip(rows, rows[1:])):
        end, farther = (1, max) if i % 2 == 0 else (0, min)
        reach = farther(row[end], following[end])
        if legs == "square":
            row[end] = following[end] = reach
        if legs == "along":
            following[end] = reach
    return rows


def turning_points(route):
    """Begin and end of each row."""
    frame = Frame(*EDGES[route.edge])
    for i, row in enumerate(lengthened(rows_of(frame, route.ends), route.legs)):
        ends = row if i % 2 == 0 else row[::-1]
        yield [frame.place(along, (i + 0.5) * WIDTH_M) for along in ends]


def fixes(route):
    """(x, y, work): a fix every metre or less, the work of a fix being that of the land up to the next one."""
    out, before = [], None
    for begin, end in turning_points(route):
        if before and route.legs != "none":
            out += [(*p, 1) for p in steps(before, begin)]
        out += [(*p, 1) for p in steps(begin, end)]
        if route.legs == "none":
            out.append((*end, 0))
        before = end
    return out + [(*before, 0)] if route.legs != "none" else out


def steps(a, b):
    parts = math.ceil(math.dist(a, b) / STEP_M)
    return [tuple(a[k] + i / parts * (b[k] - a[k]) for k in (0, 1)) for i in range(parts)]


# ---- the irregular route --------------------------------------------------------------------------

POINTS, SPACING_M, BEND = 645, 0.4, 12
# Points of a stretch, and half a turn (positive: to the right), or 0 for a row that wavers.
STRETCHES = [(68, 0), (14, -1), (68, 0), (24, 1), (68, 0), (14, -1), (68, 0), (25, 1), (68, 0), (13, -1),
             (68, 0), (24, 1), (33, 0)]
IRREGULAR_FIELD = [(-1.5, -29), (30, -32), (30.6, 5.2), (14, 6), (-1, 0)]


def irregular_places():
    turns = [turn * math.pi / points if turn else 0.001 * math.cos(2 * math.pi / points * i)
             for points, turn in STRETCHES for i in range(points)] + [0.5 * math.pi / BEND] * BEND
    turns += [0] * (POINTS - 1 - len(turns))
    places, heading = [(0.0, 0.0)], math.pi
    for turn in turns:
        heading += turn
        places.append((places[-1][0] + SPACING_M * math.sin(heading), places[-1][1] + SPACING_M * math.cos(heading)))
    return places


def irregular_fixes():
    """(x, y, heading in degrees): from the fix before to the one after; the first heads for 180°."""
    at = irregular_places()
    out = [(*at[0], 180.0)]
    for i in range(1, len(at)):
        a, b = at[i - 1], at[min(i + 1, len(at) - 1)]
        out.append((*at[i], math.degrees(math.atan2(b[0] - a[0], b[1] - a[1])) % 360))
    return out


def draw(folder):
    for name, ring in (("pentagon", PENTAGON), ("irregular", IRREGULAR_FIELD)):
        write_geojson(folder / f"{name}.geojson", [feature("Polygon", [closed(ring)], id=name)], 3)
    for route in ROUTES:
        lines = [f"{x:.9f},{y:.9f},{work}" for x, y, work in fixes(route)]
        (folder / f"{route.name}.csv").write_text("\n".join(["x,y,work", *lines]) + "\n")
    lines = [f"{x:.6f},{y:.6f},{heading:.6f}" for x, y, heading in irregular_fixes()]
    (folder / "irregular.csv").write_text("\n".join(["x,y,heading", *lines]) + "\n")
