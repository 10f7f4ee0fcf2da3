#!/usr/bin/env python3
"""Plans of the examples, priced as lines: plan files give the figures of their plan to 1e-6 of the field, exports of
straight tracks too, exports of curves (chords within 1 cm) to 1e-4. `tramline check` holds each of them.

usage: price_again_test.py --tramline PROGRAM --examples FOLDER
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ARGUMENTS = argparse.Namespace(tramline="tramline", examples=pathlib.Path("examples"))
EXACT, CHORDS = 1e-6, 1e-4


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
            planned = json.loads(tramline("plan", *field, *options, "-o", plan, "--json"))
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
        self.price(self.riverside(), ["--width", "6"], {"geojson": CHORDS, "zip": CHORDS})

    def test_headlands(self):
        self.price(self.riverside(), ["--width", "6", "--headlands", "2", "--obstacle-headlands", "1"],
                   {"zip": CHORDS})

    def test_curves(self):
        self.price([ARGUMENTS.examples / "roadside.geojson"], ["--width", "6", "--curved", "always"],
                   {"fgb": CHORDS})

    def test_kinks(self):
        self.price([ARGUMENTS.examples / "roadside.geojson"],
                   ["--width", "6", "--curved", "always", "--tracks", "paper", "--obstacle-headlands", "1"],
                   {"zip": CHORDS})


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--examples", required=True, type=pathlib.Path)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
