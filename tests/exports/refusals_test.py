#!/usr/bin/env python3
"""What cannot be written, in every format: exit code 2, one sentence, and nothing half-written. And names that are long or not
ASCII, which can be written in all of them."""

import json
import pathlib
import re
import subprocess
import xml.etree.ElementTree as xml
import zipfile

import yaml

from rectangle import OfRectangle, run_tests, write_field

NAME = "Große Breite 田んぼ & <Süd> " + "lang " * 40
ROUTES = ["gpx", "plan", "waypoints", "kmz", "yaml", "yml", "json"]
LAYERS = ["geojson", "kml", "fgb", "zip", "pdf"]
TERMINALS = [("--isoxml", "4"), ("--isoxml", "3"), ("--agopengps",)]
DRONE = """width_m = 10.0
flight_altitude_m = 3.0
"""


class Exports(OfRectangle):
    @classmethod
    def prepare(cls):
        write_field(cls.folder / "field.geojson", NAME)
        (cls.folder / "drone.toml").write_text(DRONE)
        cls.plan = cls.planned("plan.gpkg", "--headlands", "1", "--ab", cls.meridian, "--route", "--order", "adjacent")
        cls.tracks = cls.planned("tracks.gpkg", "--headlands", "1", "--ab", cls.meridian, "--route", "none")

    def export(self, plan, target, *options):
        if str(target).endswith(".kmz"):
            options += ("--machine", str(self.folder / "drone.toml"))
        return subprocess.run([self.tramline, "export", plan, "-o", str(target), *options], capture_output=True, text=True)

    def refused(self, done, *mentioned):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Atramline: [^\n]+\n\Z", "one sentence")
        for text in mentioned:
            self.assertIn(text, done.stderr)

    def all_targets(self, folder):
        """Of every format, with its options."""
        for extension in ROUTES + LAYERS:
            yield folder / f"out.{extension}", ()
        for options in TERMINALS:
            yield folder / "out", options
            yield folder / "out.zip", options

    def test_a_plan_without_a_route(self):
        target = self.folder / "no_route"
        target.mkdir()
        for extension in ROUTES:
            with self.subTest(extension):
                self.refused(self.export(self.tracks, target / f"out.{extension}"), "no route", "tracks.gpkg")
        self.refused(self.export(self.tracks, target / "out.kml", "--layer", "route"), "route")
        self.assertEqual(list(target.iterdir()), [])

    def test_a_folder_that_takes_no_files(self):
        for target, options in self.all_targets(pathlib.Path("/proc")):
            with self.subTest(f"{target} {options}"):
                self.refused(self.export(self.plan, target, *options), "/proc")

    def test_no_such_folder(self):
        for target, options in self.all_targets(self.folder / "missing"):
            with self.subTest(f"{target} {options}"):
                self.refused(self.export(self.plan, target, *options), "missing")
        self.assertFalse((self.folder / "missing").exists())

    def test_a_folder_of_that_name(self):
        folder = self.folder / "taken"
        for target, options in self.all_targets(folder):
            target.mkdir(parents=True, exist_ok=True)
            (target / "TASKDATA").mkdir(exist_ok=True)
            (target / "TASKDATA" / "kept.txt").write_text("kept")
        before = sorted(folder.rglob("*"))
        for target, options in self.all_targets(folder):
            with self.subTest(f"{target} {options}"):
                self.refused(self.export(self.plan, target, *options), "taken")
        self.assertEqual(sorted(folder.rglob("*")), before)

    def test_the_input_is_not_overwritten(self):
        before = pathlib.Path(self.plan).read_bytes()
        for options in [()] + TERMINALS:
            self.assertEqual(self.export(self.plan, self.plan, *options).returncode, 2)
        self.assertEqual(pathlib.Path(self.plan).read_bytes(), before)

    def test_long_and_foreign_names(self):
        folder = self.folder / "names"
        folder.mkdir()
        for target, options in self.all_targets(folder):
            if target.suffix == ".zip" and options:
                target = folder / ("set" + "".join(options) + ".zip")
            elif options:
                target = folder / ("folder" + "".join(options))
            with self.subTest(target.name):
                done = self.export(self.plan, target, *options)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        name = NAME.strip()
        gpx = xml.parse(folder / "out.gpx").getroot()
        self.assertEqual(gpx.find(".//{*}trk/{*}name").text.strip(), name)
        for file in ("out.yaml", "out.json"):
            self.assertEqual(yaml.safe_load((folder / file).read_text())["field"].strip(), name)
        self.assertTrue(json.loads((folder / "out.plan").read_text())["mission"]["items"])
        for version in "43":
            with zipfile.ZipFile(folder / f"set--isoxml{version}.zip") as files:
                root = xml.fromstring(files.read("TASKDATA/TASKDATA.XML"))
            shown = root.find("PFD").get("C")
            self.assertTrue(shown.startswith("Grosse Breite") and shown.isascii() and len(shown) <= 32, shown)
            self.assertEqual(root.find("TSK").get("B"), shown)
        with zipfile.ZipFile(folder / "set--agopengps.zip") as files:
            (inside,) = {entry.split("/")[0] for entry in files.namelist()}
        self.assertTrue(re.fullmatch(r"[A-Za-z0-9_& -]{1,32}", inside), inside)


if __name__ == "__main__":
    run_tests()
