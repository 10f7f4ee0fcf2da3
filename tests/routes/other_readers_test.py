#!/usr/bin/env python3
"""One route through every format, read by programs that are not ours: each returns the same line.

The reference is the layer `route` as GeoJSON, with ten decimals. gpsbabel and OGR read GPX and KML, PyYAML the YAML, a
schema written from the public description QGroundControl's plan, and a few lines of Python the other missions.
"""

import argparse
import csv
import json
import math
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
import zipfile

import jsonschema
import yaml

from same_line import Plane, farthest, run

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
TOLERANCE_M = 0.02  # of an export; twice where two of them are compared
TRAMLINE = ""

DRONE = """name = "drone"
width_m = 12.0
turning_radius_m = 2.0
operation = "drone"
working_speed_mps = 5.0
turning_speed_mps = 2.5
flight_altitude_m = 3.5
takeoff_altitude_m = 6.0
landing = "end"
"""


class OtherReaders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "drone.toml").write_text(DRONE)
        cls.plan = str(cls.folder / "plan.gpkg")
        run(TRAMLINE, "plan", str(EXAMPLES / "riverside.geojson"), "--machine", str(cls.folder / "drone.toml"),
            "--prices", "0.02,0.10,1,5,5", "--route", "--headlands", "1", "--quiet", "-o", cls.plan)
        legs = json.loads(cls.exported("route.geojson", "--layer", "route").read_text())["features"]
        cls.reference = []
        for leg in legs:
            for lonlat in leg["geometry"]["coordinates"]:
                if not cls.reference or lonlat != cls.reference[-1]:
                    cls.reference.append(lonlat)
        cls.plane = Plane(*cls.reference[0])
        cls.line = [cls.plane(p) for p in cls.reference]
        cls.works = [leg["properties"]["work"] for leg in legs]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def exported(cls, name, *options):
        run(TRAMLINE, "export", cls.plan, "-o", str(cls.folder / name), "--quiet", *options)
        return cls.folder / name

    def rows_of(self, table):
        with table.open() as file:
            return list(csv.DictReader(file))

    def assert_same_line(self, lonlats, resolution_m):
        points = [self.plane(p) for p in lonlats]
        self.assertGreater(len(points), 100)
        self.assertLess(math.dist(points[0], self.line[0]), resolution_m + 1e-3)
        self.assertLess(math.dist(points[-1], self.line[-1]), resolution_m + 1e-3)
        most = 2 * TOLERANCE_M + resolution_m
        self.assertLess(farthest(points, self.line, most), most)
        self.assertLess(farthest(self.line, points, most), most)

    def test_gpx_by_gpsbabel(self):
        gpx = self.exported("route.gpx")
        table = self.folder / "route.csv"
        run("gpsbabel", "-t", "-i", "gpx", "-f", str(gpx), "-o", "unicsv,prec=9", "-F", str(table))
        rows = self.rows_of(table)
        self.assert_same_line([(float(row["Longitude"]), float(row["Latitude"])) for row in rows], 1e-3)

    def test_gpx_by_ogr(self):
        gpx = self.exported("route.gpx")
        out = self.folder / "ogr.geojson"
        run("ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=10", str(out), str(gpx), "tracks")
        (track,) = json.loads(out.read_text())["features"]
        self.assertEqual(track["properties"]["name"], "riverside")
        (line,) = track["geometry"]["coordinates"]
        self.assert_same_line(line, 1e-3)

    def test_kml_by_ogr_and_with_single_blanks(self):
        kml = self.exported("route.kml", "--layer", "route")
        out = self.folder / "kml.geojson"
        run("ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=10", str(out), str(kml), "route")
        points = []
        for leg in json.loads(out.read_text())["features"]:
            for lonlat in leg["geometry"]["coordinates"]:
                if not points or lonlat[:2] != points[-1]:
                    points.append(lonlat[:2])
        self.assert_same_line(points, 1e-3)
        for element in xml.parse(kml).iter("{http://www.opengis.net/kml/2.2}coordinates"):
            self.assertNotIn("  ", element.text.strip())
            self.assertNotIn("\n", element.text.strip())

    def test_gaps_by_gpsbabel(self):
        coverage = self.folder / "coverage.gpkg"
        run(TRAMLINE, "evaluate", str(EXAMPLES / "riverside-drive.csv"), "--field", str(EXAMPLES / "riverside.geojson"),
            "--quiet", "-o", str(coverage))
        run(TRAMLINE, "export", str(coverage), "-o", str(self.folder / "gaps.gpx"), "--quiet")
        run(TRAMLINE, "export", str(coverage), "-o", str(self.folder / "gaps.geojson"), "--quiet")
        gaps = json.loads((self.folder / "gaps.geojson").read_text())["features"]
        table = self.folder / "gaps.csv"
        run("gpsbabel", "-w", "-i", "gpx", "-f", str(self.folder / "gaps.gpx"), "-o", "unicsv,prec=9", "-F", str(table))
        rows = self.rows_of(table)
        self.assertGreater(len(gaps), 10)
        self.assertEqual(sorted(row["Name"] for row in rows), sorted(f"Gap {i + 1}" for i in range(len(gaps))))
        by_name = {row["Name"]: row for row in rows}
        for gap in gaps:
            row = by_name[f"Gap {gap['properties']['number']}"]
            corners = gap["geometry"]["coordinates"][0]
            for i, key in enumerate(("Longitude", "Latitude")):
                self.assertLessEqual(min(corner[i] for corner in corners) - 1e-8, float(row[key]))
                self.assertGreaterEqual(max(corner[i] for corner in corners) + 1e-8, float(row[key]))

    def test_kml_by_gpsbabel(self):
        kml = self.exported("route.kml", "--layer", "route")
        table = self.folder / "kml.csv"
        run("gpsbabel", "-t", "-i", "kml", "-f", str(kml), "-o", "unicsv,prec=9", "-F", str(table))
        self.assertGreater(len(self.rows_of(table)), 100)

    def test_qgroundcontrol_plan_by_its_schema(self):
        plan = json.loads(self.exported("mission.plan", "--machine", str(self.folder / "drone.toml")).read_text())
        jsonschema.validate(plan, json.loads((HERE / "qgc_plan.schema.json").read_text()))
        items = plan["mission"]["items"]
        self.assertEqual([item["doJumpId"] for item in items], list(range(1, len(items) + 1)))
        self.assertEqual(items[0]["command"], 22)
        self.assertEqual(items[-1]["command"], 21, "it lands where the route ends")
        self.assert_same_line([(i["params"][5], i["params"][4]) for i in items if i["command"] == 16], 1e-3)
        self.assertEqual({i["params"][6] for i in items if i["command"] == 16}, {3.5})
        # The sprayer goes on and off as often as the work begins and ends.
        switched = [item["params"][0] for item in items if item["command"] == 216]
        runs = sum(1 for i, work in enumerate(self.works) if work and (i == 0 or not self.works[i - 1]))
        self.assertEqual(switched, [1, 0] * runs)
        first = next(i for i, item in enumerate(items) if item["command"] == 16)
        self.assertNotIn(216, [item["command"] for item in items[:first]], "nothing is sprayed before the route begins")

    def test_on_the_ground_nothing_takes_off(self):
        plan = json.loads(self.exported("rover.plan").read_text())
        jsonschema.validate(plan, json.loads((HERE / "qgc_plan.schema.json").read_text()))
        self.assertEqual(plan["mission"]["vehicleType"], 10)
        self.assertFalse({20, 21, 22} & {item["command"] for item in plan["mission"]["items"]})

    def test_waypoints_are_the_items_of_the_plan(self):
        drone = ("--machine", str(self.folder / "drone.toml"))
        items = json.loads(self.exported("mission.plan", *drone).read_text())["mission"]["items"]
        lines = self.exported("mission.waypoints", *drone).read_text().splitlines()
        self.assertEqual(lines[0], "QGC WPL 110")
        rows = [line.split("\t") for line in lines[1:]]
        self.assertTrue(all(len(row) == 12 for row in rows))
        self.assertEqual([int(row[0]) for row in rows], list(range(len(items) + 1)))
        self.assertEqual([row[1] for row in rows], ["1"] + ["0"] * len(items))
        for row, item in zip(rows[1:], items):
            self.assertEqual(int(row[3]), item["command"])
            for text, value in zip(row[4:11], item["params"]):
                self.assertAlmostEqual(float(text), value or 0, 6)

    def test_dji_mission(self):
        kmz = self.exported("mission.kmz", "--machine", str(self.folder / "drone.toml"))
        with zipfile.ZipFile(kmz) as files:
            self.assertEqual(files.namelist(), ["wpmz/template.kml", "wpmz/waylines.wpml"])
            roots = [xml.fromstring(files.read(name)) for name in files.namelist()]
        kml, wpml = "{http://www.opengis.net/kml/2.2}", "{http://www.dji.com/wpmz/1.0.2}"
        for root in roots:
            places = [p.text for p in root.iter(kml + "coordinates")]
            self.assert_same_line([tuple(map(float, place.split(","))) for place in places], 1e-3)
            self.assertEqual([int(i.text) for i in root.iter(wpml + "index")], list(range(len(places))))
            self.assertEqual([e.text for e in root.iter(wpml + "finishAction")], ["autoLand"])
        self.assertEqual({e.text for e in roots[1].iter(wpml + "executeHeight")}, {"3.50"})
        speeds = {e.text for e in roots[1].iter(wpml + "waypointSpeed")}
        self.assertEqual(speeds | {"1.00"}, {"5.00", "2.50", "1.00"}, "at work, with the work off and, where it backs out, in reverse")

    def test_yaml_by_pyyaml(self):
        route = yaml.safe_load(self.exported("route.yaml").read_text())
        self.assertEqual(route, json.loads(self.exported("route.json").read_text()))
        poses = [pose["pose"] for pose in route["path"]["poses"]]
        points = [(p["position"]["x"], p["position"]["y"]) for p in poses]
        length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
        self.assertAlmostEqual(length, sum(math.dist(a, b) for a, b in zip(self.line, self.line[1:])), delta=0.005 * length)
        self.check_segments(route["segments"], points)
        for pose in poses:
            q = pose["orientation"]
            self.assertAlmostEqual(math.hypot(q["z"], q["w"]), 1)

    def check_segments(self, segments, points):
        """Each begins where the one before it ended, and its end follows from its start, length and curvature."""
        self.assertAlmostEqual(segments[0]["start"]["x"], points[0][0])
        self.assertAlmostEqual(segments[-1]["end"]["y"], points[-1][1], 2)
        for before, after in zip(segments, segments[1:]):
            for key in ("x", "y"):
                self.assertAlmostEqual(before["end"][key], after["start"][key], 6)
        self.assertEqual({s["type"] for s in segments} - {"line", "arc", "clothoid"}, set())
        for s in segments:
            x, y, yaw = s["start"]["x"], s["start"]["y"], s["start"]["yaw"]
            steps, way = 100, s["length_m"] * (1 if s["gear"] == "forward" else -1)
            for i in range(steps):  # midpoint rule
                share = (i + 0.5) / steps
                curvature = s["curvature_at_start"] + share * (s["curvature_at_end"] - s["curvature_at_start"])
                half = 0.5 * curvature * way / steps
                x, y, yaw = x + way / steps * math.cos(yaw + half), y + way / steps * math.sin(yaw + half), yaw + 2 * half
            self.assertAlmostEqual(x, s["end"]["x"], 3)
            self.assertAlmostEqual(y, s["end"]["y"], 3)
            self.assertAlmostEqual(math.remainder(yaw - s["end"]["yaw"], math.tau), 0, 6)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    options = parser.parse_args()
    TRAMLINE = options.tramline
    unittest.main(argv=sys.argv[:1])
