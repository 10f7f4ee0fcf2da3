#!/usr/bin/env python3
"""Routes of tractors with gates, reverse legs and obstacles, through every format, read by programs that are not ours.

The reference is the layer `route` as GeoJSON with every point: legs with kind, gear and work. What another program read has to
be that line, leg after leg, and to say of each leg how it is driven. Without --real there is one field; with it, odd real fields as
well.
"""

import argparse
import csv
import json
import math
import os
import pathlib
import sys
import tempfile
import unittest

import jsonschema
import yaml

from same_line import EARTH_M, Plane, farthest, run

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
TOLERANCE_M = 0.02  # of an export
RESOLUTION_M = 1e-3  # of the formats
OPTIONS = argparse.Namespace()
SPEEDS = {"work": 2.5, "off": 1.5, "reverse": 1.0}  # m/s, the defaults of `tramline plan`

# Pylons in a line; a wetland beside a pole line; an L with a ditch; a folded strip; seven holes and an invalid ring.
REAL_FIELDS = ["cz/45", "de-bb/13", "sk/83", "cz/12", "sk/32"]


class Scene:
    """A plan with a route, and its legs as the reference."""

    def __init__(self, folder, name, field, *options):
        self.folder, self.name = folder, name
        self.plan = str(folder / "plan.gpkg")
        run(OPTIONS.tramline, "plan", str(field), *options, "--quiet", "-o", self.plan)
        self.legs = json.loads(self.exported("legs.geojson", "--layer", "route", "--tolerance", "0").read_text())["features"]
        self.lonlats = []
        for leg in self.legs:
            for lonlat in leg["geometry"]["coordinates"]:
                if not self.lonlats or lonlat != self.lonlats[-1]:
                    self.lonlats.append(lonlat)
        self.plane = Plane(*self.lonlats[0])
        self.line = [self.plane(p) for p in self.lonlats]

    def exported(self, name, *options):
        run(OPTIONS.tramline, "export", self.plan, "-o", str(self.folder / name), "--quiet", *options)
        return self.folder / name

    def layer(self, name):
        try:
            return json.loads(self.exported("layer.geojson", "--layer", name, "--tolerance", "0").read_text())["features"]
        except Exception as error:  # an empty layer is refused
            if "there is nothing in layer" not in getattr(error, "stderr", ""):
                raise
            return []

    def lengths(self, **wanted):
        return sum(leg["properties"]["length_m"] for leg in self.legs if all(leg["properties"][k] == v for k, v in wanted.items()))

    def speed_of(self, leg):
        return SPEEDS["work" if leg["work"] else "reverse" if leg["gear"] == "reverse" else "off"]


class RealRoutes(unittest.TestCase):
    def scenes(self):
        """Each with its own folder, one after the other."""
        with tempfile.TemporaryDirectory() as folder:
            yield Scene(pathlib.Path(folder), "riverside", EXAMPLES / "riverside.geojson", "--width", "24", "--radius", "6", "--reverse",
                        "--headlands", "1", "--prices", "0.02,0.10,1,5,5", "--order", "adjacent", "--route",
                        "--start", "9.1476,52.6925", "--end", "9.1540,52.6960", "--lift", "1", "--lower", "2")
        if not OPTIONS.data:
            return
        with tempfile.TemporaryDirectory() as folder:
            yield Scene(pathlib.Path(folder), "riverside with pylons", EXAMPLES / "riverside.geojson", "--width", "12", "--radius", "6",
                        "--reverse", "--headlands", "2", "--obstacles", str(EXAMPLES / "riverside-obstacles.geojson"))
        fields = pathlib.Path(OPTIONS.data) / "fields" / "fields.geojson"
        by_id = {f["properties"]["id"]: f["geometry"]["coordinates"][0] for f in json.loads(fields.read_text())["features"]}
        for name in REAL_FIELDS:
            corners = by_id[name]
            gates = ("--start", ",".join(map(str, corners[0])), "--end", ",".join(map(str, corners[len(corners) // 3])))
            with tempfile.TemporaryDirectory() as folder:
                yield Scene(pathlib.Path(folder), name, fields, "--id", name, "--width", "12", "--radius", "6", "--reverse", *gates)

    def test_every_format_on_every_scene(self):
        kinds = set()
        for scene in self.scenes():
            for check in (self.gpx, self.kml, self.qgc, self.waypoints, self.robot):
                with self.subTest(scene=scene.name, format=check.__name__):
                    check(scene)
            kinds |= {(leg["properties"]["kind"], leg["properties"]["gear"]) for leg in scene.legs}
        # What the scenes are for.
        self.assertTrue(any(gear == "reverse" for _, gear in kinds))
        self.assertTrue({"work", "headland", "transit"} <= {kind for kind, _ in kinds}, kinds)

    def same_line(self, scene, lonlats, tolerance_m=TOLERANCE_M):
        points = [scene.plane(p) for p in lonlats]
        self.assertLess(math.dist(points[0], scene.line[0]), RESOLUTION_M)
        self.assertLess(math.dist(points[-1], scene.line[-1]), RESOLUTION_M)
        # A straight way in the field's plane is none in degrees, in which the points between are left out.
        longest = max(math.dist(a, b) for a, b in zip(points, points[1:]))
        bend = longest**2 / 8 * math.tan(math.radians(abs(lonlats[0][1]))) / EARTH_M
        most = tolerance_m + RESOLUTION_M + bend
        self.assertLess(farthest(points, scene.line, most), most)
        self.assertLess(farthest(scene.line, points, most), most)
        # Nothing is left out, and nothing is driven twice: chords are shorter than their arcs by little.
        length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
        self.assertAlmostEqual(length / scene.lengths(), 1, delta=0.004)

    def gpx(self, scene):
        gpx, table, out = scene.exported("route.gpx"), scene.folder / "route.csv", scene.folder / "ogr.geojson"
        run("gpsbabel", "-t", "-i", "gpx", "-f", str(gpx), "-o", "unicsv,prec=9", "-F", str(table))
        with table.open() as file:
            self.same_line(scene, [(float(row["Longitude"]), float(row["Latitude"])) for row in csv.DictReader(file)])
        run("ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=10", str(out), str(gpx), "tracks")
        (track,) = json.loads(out.read_text())["features"]
        self.same_line(scene, track["geometry"]["coordinates"][0])

    def kml(self, scene):
        kml, out = scene.exported("route.kml", "--layer", "route", "--tolerance", "0"), scene.folder / "kml.geojson"
        run("ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=10", str(out), str(kml), "route")
        legs = json.loads(out.read_text())["features"]
        self.assertEqual(len(legs), len(scene.legs))
        for read, leg in zip(legs, scene.legs):
            self.assertEqual(read["properties"]["kind"], leg["properties"]["kind"])
            self.assertEqual(read["properties"]["gear"], leg["properties"]["gear"])
            self.assertEqual(len(read["geometry"]["coordinates"]), len(leg["geometry"]["coordinates"]))
            for p, q in zip(read["geometry"]["coordinates"], leg["geometry"]["coordinates"]):
                self.assertLess(math.dist(scene.plane(p), scene.plane(q)), RESOLUTION_M)

    def driven_by_items(self, scene, items):
        """What an autopilot does that follows the items: the points, and metres by gear, by work and by speed."""
        places, metres = [], {}
        gear, work, speed = "forward", False, None
        for command, params in items:
            if command == 194:
                gear = "reverse" if params[0] else "forward"
            elif command == 216:
                work = params[0] == 1
            elif command == 178:
                self.assertEqual(params[0], 1, "speed over ground")
                speed = params[1]
            else:
                self.assertEqual(command, 16)
                places.append((params[5], params[4]))
                if len(places) > 1:
                    key = (gear, work, speed)
                    metres[key] = metres.get(key, 0) + math.dist(scene.plane(places[-2]), scene.plane(places[-1]))
        return places, metres

    def check_items(self, scene, items):
        places, metres = self.driven_by_items(scene, items)
        self.same_line(scene, places)
        wanted = {}
        for leg in scene.legs:
            p = leg["properties"]
            key = (p["gear"], p["work"], scene.speed_of(p))
            wanted[key] = wanted.get(key, 0) + p["length_m"]
        self.assertEqual(set(metres), {key for key, length in wanted.items() if length > 1e-3})
        for key, length in metres.items():
            self.assertAlmostEqual(length / wanted[key], 1, delta=0.01, msg=str(key))

    def qgc(self, scene):
        plan = json.loads(scene.exported("mission.plan").read_text())
        jsonschema.validate(plan, json.loads((HERE / "qgc_plan.schema.json").read_text()))
        self.check_items(scene, [(item["command"], item["params"]) for item in plan["mission"]["items"]])
        self.fence(scene, plan["geoFence"]["polygons"])

    def fence(self, scene, polygons):
        """Fences are the field's boundary and obstacles, but for those that the notes say are left out."""
        report = json.loads(run(OPTIONS.tramline, "export", scene.plan, "-o", str(scene.folder / "again.plan"), "--json"))
        left_out = len(report["notes"])
        solid = [f for f in scene.layer("obstacles") if f["properties"].get("kind", "obstacle") != "passable"]
        self.assertEqual(len(polygons), 1 + len(solid) - left_out)
        rings = [f["geometry"]["coordinates"][0][:-1] for f in scene.layer("field")] + [f["geometry"]["coordinates"][0][:-1] for f in solid]
        corners = {(round(lat, 8), round(lon, 8)) for ring in rings for lon, lat in ring}
        for polygon in polygons:
            for lat, lon in polygon["polygon"]:
                near = [(round(lat, 8) + i * 1e-8, round(lon, 8) + j * 1e-8) for i in (-1, 0, 1) for j in (-1, 0, 1)]
                self.assertTrue(any((round(a, 8), round(b, 8)) in corners for a, b in near), "a corner of a fence is none of the field")

    def waypoints(self, scene):
        rows = [row.split("\t") for row in scene.exported("mission.waypoints").read_text().splitlines()[2:]]
        self.check_items(scene, [(int(row[3]), [float(value) for value in row[4:11]]) for row in rows])

    def robot(self, scene):
        route = yaml.safe_load(scene.exported("route.yaml").read_text())
        segments = route["segments"]
        # The segments of each leg in turn: as long, and driven alike.
        at = 0
        for leg in scene.legs:
            p = leg["properties"]
            length = 0
            while at < len(segments) and length < p["length_m"] - 1e-6:
                s = segments[at]
                self.assertEqual((s["leg"], s["gear"], s["work"], s["speed_mps"]), (p["kind"], p["gear"], p["work"], scene.speed_of(p)))
                length += s["length_m"]
                at += 1
            self.assertAlmostEqual(length, p["length_m"], 5)
        self.assertEqual(at, len(segments))
        # The poses are those of the line, in a plane about the datum that is a projection of true lengths.
        poses = [pose["pose"] for pose in route["path"]["poses"]]
        datum = Plane(route["datum"]["longitude_deg"], route["datum"]["latitude_deg"])
        first = datum(scene.lonlats[0])
        self.assertLess(math.dist(first, (poses[0]["position"]["x"], poses[0]["position"]["y"])), 0.005 * math.hypot(*first) + 0.01)
        # Forward the machine moves where it points, in reverse against that.
        for a, b in zip(poses, poses[1:]):
            dx, dy = (b["position"][k] - a["position"][k] for k in "xy")
            if math.hypot(dx, dy) < 0.05:
                continue
            yaw = 2 * math.atan2(a["orientation"]["z"], a["orientation"]["w"])
            along = math.cos(math.atan2(dy, dx) - yaw)
            self.assertGreater(abs(along), 0.85)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--real", action="store_true", help="odd real fields too, where $TRAMLINE_DATA is found")
    parser.parse_args(namespace=OPTIONS)
    OPTIONS.data = os.environ.get("TRAMLINE_DATA", "") if OPTIONS.real else ""
    if OPTIONS.real and not OPTIONS.data:
        print("skipped: TRAMLINE_DATA is not set")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
