#!/usr/bin/env python3
"""Redraws the fields in examples/.

They are invented, in metres about a corner of their own, and put where such a field could lie. What is
untidy in them is meant: real boundaries have doubled vertices, near-straight edges of many vertices, rings
that touch themselves and twelve digits.

    tools/draw_examples.py [FOLDER]        (default: examples/; needs ogr2ogr for the GeoPackages)
"""

import csv
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

EQUATOR_M, ECCENTRICITY2 = 6378137.0, 0.00669437999014  # WGS 84


def on_the_globe(points, lon, lat):
    """Metres east and north of a place to longitude and latitude; good to centimetres over a field."""
    sine = math.sin(math.radians(lat))
    bend = 1 - ECCENTRICITY2 * sine * sine
    meridian = EQUATOR_M * (1 - ECCENTRICITY2) / bend**1.5
    parallel = EQUATOR_M / math.sqrt(bend) * math.cos(math.radians(lat))
    return [(lon + math.degrees(x / parallel), lat + math.degrees(y / meridian)) for x, y in points]


def closed(ring):
    return ring + ring[:1]


def turned(points, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(c * x - s * y, s * x + c * y) for x, y in points]


def shifted(points, by):
    return [(x + by[0], y + by[1]) for x, y in points]


def blob(centre, radius_x, radius_y, vertices, unevenness, seed):
    """A clockwise ring of an uneven ellipse, as a pond or a copse is digitised."""
    chance = random.Random(seed)
    ring = []
    for i in range(vertices):
        angle = -2 * math.pi * (i + 0.3 * chance.random()) / vertices
        reach = 1 + unevenness * (chance.random() - 0.5) + 0.12 * math.sin(3 * angle)
        ring.append((centre[0] + radius_x * reach * math.cos(angle), centre[1] + radius_y * reach * math.sin(angle)))
    return ring


def band(line, width):
    """A ring round a line, half the width to either side: a ditch, a waterway."""
    left, right = [], []
    for i, (x, y) in enumerate(line):
        (x0, y0), (x1, y1) = line[max(i - 1, 0)], line[min(i + 1, len(line) - 1)]
        size = math.hypot(x1 - x0, y1 - y0)
        nx, ny = -(y1 - y0) / size * width / 2, (x1 - x0) / size * width / 2
        left.append((x + nx, y + ny))
        right.append((x - nx, y - ny))
    return left + right[::-1]


def feature(geometry_type, coordinates, **properties):
    return {"type": "Feature", "properties": properties,
            "geometry": {"type": geometry_type, "coordinates": coordinates}}


def write_geojson(path, features, digits=12, **members):
    """One feature a line; as many digits as a careless export writes."""
    def number(text):
        return format(float(text), f".{digits}f")
    lines = [json.dumps(json.loads(json.dumps(f), parse_float=lambda t: f"@{number(t)}@"),
                        ensure_ascii=False).replace('"@', "").replace('@"', "") for f in features]
    head = "".join(f"{json.dumps(k)}: {json.dumps(v)},\n" for k, v in {"type": "FeatureCollection", **members}.items())
    path.write_text("{\n" + head + '"features": [\n' + ",\n".join(lines) + "\n]\n}\n", encoding="utf-8")


# ---- riverside ------------------------------------------------------------------------------------

RIVERSIDE = (9.1478, 52.6925)


def river_bank():
    """The north side, east to west, in 60 uneven steps."""
    chance = random.Random(60)
    bank = []
    for i in range(61):
        t = (i + (0.35 * (chance.random() - 0.5) if 0 < i < 60 else 0)) / 60
        y = 322 - 52 * t + 19 * math.sin(8.4 * t + 0.35) - 7 * math.sin(19 * t) + 0.8 * (chance.random() - 0.5)
        bank.append((417 - 409 * t + 6 * math.sin(11 * t), y))
    return bank


def riverside_outline():
    road = [(0.0, 0.0), (64.2, -1.1), (131.7, -3.9), (131.7, -3.9), (197.0, -7.6), (258.4, -11.2), (391.3, -22.4)]
    # Vertices a few centimetres off the straight line, as a tracked drive along a fence leaves them.
    fence = [(394.1, 7.1), (396.92, 36.6), (399.7, 66.05), (402.5, 95.4), (398.6, 171.3)]
    farmyard = [(353.2, 175.8), (344.9, 183.1), (349.4, 231.0), (408.3, 236.6)]
    hedge = [(-5.8, 180.4), (-11.3, 131.2), (-14.2, 92.0), (-8.9, 41.7)]
    return road + fence + farmyard + river_bank() + hedge


def riverside_holes():
    pylons = []
    for i, size in enumerate([2.4, 3.8, 2.2, 3.1, 2.6]):
        half = size / 2
        corners = [(-half, -half), (-half, half), (half, half), (half, -half)]
        pylons.append(shifted(turned(corners, 14.3), (58.0 + 78.4 * i, 57.5 + 20.0 * i)))
    pond = blob((262.0, 212.0), 21.0, 15.0, 30, 0.16, 7)
    # The west end stops little more than two metres short of the hedge.
    ditch = band([(-6.7, 147.6), (14.2, 144.1), (39.5, 143.0), (71.8, 136.6), (98.3, 134.9), (121.0, 127.4)], 4.0)
    return pylons + [pond, ditch]


def riverside(folder):
    rings = [riverside_outline()] + riverside_holes()
    coordinates = [closed(on_the_globe(ring, *RIVERSIDE)) for ring in rings]
    write_geojson(folder / "riverside.geojson",
                  [feature("Polygon", coordinates, id="riverside", name="Riverside", crop="winter wheat")])

    trees = [(318.5, 64.0), (321.9, 65.6), (91.0, 214.0), (366.2, 271.5), (31.0, 99.0)]
    features = [feature("Point", on_the_globe([tree], *RIVERSIDE)[0], kind="tree", crown_m=crown)
                for tree, crown in zip(trees, [4.0, 3.5, 6.0, 5.0, 3.0])]
    drain = [(402.5, 128.0), (371.0, 131.4), (341.5, 129.9)]
    features.append(feature("LineString", on_the_globe(drain, *RIVERSIDE), kind="drain"))
    write_geojson(folder / "riverside-obstacles.geojson", features)

    # Drawn past the field at both ends, so that it is sure to reach the edge.
    bed = [(181.0, -14.0), (183.5, 30.0), (178.2, 77.0), (180.9, 131.0), (192.4, 186.0), (190.1, 240.0),
           (198.0, 312.0)]
    write_geojson(folder / "riverside-waterway.geojson",
                  [feature("Polygon", [closed(on_the_globe(band(bed, 7.5), *RIVERSIDE))], kind="grassed waterway")])


# ---- two farms ------------------------------------------------------------------------------------

def two_farms(folder):
    corner = (511240.0, 5837410.0)  # UTM zone 32

    def ring(points):
        return closed(shifted(points, corner))

    oak = [(0, 0), (212.4, 14.1), (236.0, 71.3), (229.7, 188.2), (118.3, 201.5), (-11.6, 179.9)]
    lane_west = [(262.1, 12.7), (401.5, 22.9), (392.0, 206.4), (254.8, 189.3)]
    lane_east = [(407.6, 23.3), (519.2, 31.0), (530.4, 118.8), (488.7, 211.9), (398.1, 207.0)]
    # One ring round field and copse: it comes back to the vertex where the copse meets the edge.
    pinch = (96.4, -251.7)
    copse = [pinch, (88.1, -214.5), (112.9, -191.8), (137.0, -216.3), (121.8, -243.1)]
    mill = [(-4.2, -18.0), (-19.7, -239.6)] + copse + [pinch, (205.3, -264.2), (219.8, -2.9)]
    strip = [(228.9, -4.1), (213.5, -262.8), (571.0, -301.4), (560.3, -188.0), (399.4, -151.6), (386.2, 10.7)]
    barrow = blob((322.0, -160.0), 17.0, 14.0, 14, 0.1, 3)
    parcels = [feature("Polygon", [ring(oak)], id="oak-field", crop="maize"),
               feature("MultiPolygon", [[ring(lane_west)], [ring(lane_east)]], id="both-sides-of-the-lane",
                       crop="rape"),
               feature("Polygon", [ring(mill)], id="mill-field", crop="winter barley"),
               feature("Polygon", [ring(strip), ring(barrow)], id="barrow-field", crop="sugar beet")]
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch) / "parcels.geojson"
        write_geojson(source, parcels, digits=3,
                      crs={"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}})
        to_geopackage(source, folder / "two-farms.gpkg", "parcels", ["-nlt", "PROMOTE_TO_MULTI"])


# ---- terrace --------------------------------------------------------------------------------------

def terrace(folder):
    """A band along a hillside: both long sides follow the contours, which are not parallel."""
    def contour(step, radius, wave):
        angle = math.radians(205 - 1.55 * step)
        reach = radius + wave * math.sin(0.21 * step) + 3 * math.sin(0.47 * step)
        return (reach * math.cos(angle), reach * math.sin(angle))

    lower = [contour(step, 301.0, 9.0) for step in range(0, 66)]
    upper = [contour(step, 232.0, 14.0) for step in range(64, 1, -1)]
    ring = closed(on_the_globe(lower[::-1] + upper[::-1], 7.6702, 48.0871))
    text = " ".join(f"{lon:.12f},{lat:.12f},0" for lon, lat in ring)
    (folder / "terrace.kml").write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2">
<Document>
<name>terrace</name>
<Placemark>
<name>terrace</name>
<ExtendedData><Data name="crop"><value>spelt</value></Data></ExtendedData>
<Polygon><outerBoundaryIs><LinearRing><coordinates>
{text}
</coordinates></LinearRing></outerBoundaryIs></Polygon>
</Placemark>
</Document>
</kml>
""", encoding="utf-8")


# ---- plain metres ---------------------------------------------------------------------------------

# What GeoPackage calls srs_id -1; without a word ogr2ogr writes 0, which is degrees.
NO_CRS = ('ENGCRS["Undefined Cartesian SRS",EDATUM["unknown"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],'
          'LENGTHUNIT["metre",1]]')


def plain_metres(folder):
    outline = [(0, 0), (240, 0), (240, 95), (110, 95), (110, 210), (0, 210)]
    # From each tree it is less than 3 m to the next: no machine drives between them.
    trees = [blob(centre, radius, radius, 8, 0.0, 11)
             for centre, radius in [((62.0, 50.0), 2.0), ((68.2, 51.5), 1.8), ((65.6, 57.2), 2.2), ((72.4, 56.6), 2.0)]]
    rings = ", ".join("(" + ", ".join(f"{x:.3f} {y:.3f}" for x, y in closed(ring)) + ")" for ring in [outline] + trees)
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch) / "field.csv"
        with source.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([["id", "WKT"], ["plain-metres", f"POLYGON ({rings})"]])
        to_geopackage(source, folder / "plain-metres.gpkg", "field",
                      ["-oo", "GEOM_POSSIBLE_NAMES=WKT", "-oo", "KEEP_GEOM_COLUMNS=NO", "-nlt", "POLYGON",
                       "-a_srs", NO_CRS])


# ---- ways round -----------------------------------------------------------------------------------

def ways_round(folder):
    """Two fields to look at detours on: one with a mast, one with a copse."""
    place = (9.2017, 52.6881)
    outline = [(0, 0), (132.4, -4.1), (134.8, 73.4), (2.4, 77.5)]
    # 7 m across, as wide as more than two rows of 3 m.
    angles = [-2 * math.pi * i / 24 for i in range(24)]
    mast = [(68.3 + 3.5 * math.cos(angle), 36.4 + 3.5 * math.sin(angle)) for angle in angles]
    east = (160.0, 0.0)
    copse_outline = shifted([(0, 0), (168.2, -5.3), (177.5, 117.0), (8.8, 126.1)], east)
    copse = shifted(blob((84.0, 58.0), 17.0, 11.0, 18, 0.14, 5), east)
    features = [feature("Polygon", [closed(on_the_globe(ring, *place)) for ring in rings], id=name)
                for name, rings in (("mast", [outline, mast]), ("copse", [copse_outline, copse]))]
    write_geojson(folder / "ways-round.geojson", features)


# ---- roadside -------------------------------------------------------------------------------------

def roadside(folder):
    """A long field with one edge far longer than the others, to compare driving along and across it."""
    place = (9.3114, 52.7302)
    road = [(0.0, 0.0), (371.6, 0.0)]
    lane = [(376.1, 41.2), (381.9, 87.6), (388.2, 136.3)]
    # The hedge steps in and out; nothing of it runs parallel to the road. Its last part is a tongue.
    hedge = [(331.0, 147.9), (268.4, 158.2), (259.8, 139.6), (196.3, 148.8), (128.7, 163.1), (36.4, 166.4),
             (91.7, 244.1), (56.0, 262.9)]
    brook = [(-13.1, 158.7), (-10.6, 118.3), (-4.0, 52.5)]
    outline = turned(road + lane + hedge + brook, -21.0)
    copse = turned(blob((131.0, 88.0), 17.0, 12.5, 11, 0.14, 9), -21.0)
    # 2.4 m across: narrower than the machine, so that Versleijen drives round it.
    angles = [-2 * math.pi * i / 12 for i in range(12)]
    mast = turned([(287.5 + 1.2 * math.cos(angle), 61.0 + 1.2 * math.sin(angle)) for angle in angles], -21.0)
    coordinates = [closed(on_the_globe(ring, *place)) for ring in (outline, copse, mast)]
    write_geojson(folder / "roadside.geojson", [feature("Polygon", coordinates, id="roadside", crop="potatoes")])


def to_geopackage(source, target, layer, options):
    target.unlink(missing_ok=True)
    # A fixed date, so that redrawing gives the same file.
    subprocess.run(["ogr2ogr", "--config", "OGR_CURRENT_DATE", "2024-03-01T00:00:00.000Z", "-f", "GPKG",
                    str(target), str(source), "-nln", layer, *options], check=True)


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "examples"
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (riverside, two_farms, terrace, plain_metres, ways_round, roadside):
        draw(folder)


if __name__ == "__main__":
    main()
