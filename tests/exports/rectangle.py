"""A field that can be worked out by hand: 200 m from west to east by 100 m from south to north, its south-western corner at
52° N, 9° E."""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

# Radii of curvature of WGS 84 at 52°: 6,375,150 m along the meridian and 6,391,435 m across it.
LAT_DEGREE_M = 111267.35
LON_DEGREE_M = 68678.02


def place(east_m, north_m):
    return (9 + east_m / LON_DEGREE_M, 52 + north_m / LAT_DEGREE_M)


def write_field(path, name, east_m=0):
    corners = [place(east_m + x, y) for x, y in ((0, 0), (200, 0), (200, 100), (0, 100), (0, 0))]
    feature = {"type": "Feature", "properties": {"id": name}, "geometry": {"type": "Polygon", "coordinates": [corners]}}
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))


def convergence_deg(east_m):
    """By how much true north turns over so many metres to the east, to the left."""
    return east_m / LON_DEGREE_M * math.sin(math.radians(52))


class OfRectangle(unittest.TestCase):
    """Tests of files that the program makes of the field, in a folder of their own."""

    tramline = ""
    meridian = "{},{},{},{}".format(*place(0, 0), *place(0, 100))

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.prepare()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def prepare(cls):
        """Fields and plans that several tests look at."""

    @classmethod
    def planned(cls, name, *options):
        """A plan of the field in field.geojson, 10 m wide."""
        subprocess.run([cls.tramline, "plan", str(cls.folder / "field.geojson"), "--width", "10", *options, "--quiet",
                        "-o", str(cls.folder / name)], check=True)
        return str(cls.folder / name)


def run_tests():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    OfRectangle.tramline = parser.parse_args().tramline
    unittest.main(argv=sys.argv[:1])
