#!/usr/bin/python3
"""A large batch on Dask distributed whose workers are killed at random, and its scheduler once: the result has the bytes
of the one that the program alone writes, and every field is accounted for.

Usage: batch_kills.py --tramline PROGRAM --parcels FILE --fields N [--kills 5] [--seed 1] [--words="--width=24 …"]

The fields are those of FILE, repeated and moved by whole degrees until there are N. Prints the figures of docs/batch.md.
"""

from __future__ import annotations

import argparse
import filecmp
import json
import os
import pathlib
import random
import resource
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def moved(coordinates, by):
    if isinstance(coordinates[0], (int, float)):
        return [coordinates[0] + by, *coordinates[1:]]
    return [moved(part, by) for part in coordinates]


def write_parcels(source: pathlib.Path, count: int, into: pathlib.Path) -> None:
    """As a GeoPackage, in which workers pass over the features of others quickly."""
    features = json.loads(source.read_text(encoding="utf-8"))["features"]
    text = into.with_suffix(".geojson")
    with text.open("w", encoding="utf-8") as out:
        out.write('{"type": "FeatureCollection", "features": [\n')
        for number in range(count):
            feature = features[number % len(features)]
            geometry = feature["geometry"]
            # So little that none leaves the globe, and so much that none lies on another.
            by = 0.02 * (number // len(features))
            out.write(json.dumps({
                "type": "Feature",
                "properties": {"id": f"f{number}"},
                "geometry": {"type": geometry["type"], "coordinates": moved(geometry["coordinates"], by)},
            }))
            out.write("\n" if number + 1 == count else ",\n")
        out.write("]}\n")
    subprocess.run(["ogr2ogr", "-f", "GPKG", "-nln", "parcels", str(into), str(text)], check=True)
    text.unlink()


def difference(one: pathlib.Path, other: pathlib.Path) -> list[str]:
    def names(root):
        return {str(file.relative_to(root)) for file in root.rglob("*") if file.is_file()}

    out = sorted(names(one) ^ names(other))
    return out + [name for name in sorted(names(one) & names(other)) if not filecmp.cmp(one / name, other / name, False)]


def finished_chunks(folder: pathlib.Path) -> int:
    return sum(1 for _ in folder.rglob("*.jsonl"))


class Cluster:
    """A scheduler and workers as processes; a worker that dies is replaced, as any supervisor would."""

    def __init__(self, workers: int, folder: pathlib.Path) -> None:
        self._port, self._count, self._folder = free_port(), workers, folder
        self.address = f"tcp://127.0.0.1:{self._port}"
        self.workers: list[subprocess.Popen] = []
        self.start()

    def _spawn(self, *words: str) -> subprocess.Popen:
        command = [sys.executable, "-m", *words]
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def start(self) -> None:
        self.scheduler = self._spawn(
            "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(self._port), "--no-dashboard"
        )
        self.workers = [self._worker() for _ in range(self._count)]

    def _worker(self) -> subprocess.Popen:
        words = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--local-directory", str(self._folder)]
        return self._spawn("distributed.cli.dask_worker", self.address, *words)

    def kill_worker(self, which: int) -> None:
        self.workers[which].kill()
        self.workers[which].wait()
        self.workers[which] = self._worker()

    def stop(self) -> None:
        for process in [*self.workers, self.scheduler]:
            process.kill()
            process.wait()


def processor_s() -> float:
    """Of all processes begun here that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def peak_mb(tramline: str, words: list[str]) -> tuple[float, float]:
    """Runs the program; seconds, and the most memory it had."""
    start = time.monotonic()
    done = subprocess.run([tramline, "batch", *words, "--quiet"])
    assert done.returncode in (0, 3), done.returncode
    return time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--parcels", type=pathlib.Path, required=True)
    parser.add_argument("--fields", type=int, default=100_000)
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--words", default="--width=24 --radius=8 --like=versleijen")
    asked = parser.parse_args()
    moments = random.Random(asked.seed)
    with tempfile.TemporaryDirectory(prefix="tramline-batch-") as name:
        folder = pathlib.Path(name)
        parcels = folder / "parcels.gpkg"
        write_parcels(asked.parcels, asked.fields, parcels)
        words = [str(parcels), *shlex.split(asked.words)]
        before_s = processor_s()
        seconds, most = peak_mb(asked.tramline, [*words, f"--output={folder / 'alone'}"])
        sums = json.loads((folder / "alone/summary.json").read_text())
        alone_s = processor_s() - before_s
        size_mb = sum(file.stat().st_size for file in (folder / "alone").rglob("*")) / 1e6
        print(
            f"alone: {asked.fields} features, {asked.fields / seconds:.1f} a second, {1000 * alone_s / asked.fields:.1f} ms of a "
            f"processor each, at most {most:.0f} MB, {size_mb:.0f} MB written",
            flush=True,
        )
        assert most < 500, "memory grows with the number of fields"
        assert sums["fields"] >= asked.fields, sums

        cluster = Cluster(asked.workers, folder / "workers")
        # By how much is done rather than by the clock: all of them happen, however fast the machine is.
        kills = [(moments.uniform(0.05, 0.9), "worker") for _ in range(asked.kills)]
        kills.append((moments.uniform(0.3, 0.7), "scheduler"))
        start, runs, ended, done = time.monotonic(), 0, threading.Event(), []

        def kill() -> None:
            whole = finished_chunks(folder / "alone")
            for share, what in sorted(kills):
                while finished_chunks(folder / "dask") < share * whole:
                    if ended.wait(0.2):
                        return
                done.append(what)
                print(f"after {time.monotonic() - start:.0f} s, {100 * share:.0f} % done, a {what} is killed", flush=True)
                if what == "worker":
                    cluster.kill_worker(moments.randrange(asked.workers))
                else:
                    cluster.stop()
                    cluster.start()

        killer = threading.Thread(target=kill)
        killer.start()
        code = 1
        try:
            # A run that loses its scheduler ends; whoever started it starts it again.
            while code == 1 and runs < asked.kills + 5:
                runs += 1
                command = [sys.executable, "-m", "tramline.batch", *words, f"--output={folder / 'dask'}", "--resume"]
                code = subprocess.run([*command, "--scheduler", cluster.address, "--quiet"]).returncode
        finally:
            ended.set()
            killer.join()
            cluster.stop()
        took, dask_s = time.monotonic() - start, processor_s() - before_s - alone_s
        print(
            f"on Dask: {asked.fields / took:.1f} a second with {asked.workers} workers, {runs} runs, "
            f"{100 * (dask_s / alone_s - 1):.0f} % more processor time",
            flush=True,
        )
        assert code in (0, 3), code
        assert len(done) == len(kills), f"only {done} were killed"
        different = difference(folder / "alone", folder / "dask")
        assert not different, f"seed {asked.seed}: {different[:10]}"
    print("the same bytes")
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    sys.exit(main())
