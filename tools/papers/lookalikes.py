"""Fields like those of Versleijen and Zhou, and lines to work them along: files in examples/papers.

The papers do not print their fields. These are drawn: of the printed area and number of obstacles, of a kind like that in
the papers' figures, in plain metres.
"""

import math
import random

from draw_examples import blob, closed, feature, shifted, turned, write_geojson
from plan_shapes import bearing


UNEVEN_M = 0.15  # of tracks digitised from a photograph


def signed_area(ring):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def area(ring):
    return abs(signed_area(ring))


def anticlockwise(ring):
    return ring if signed_area(ring) > 0 else ring[::-1]


def surveyed(corners, step_m, noise_m, seed):
    """The ring through the corners with a vertex about every step, off the straight line by up to the noise: as hedges are."""
    chance, ring = random.Random(seed), []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        length, parts = math.dist(a, b), max(1, round(math.dist(a, b) / step_m))
        normal = (-(b[1] - a[1]) / length, (b[0] - a[0]) / length)
        for i in range(parts):
            share, off = (i + (0.4 * (chance.random() - 0.5) if i else 0)) / parts, noise_m * (chance.random() - 0.5) if i else 0
            ring.append((a[0] + share * (b[0] - a[0]) + off * normal[0], a[1] + share * (b[1] - a[1]) + off * normal[1]))
    return ring


def pylon(x, y, degrees, side_m=7):
    half = side_m / 2
    return shifted(turned([(-half, -half), (-half, half), (half, half), (half, -half)], degrees), (x, y))


def enlarged(outer, holes, area_m2):
    """The outer ring enlarged about the origin so that the field, which keeps its holes, has this area."""
    scale = math.sqrt((area_m2 + sum(map(area, holes))) / area(outer))
    return [[(scale * x, scale * y) for x, y in outer], *holes]


def fields():
    """The rings of each field by its name, the outer one first."""
    bent = surveyed([(0, 0), (170, -22), (330, -18), (520, 24), (560, 110), (420, 202), (300, 228), (255, 292), (120, 268),
                     (30, 148)], 22, 2.0, 1739)
    elbow = surveyed([(0, 0), (280, -20), (290, 70), (120, 90), (150, 300), (60, 322)], 45, 1.6, 5458)
    ragged = surveyed([(0, 0), (140, 38), (270, -60), (352, 0), (330, 66), (226, 92), (196, 150), (254, 282), (150, 300),
                       (94, 150), (-60, 180), (-70, 90)], 14, 1.4, 1087)
    arc = [(420 * math.sin(math.radians(a)), 420 * math.cos(math.radians(a)) - 420) for a in range(-38, 39, 2)]
    inner = [(270 * math.sin(math.radians(a)), 270 * math.cos(math.radians(a)) - 420) for a in range(34, -41, -2)]
    tongue = surveyed([(-470, 260), (-240, 150), (30, 190), (250, 120), (520, 210), (480, -170),
                       (240, -250), (-40, -225), (-430, -300)], 110, 3.0, 10)
    wave = [(x, -170 + 55 * math.sin(x / 150)) for x in range(-290, 291, 20)]
    back = [(x, 215 + 30 * math.sin(x / 190 + 1)) for x in range(290, -291, -20)]
    drawn = {
        "field-1739": enlarged(bent, [pylon(186, 62, 12), pylon(312, 74, 31)], 78970),
        "field-5458": enlarged(elbow, [pylon(60, 48, 24)], 44543),
        "field-1087": enlarged(ragged, [pylon(130, 96, 40)], 50210),
        "oksanen": [[(0, 0), (236, -14), (258, 62), (150, 92), (168, 214), (62, 236), (18, 120)], pylon(120, 66, 15, 12)],
        "liu": [[(0, 0), (330, -40), (420, 130), (330, 290), (60, 260), (-40, 120)], pylon(110, 90, 20, 9),
                pylon(235, 150, 50, 7), blob((300, 60), 6, 6, 12, 0.1, 3)],
        "linne": [arc + inner, blob((-150, -90), 16, 11, 14, 0.3, 5), pylon(40, -78, 18),
                  pylon(414.5 * math.sin(math.radians(17)), 414.5 * math.cos(math.radians(17)) - 420, -17)],
        "zhou-10": enlarged(tongue, [blob((-180, 10), 34, 22, 16, 0.3, 7), pylon(60, 30, 20, 40),
                                     blob((300, 20), 26, 40, 16, 0.3, 8)], 345100),
        "zhou-2": enlarged(wave + back, [blob((-90, 10), 22, 16, 14, 0.2, 9), pylon(120, 40, 10, 24)], 227800),
    }
    return {name: [anticlockwise(rings[0]), *(anticlockwise(hole)[::-1] for hole in rings[1:])] for name, rings in drawn.items()}


# ---- lines ----------------------------------------------------------------------------------------


def crossings(a, b, rings):
    """The shares of the segment at which it crosses an edge of the rings."""
    out = []
    for ring in rings:
        for c, d in zip(ring, ring[1:] + ring[:1]):
            across = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
            if across == 0:
                continue
            along = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / across
            on_edge = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / across
            if 0 < along < 1 and 0 <= on_edge < 1:
                out.append(along)
    return sorted(out)


def contains(rings, p):
    """Is the point in the outer ring and in no other?"""
    inside = False
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
                inside = not inside
    return inside


def clipped(line, rings, shortest_m):
    """The pieces of a polyline within the field."""
    pieces = []
    for a, b in zip(line, line[1:]):
        places = [(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])) for s in [0, *crossings(a, b, rings), 1]]
        for p, q in zip(places, places[1:]):
            if not contains(rings, ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)):
                continue
            if pieces and pieces[-1][-1] == p:
                pieces[-1].append(q)
            else:
                pieces.append([p, q])
    return [piece for piece in pieces if sum(map(math.dist, piece, piece[1:])) >= shortest_m]


def straight_lines(rings, a, b, width_m):
    """Lines along the edge from a to b, the first half a width beside it, over the whole field."""
    degrees = bearing(a, b)
    u = (math.sin(math.radians(degrees)), math.cos(math.radians(degrees)))
    n = (-u[1], u[0])
    depths = [(p[0] - a[0]) * n[0] + (p[1] - a[1]) * n[1] for p in rings[0]]
    first = math.floor(min(depths) / width_m)
    lines = []
    for k in range(first, math.ceil(max(depths) / width_m)):
        at = (a[0] + (k + 0.5) * width_m * n[0], a[1] + (k + 0.5) * width_m * n[1])
        line = [(at[0] - 1000 * u[0], at[1] - 1000 * u[1]), (at[0] + 1000 * u[0], at[1] + 1000 * u[1])]
        lines += clipped(line, rings, 2 * width_m)
    return lines


def reference_lines(rings_of):
    """What others would drive, by the name of the field: in two directions, obliquely, along the curved edge."""
    oksanen, liu, linne = rings_of["oksanen"], rings_of["liu"], rings_of["linne"]
    foot, top = oksanen[0][:4] + [oksanen[0][6]], [oksanen[0][6], *oksanen[0][3:6]]
    arcs, chance = [], random.Random(14)
    for k in range(50):
        radius = 420 - 3 * (k + 0.5) + UNEVEN_M * (2 * chance.random() - 1)
        arc = [(radius * math.sin(math.radians(a)), radius * math.cos(math.radians(a)) - 420) for a in range(-45, 46)]
        arcs += clipped(arc, linne, 6)
    return {"oksanen": straight_lines([foot, *oksanen[1:]], foot[0], foot[1], 2.5) + straight_lines([top], top[2], top[1], 2.5),
            "liu": straight_lines(liu, (-40, 120), (420, 180), 10), "linne": arcs}


def guides(rings_of):
    """Zhou's lines along two sides of the second field."""
    ring = rings_of["zhou-2"][0]
    half = len(ring) // 2
    return {"d1": ring[:half], "d2": ring[half:]}


def draw(folder):
    """Writes all files; the same bytes each time."""
    rings_of = fields()
    for name, rings in rings_of.items():
        write_geojson(folder / f"{name}.geojson", [feature("Polygon", [closed(ring) for ring in rings], id=name)], 3)
    for name, lines in reference_lines(rings_of).items():
        write_geojson(folder / f"{name}-lines.geojson",
                      [feature("LineString", line, order=i) for i, line in enumerate(lines, 1)], 3)
    write_geojson(folder / "zhou-2-guides.geojson",
                  [feature("LineString", line, name=name) for name, line in guides(rings_of).items()], 3)
