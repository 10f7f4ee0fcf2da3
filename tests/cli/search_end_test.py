#!/usr/bin/env python3
"""A search that is ended by --seconds or Ctrl-C gives the plan found till then, marked so.

usage: search_end_test.py PROGRAM
"""
import json
import math
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = None


def wavy_field(path, corners=600, radius=700):
    """Many directions, and more than enough tracks: seconds of search."""
    ring = []
    for i in range(corners):
        angle = 2 * math.pi * i / corners
        r = radius + 40 * math.sin(13 * angle)
        ring.append([round(r * math.cos(angle), 3), round(r * math.sin(angle), 3)])
    ring.append(ring[0])
    feature = {"type": "Feature", "properties": {"id": "wavy"},
               "geometry": {"type": "Polygon", "coordinates": [ring]}}
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))


def catches_interrupts(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("SigCgt:"):
            return bool(int(line.split()[1], 16) >> (signal.SIGINT - 1) & 1)
    return False


class SearchEnd(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.field, self.plan = self.folder / "field.geojson", self.folder / "plan.gpkg"
        wavy_field(self.field)

    def command(self, verb, *options):
        return [PROGRAM, verb, str(self.field), "--crs", "none", "--width", "3", "--json", "-o", str(self.plan),
                *options]

    def holds(self):
        run = subprocess.run([PROGRAM, "check", str(self.plan), "--json"], capture_output=True, text=True, check=False)
        return json.loads(run.stdout)["ok"]

    def test_seconds_end_it(self):
        for tracks_alone in ([], ["--prices", "0.02,0.10,1,5,5"]):
            run = subprocess.run(self.command("plan", "--seconds", "0.3", *tracks_alone), capture_output=True, text=True,
                                 check=True)
            plan = json.loads(run.stdout)
            self.assertTrue(plan["cut_short"])
            self.assertIn("the search was ended before it was through", plan["warnings"][0])
            if tracks_alone:
                self.assertLessEqual(plan["bound"], plan["cost"])
            else:
                self.assertIsNone(plan["bound"])
            self.assertTrue(self.holds())

    def test_a_comparison_ends_too(self):
        run = subprocess.run(self.command("compare", "--seconds", "0.3"), capture_output=True, text=True, check=True)
        compared = json.loads(run.stdout)
        self.assertTrue(compared["cut_short"])
        self.assertGreater(len(compared["front"]), 0)
        self.assertTrue(self.holds())

    def test_time_enough_changes_nothing(self):
        wavy_field(self.field, corners=12, radius=60)
        plain, timed = (json.loads(subprocess.run(self.command("plan", *options), capture_output=True, text=True,
                                                  check=True).stdout) for options in ([], ["--seconds", "1000"]))
        self.assertFalse(timed["cut_short"])
        self.assertEqual({**plain, "seconds": 0}, {**timed, "seconds": 0})

    def test_seconds_have_to_be_some(self):
        for seconds in ("0", "-1", "nan", "soon"):
            run = subprocess.run(self.command("plan", "--seconds", seconds), capture_output=True, text=True,
                                 check=False)
            self.assertEqual(run.returncode, 2, seconds)
            self.assertIn("--seconds", run.stderr)
        self.assertFalse(self.plan.exists())

    def interrupted(self, times):
        with subprocess.Popen(self.command("plan"), stdout=subprocess.PIPE, text=True) as process:
            while not catches_interrupts(process.pid):
                time.sleep(0.01)
            for _ in range(times):
                process.send_signal(signal.SIGINT)
                while catches_interrupts(process.pid):
                    time.sleep(0.001)
            output, _ = process.communicate()
        return process.returncode, output

    def test_an_interrupt_ends_it(self):
        code, output = self.interrupted(1)
        self.assertEqual(code, 0)
        self.assertTrue(json.loads(output)["cut_short"])
        self.assertTrue(self.holds())

    def test_a_second_interrupt_ends_the_program(self):
        code, output = self.interrupted(2)
        self.assertEqual((code, output), (-signal.SIGINT, ""))
        self.assertFalse(self.plan.exists())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
