#!/usr/bin/env python3
"""`tramline batch` from outside: the same bytes whatever the threads, kills and resumed runs.

Usage: batch_test.py TRAMLINE [unittest arguments]. Moments of kills follow from TRAMLINE_SEED, which is printed.
"""

import csv
import json
import os
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

TRAMLINE = sys.argv.pop(1) if len(sys.argv) > 1 else "tramline"
SEED = int(os.environ.get("TRAMLINE_SEED", "1"))
FIELDS = 26


def ring(number):
    """A field of its own shape: coordinates near 9° E, 52° N, a few hundred metres apart."""
    x, y = 9 + 0.01 * (number % 5), 52 + 0.01 * (number // 5)
    wide, high = 0.002 + 0.0002 * (number % 3), 0.001 + 0.0001 * (number % 4)
    return [[x, y], [x + wide, y], [x + wide, y + high], [x + 0.0001 * (number % 7), y + high], [x, y]]


def feature(number):
    geometry = {"type": "Polygon", "coordinates": [ring(number)]}
    if number == 7:
        geometry = {"type": "Point", "coordinates": [9, 52]}
    if number == 11:  # two fields in one
        geometry = {"type": "MultiPolygon", "coordinates": [[ring(11)], [ring(110)]]}
    if number == 13:  # nearer to the antipodes than to the others
        geometry = {"type": "Polygon", "coordinates": [[[x + 130, y - 80] for x, y in ring(13)]]}
    if number == 17:  # too small for the machine
        geometry = {"type": "Polygon", "coordinates": [[[9, 52], [9.00001, 52], [9.00001, 52.00001], [9, 52]]]}
    return {"type": "Feature", "properties": {"id": f"f{number}"}, "geometry": geometry}


class Batch(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.parcels = self.folder / "parcels.geojson"
        features = [feature(number) for number in range(FIELDS)]
        self.parcels.write_text(json.dumps({"type": "FeatureCollection", "features": features}))

    def tearDown(self):
        self.temporary.cleanup()

    def words(self, into, *more):
        options = ["--width", "12", "--prices", "0.02,0.1,1", "--chunk", "4", *more]
        return [TRAMLINE, "batch", str(self.parcels), "-o", str(self.folder / into), *options]

    def run_batch(self, into, *more, code=3):
        done = subprocess.run(self.words(into, *more), capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def bytes_in(self, into):
        root = self.folder / into
        return {str(file.relative_to(root)): file.read_bytes() for file in sorted(root.rglob("*")) if file.is_file()}

    def test_threads_leave_no_trace(self):
        self.run_batch("one", "--threads", "1")
        self.run_batch("four", "--threads", "4")
        one = self.bytes_in("one")
        self.assertEqual(one, self.bytes_in("four"))
        self.assertIn("chunks/000001.gpkg", one)
        self.assertIn("chunks/000004-2.gpkg", one)
        self.assertTrue(one["histogram.png"].startswith(b"\x89PNG"))

    @unittest.skipUnless(len(os.sched_getaffinity(0)) > 1, "this machine has one processor")
    def test_one_processor_writes_what_several_do(self):
        one = {min(os.sched_getaffinity(0))}
        for name, choose in (("one", lambda: os.sched_setaffinity(0, one)), ("several", None)):
            words = [TRAMLINE, "plan", str(self.parcels), "--id", "f0", "--width", "12"]
            subprocess.run(
                [*words, "-o", f"{self.folder}/{name}.gpkg", "--quiet"],
                preexec_fn=choose, stdout=subprocess.DEVNULL, check=True,
            )
        self.assertEqual((self.folder / "one.gpkg").read_bytes(), (self.folder / "several.gpkg").read_bytes())

    def test_every_field_is_accounted_for(self):
        sums = json.loads(self.run_batch("out", "--json").stdout)
        self.assertEqual((sums["fields"], sums["planned"], sums["refused"]), (FIELDS + 1, FIELDS - 1, 2))
        with open(self.folder / "out/fields.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        with open(self.folder / "out/refused.csv", newline="") as file:
            refused = {row["field_id"]: row["error"] for row in csv.DictReader(file)}
        self.assertEqual(set(refused), {"f7", "f17"})
        self.assertIn("not a polygon", refused["f7"])
        # Another road to the same figures.
        words = [TRAMLINE, "plan", str(self.parcels), "--all", "--width", "12", "--prices", "0.02,0.1,1", "--json"]
        lines = [json.loads(line) for line in subprocess.run(words, capture_output=True, text=True).stdout.splitlines()]
        expected = {line["key"]: line for line in lines if "area_m2" in line}
        self.assertEqual({row["key"] for row in rows}, set(expected))
        for row in rows:
            for key in ("area_m2", "tracks", "turns", "overlap_m2", "uncovered_m2", "track_length_m", "cost"):
                self.assertEqual(float(row[key]), expected[row["key"]][key], (row["key"], key))
        self.assertAlmostEqual(sums["area_m2"], sum(float(row["area_m2"]) for row in rows), places=3)

    def test_plans_hold(self):
        self.run_batch("out")
        files = sorted((self.folder / "out/chunks").glob("*.gpkg"))
        self.assertGreater(len(files), 3)
        for file in files:
            done = subprocess.run([TRAMLINE, "check", str(file), "--json"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout[-500:])

    def test_killed_and_resumed(self):
        self.run_batch("whole")
        moments = random.Random(SEED)
        kills = int(os.environ.get("TRAMLINE_KILLS", "4"))
        for _ in range(kills):
            run = subprocess.Popen(self.words("killed", "--resume"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(moments.uniform(0.02, 0.5))
            run.kill()
            run.wait()
        self.run_batch("killed", "--resume")
        self.assertEqual(self.bytes_in("killed"), self.bytes_in("whole"), f"TRAMLINE_SEED={SEED}")

    def test_finished_chunks_are_left_alone(self):
        self.run_batch("out")
        chunk = self.folder / "out/chunks/000002.gpkg"
        before = chunk.stat().st_mtime_ns
        (self.folder / "out/chunks/000003.jsonl").unlink()
        self.run_batch("out", "--resume")
        self.assertEqual(chunk.stat().st_mtime_ns, before)
        self.assertTrue((self.folder / "out/chunks/000003.jsonl").exists())

    def test_another_batch_is_refused(self):
        self.run_batch("out")
        self.assertIn("--resume", self.run_batch("out", code=2).stderr)
        self.assertIn("'options'", self.run_batch("out", "--resume", "--clearance", "1", code=2).stderr)
        self.parcels.write_text(self.parcels.read_text().replace("9.002", "9.0021", 1))
        self.assertIn("'contents'", self.run_batch("out", "--resume", code=2).stderr)

    def test_the_files_beside_a_shapefile_count(self):
        features = [feature(number) for number in range(3)]
        self.parcels.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        shapes = self.folder / "shapes"
        subprocess.run(["ogr2ogr", "-f", "ESRI Shapefile", shapes, self.parcels, "-nln", "parcels"], check=True)
        for name, given in (("file", shapes / "parcels.shp"), ("folder", shapes)):
            self.parcels = given
            self.run_batch(name, code=0)
            self.run_batch(name, "--resume", code=0)
        table = shapes / "parcels.dbf"
        table.write_bytes(table.read_bytes().replace(b"f1", b"g1"))
        for name, given in (("file", shapes / "parcels.shp"), ("folder", shapes)):
            self.parcels = given
            self.assertIn("'contents'", self.run_batch(name, "--resume", code=2).stderr)

    def test_changes_that_sqlite_keeps_beside_the_file_count(self):
        features = [feature(number) for number in range(3)]
        self.parcels.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        table = self.folder / "parcels.gpkg"
        subprocess.run(["ogr2ogr", "-f", "GPKG", "-lco", "SPATIAL_INDEX=NO", table, self.parcels, "-nln", "parcels"], check=True)
        self.parcels = table
        before = sqlite3.connect(table)
        before.execute("PRAGMA journal_mode=WAL")
        before.close()
        self.run_batch("out", code=0)
        self.run_batch("out", "--resume", code=0)
        content = table.read_bytes()
        edited = sqlite3.connect(table)  # as QGIS has it open
        edited.execute("PRAGMA wal_autocheckpoint=0")
        edited.execute("UPDATE parcels SET id = 'another' WHERE fid = 1")
        edited.commit()
        try:
            self.assertEqual(table.read_bytes(), content, "the change is in the log alone")
            self.assertIn("'contents'", self.run_batch("out", "--resume", code=2).stderr)
        finally:
            edited.close()

    def test_a_damaged_chunk_is_named(self):
        self.run_batch("out")
        (self.folder / "out/chunks/000001.jsonl").write_text('{"field_id": \n')
        self.assertIn("line 1 of", self.run_batch("out", "--resume", code=2).stderr)

    def test_bad_input_leaves_nothing(self):
        missing = subprocess.run(
            [TRAMLINE, "batch", "none.gpkg", "-o", str(self.folder / "none")], capture_output=True, text=True
        )
        self.assertEqual(missing.returncode, 2)
        self.run_batch("none", "--width", "-3", code=2)
        self.run_batch("none", "--layer", "absent", code=2)
        self.assertFalse((self.folder / "none").exists())


if __name__ == "__main__":
    unittest.main()
