#!/usr/bin/env python3
"""Plans of the examples and of random fields, priced as lines: plan files and exports give the figures of their plan to
1e-6 of the field; Shapefiles, which hold curves as chords within 1 cm only, to 1e-4. `tramline check` holds each of them.

usage: price_again_test.py --tramline PROGRAM --examples FOLDER
"""
import argparse
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

ARGUMENTS = argparse.Namespace(tramline="tramline", examples=pathlib.Path("examples"))
EXACT, CHORDS = 1e-6, 1e-4


# Lines are priced as tracks alone, without a route.
TRACKS = ["--prices", "0.02,0.10,1,5,5"]


def tramline(*arguments):
    done = subprocess.run([ARGUMENTS.tramline, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.stderr}{done.stdout}")
    return done.stdout


class PricedAgain(unittest.TestCase):
    def compare(self, planned, priced, tolerance):
        for key in ("tracks", "turns", "stops", "crossings", "further_subfields"):
            self.assertEqual(planned[key], priced[key], key)
        for key in ("overlap_m2", "uncovered_m2"):
            self.assertLess(abs(planned[key] - priced[key]), tolerance * planned["area_m2"], key)
        # Passes have the tightest arcs: a chord over 1 cm on a radius of 6 m is 6e-4 shorter.
        for key, times in (("track_length_m", 1), ("headland_length_m", 6)):
            self.assertLess(abs(planned[key] - priced[key]), times * tolerance * max(1, planned[key]), key)
        self.assertLess(priced["identity_error_m2"], 1e-6)

    def price(self, field, options, formats):
        """`formats`: the tolerance by the extension of an export."""
        with tempfile.TemporaryDirectory() as folder:
            plan, lines = pathlib.Path(folder, "plan.gpkg"), pathlib.Path(folder, "lines.gpkg")
            planned = json.loads(tramline("plan", *field, *options, *TRACKS, "-o", plan, "--json"))
            self.compare(planned, json.loads(tramline("price", plan, "--json", "-o", lines)), EXACT)
            tramline("check", lines)
            for extension, tolerance in formats.items():
                export = pathlib.Path(folder, "lines." + extension)
                tramline("export", plan, "-o", export)
                width = options[options.index("--width") + 1]
                priced = tramline("price", export, "--field", *field, "--width", width, "--json", "-o", lines)
                with self.subTest(extension):
                    self.compare(planned, json.loads(priced), tolerance)
                    tramline("check", lines)

    def riverside(self):
        at = ARGUMENTS.examples
        return [at / "riverside.geojson", "--obstacles", at / "riverside-obstacles.geojson",
                "--passable", at / "riverside-waterway.geojson"]

    def test_tracks_cut_at_obstacles(self):
        self.price(self.riverside(), ["--width", "6", "--avoid", "cut"],
                   {"geojson": EXACT, "fgb": EXACT, "kml": EXACT, "zip": EXACT})

    def test_detours(self):
        self.price(self.riverside(), ["--width", "6"], {"geojson": EXACT, "kml": EXACT, "zip": CHORDS})

    def test_headlands(self):
        self.price(self.riverside(), ["--width", "6", "--headlands", "2", "--obstacle-headlands", "1"],
                   {"geojson": EXACT, "fgb": EXACT, "kml": EXACT, "zip": CHORDS})

    def test_arcs_of_half_the_width(self):
        self.price(self.riverside(), ["--width", "12", "--radius", "6", "--headlands", "1", "--avoid", "cheapest"],
                   {"geojson": EXACT, "fgb": EXACT, "kml": EXACT})

    def test_curves(self):
        self.price([ARGUMENTS.examples / "roadside.geojson"], ["--width", "6", "--curved", "always"],
                   {"geojson": EXACT, "fgb": EXACT, "zip": CHORDS})

    def test_kinks(self):
        self.price([ARGUMENTS.examples / "roadside.geojson"],
                   ["--width", "6", "--curved", "always", "--tracks", "paper", "--obstacle-headlands", "1"],
                   {"geojson": EXACT, "zip": CHORDS})

    def test_random_fields(self):
        with tempfile.TemporaryDirectory() as folder:
            field = pathlib.Path(folder, "field.geojson")
            for seed in (int(os.environ.get("TRAMLINE_SEED", 1)) + i
                         for i in range(int(os.environ.get("TRAMLINE_CASES", 4)))):
                draw = random.Random(seed)
                smooth = draw.random() < 0.5
                field.write_text(json.dumps(random_field(draw, smooth)))
                options = random_options(draw, smooth)
                with self.subTest(f"TRAMLINE_SEED={seed} TRAMLINE_CASES=1", options=options):
                    self.price([field], options, {draw.choice(["geojson", "fgb", "kml"]): EXACT})

    def changed(self, change):
        """The detours of riverside, priced from a GeoJSON export after `change` to its features."""
        with tempfile.TemporaryDirectory() as folder:
            plan, lines = pathlib.Path(folder, "plan.gpkg"), pathlib.Path(folder, "lines.geojson")
            planned = json.loads(tramline("plan", *self.riverside(), "--width", "6", *TRACKS, "-o", plan, "--json"))
            tramline("export", plan, "-o", lines)
            collection = json.loads(lines.read_text())
            change(collection["features"])
            lines.write_text(json.dumps(collection))
            return planned, json.loads(tramline("price", lines, "--field", *self.riverside(), "--width", "6", "--json"))

    def test_a_line_that_was_moved_is_priced_where_it_is(self):
        def move(features):
            features[0]["geometry"]["coordinates"] = [[x, y + 1e-5] for x, y in features[0]["geometry"]["coordinates"]]
        planned, priced = self.changed(move)
        self.assertTrue(any("1 of " in note and "moved or cut" in note for note in priced["warnings"]), priced["warnings"])
        self.assertGreater(abs(planned["overlap_m2"] - priced["overlap_m2"]), 10)

    def test_a_text_that_was_cut_is_left_aside(self):
        def cut(features):
            for feature in features:
                feature["properties"]["exact_path"] = feature["properties"]["exact_path"][:30]
        planned, priced = self.changed(cut)
        self.assertTrue(any("not as exported" in note for note in priced["warnings"]), priced["warnings"])
        self.compare(planned, priced, CHORDS)

    def test_a_line_driven_the_other_way_keeps_its_path(self):
        def turn(features):
            features.reverse()
            for number, feature in enumerate(features):
                feature["geometry"]["coordinates"].reverse()
                feature["properties"]["order"] = number
        planned, priced = self.changed(turn)
        for key in ("overlap_m2", "uncovered_m2"):
            self.assertLess(abs(planned[key] - priced[key]), EXACT * planned["area_m2"], key)


def random_field(draw, smooth):
    """A star-shaped field of a few hectares in degrees, with small obstacles; `smooth`: its edges are curves."""
    lat, lon = draw.uniform(-60, 60), draw.uniform(-170, 170)
    def ring(east_m, north_m, radii_m):
        out = []
        for i, radius_m in enumerate(radii_m):
            angle = 2 * math.pi * i / len(radii_m)
            x, y = east_m + radius_m * math.cos(angle), north_m + radius_m * math.sin(angle)
            out.append([lon + x / (111320 * math.cos(math.radians(lat))), lat + y / 111320])
        return out + out[:1]
    bays, phase = draw.randint(2, 3), draw.uniform(0, 2 * math.pi)
    radii_m = [110 + 15 * math.sin(bays * 2 * math.pi * i / 60 + phase) for i in range(60)]
    if not smooth:
        radii_m = [draw.uniform(70, 150) for _ in range(draw.randint(5, 12))]
    rings = [ring(0, 0, radii_m)]
    for i in range(draw.randint(0, 4)):
        angle, away_m = 2 * math.pi * (i + draw.uniform(0, 0.4)) / 4, draw.uniform(20, 35)
        rings.append(ring(away_m * math.cos(angle), away_m * math.sin(angle), [draw.uniform(1, 5)] * 7)[::-1])
    geometry = {"type": "Polygon", "coordinates": rings}
    return {"type": "FeatureCollection",
            "features": [{"type": "Feature", "properties": {"id": "random"}, "geometry": geometry}]}


def random_options(draw, smooth):
    options = ["--width", str(draw.choice([3, 6, 9, 12])), "--radius", str(draw.choice([3, 6, 8]))]
    options += ["--curved", draw.choice(["always", "auto"])] if smooth else []
    options += draw.choice([[], ["--headlands", "1"], ["--headlands", "2", "--obstacle-headlands", "1"]])
    return options + draw.choice([[], ["--avoid", "cheapest"], ["--avoid", "paper"]])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--examples", required=True, type=pathlib.Path)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
