#!/usr/bin/env python3
"""Runs every benchmark program and keeps the figures in bench/results/<date>-<machine>.json.

Each program prints its own table; medians, means and spreads of the repeats go into the file.
Usage: bench.py BUILD_DIR [further options for Google Benchmark]
"""

import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

REPEATS = 5


def machine_name():
    """Says what the figures were measured on: number and model of the processors."""
    if "TRAMLINE_MACHINE" in os.environ:
        return os.environ["TRAMLINE_MACHINE"]
    info = pathlib.Path("/proc/cpuinfo")
    found = re.search(r"model name\s*:\s*(.+)", info.read_text()) if info.exists() else None
    model = re.sub(r"\((R|TM)\)|CPU|Processor", "", found.group(1)) if found else os.uname().machine
    return re.sub(r"[^a-z0-9]+", "-", f"{os.cpu_count()}x {model}".lower()).strip("-")


def main():
    build = pathlib.Path(sys.argv[1])
    programs = sorted(p for p in (build / "bench").glob("bench_*") if p.is_file() and os.access(p, os.X_OK))
    if not programs:
        sys.exit(f"bench.py: no benchmark programs in {build / 'bench'}")

    collected = None
    with tempfile.TemporaryDirectory() as scratch:
        for program in programs:
            report = pathlib.Path(scratch) / "report.json"
            subprocess.run([program, f"--benchmark_out={report}", "--benchmark_out_format=json",
                            f"--benchmark_repetitions={REPEATS}", "--benchmark_report_aggregates_only=true",
                            *sys.argv[2:]], check=True)
            one = json.loads(report.read_text())
            if collected is None:
                collected = {"context": one["context"], "benchmarks": []}
            collected["benchmarks"] += [{"program": program.name, **row} for row in one["benchmarks"]]

    for private in ("host_name", "executable"):
        collected["context"].pop(private, None)
    target = pathlib.Path("bench/results") / f"{datetime.date.today().isoformat()}-{machine_name()}.json"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(collected, indent=1) + "\n")
    print(f"written: {target}")


if __name__ == "__main__":
    main()
