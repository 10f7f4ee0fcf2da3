"""Runs tramline, and keeps what the runs took."""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from plan_shapes import measure

ROOT = Path(__file__).resolve().parent.parent.parent


class Program:
    def __init__(self, path):
        self.path, self.times = str(Path(path).resolve()), []

    def run(self, *arguments):
        """What the program prints; the caller's program ends where it refuses."""
        command = [self.path, *map(str, arguments)]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"papers: {' '.join(command)}\n{done.stderr}")
        return done.stdout

    def json(self, *arguments):
        return json.loads(self.run(*arguments, "--json"))

    def timed(self, what, printed, *arguments):
        """As json(), with a row for the table of times: what it was, its seconds, and those of the paper."""
        start = time.perf_counter()
        out = self.json(*arguments)
        self.times.append([what, f"{out.get('seconds', time.perf_counter() - start):.3f}", printed])
        return out

    def measured(self, threshold_deg, *arguments):
        """A plan, and how many corners of its field are larger than the threshold."""
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/plan.gpkg"
            plan = self.json("plan", *arguments, "-o", file)
            return {**plan, "corners": measure(file, threshold_deg)["corners"]}

    def picture(self, file, *arguments):
        self.run(*arguments, "--quiet", "--picture", file)

    def close_up(self, file, number, *arguments):
        """The picture of one obstacle of a plan."""
        with tempfile.TemporaryDirectory() as folder:
            self.run("plan", *arguments, "--quiet", "--zoom-obstacles", folder)
            (drawn,) = Path(folder).glob(f"*-obstacle-{number}.png")
            file.write_bytes(drawn.read_bytes())
