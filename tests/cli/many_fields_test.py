#!/usr/bin/env python3
"""Runs over many fields that are stopped: killed at any moment, or left by whoever reads the output.

A run with --resume has to end up with the files and the output of a run that nobody disturbed, whenever
and however often it was killed before.
"""

import hashlib
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
FIELDS = 7
SEED = int(os.environ.get("TRAMLINE_SEED", "20"))


def write_fields(path):
    """Rectangles of 150 by 70 m at various angles, two of one id, and one that no machine fits into."""
    features = []
    for i in range(FIELDS):
        lon, lat, lean = 9.0 + 0.01 * i, 54.0, 0.0001 * i
        wide, high = (0.00002, 0.00001) if i == 3 else (0.0023, 0.0006)
        ring = [[lon, lat], [lon + wide, lat + lean], [lon + wide, lat + 1.1 * high + lean], [lon, lat + high]]
        features.append({"type": "Feature", "properties": {"id": f"field {i // 2}"},
                         "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]}})
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))


def without_seconds(text):
    return re.sub(rb'"seconds":[-+0-9.e]+', b'"seconds":X', text)


class ManyFields(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="tramline-many-")
        self.folder = pathlib.Path(self.scratch.name)
        self.input = self.folder / "farm.geojson"
        write_fields(self.input)
        self.addCleanup(self.scratch.cleanup)

    def command(self, *more):
        return [PROGRAM, "plan", self.input, "--all", "--width", "6", "--threads", "1", *more]

    def files(self, where):
        """The plans by name; the record tells how the run went, not what came of it."""
        return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(where.rglob("*"))
                if p.is_file() and p.suffix == ".gpkg"}

    def killed_again_and_again(self, *more):
        whole, stopped = self.folder / "whole", self.folder / "stopped"
        whole.mkdir()
        stopped.mkdir()
        arguments = self.command("--json", "-o", "plan.gpkg", *more)
        calm = subprocess.run(arguments, cwd=whole, capture_output=True, check=False)
        self.assertEqual(calm.returncode, 3, calm.stderr)
        rng = random.Random(SEED)
        kills = 0
        for attempt in range(200):
            run = subprocess.Popen([*arguments, "--resume"], cwd=stopped, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL)
            try:
                # Longer from run to run, so that it comes to an end on the slowest machine.
                out, _ = run.communicate(timeout=rng.uniform(0, 0.05 + 0.01 * attempt))
            except subprocess.TimeoutExpired:
                run.kill()
                run.communicate()
                kills += 1
                continue
            self.assertEqual(run.returncode, 3)
            break
        else:
            self.fail("the run never came to an end")
        self.assertGreater(kills, 0)
        self.assertEqual(len(calm.stdout.splitlines()), FIELDS)
        self.assertEqual(without_seconds(out), without_seconds(calm.stdout), f"seed {SEED}")
        self.assertEqual(self.files(stopped), self.files(whole), f"seed {SEED}")
        left = [p.name for p in stopped.iterdir() if p.name.startswith(".") and p.is_dir()]
        self.assertEqual(left, [])
        return stopped

    def test_a_killed_run_goes_on_where_it_was(self):
        self.killed_again_and_again()

    def test_a_killed_run_into_one_file_goes_on_where_it_was(self):
        stopped = self.killed_again_and_again("--one-file")
        check = subprocess.run([PROGRAM, "check", stopped / "plan.gpkg"], capture_output=True, check=False)
        self.assertEqual(check.returncode, 0, check.stdout)
        self.assertEqual(check.stdout.count(b"plan holds"), FIELDS - 1)

    def test_nothing_is_planned_again_and_changes_are(self):
        def run(*more):
            return subprocess.run(self.command("-o", "plan.gpkg", *more), cwd=self.folder, capture_output=True,
                                  check=False)
        self.assertEqual(run().returncode, 3)
        self.assertIn(b"; 7 of them by a former run", run("--resume").stderr)
        self.assertNotIn(b"former run", run("--resume", "--radius", "5").stderr)
        fields = json.loads(self.input.read_text())
        fields["features"][1]["geometry"]["coordinates"][0][1][1] += 0.0001
        self.input.write_text(json.dumps(fields))
        self.assertIn(b"6 of them by a former run", run("--resume", "--radius", "5").stderr)

    def test_every_line_is_handed_on_when_it_is_finished(self):
        with subprocess.Popen(self.command("--json"), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as run:
            first = json.loads(run.stdout.readline())
            self.assertEqual(list(first)[:4], ["format_version", "field_id", "key", "file"])
            keys = [first["key"]] + [json.loads(line)["key"] for line in run.stdout]
        self.assertEqual(len(set(keys)), FIELDS)

    def test_a_closed_pipe_is_no_failure(self):
        for restored in (True, False):  # with SIGPIPE as shells leave it, and as services do
            for more in ([], ["--json"], ["--json", "-o", "plan.gpkg"]):
                with self.subTest(restored=restored, more=more):
                    reading, writing = os.pipe()
                    os.close(reading)
                    previous = signal.signal(signal.SIGPIPE, signal.SIG_IGN)
                    try:
                        done = subprocess.run(self.command(*more), cwd=self.folder, stdout=writing,
                                              stderr=subprocess.PIPE, restore_signals=restored, check=False)
                    finally:
                        signal.signal(signal.SIGPIPE, previous)
                        os.close(writing)
                    self.assertEqual(done.returncode, -signal.SIGPIPE)
                    self.assertNotIn(b"tramline:", done.stderr)
        self.assertEqual([p.name for p in self.folder.rglob("*.part")], [])

    def test_a_full_disk_is_one(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        with open("/dev/full", "wb") as full:
            done = subprocess.run(self.command("--json"), stdout=full, stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"is the disk full?", done.stderr)


if __name__ == "__main__":
    unittest.main()
