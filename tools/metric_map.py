#!/usr/bin/env python3
"""Prints tables of docs/metric-map.md: what maps of real fields come to, and how long they take.

    tools/metric_map.py [--data DIR] [--tramline PATH] [table ...]

Tables: time (straight, curved and both), sums (tracks, length, overlap), paper (Zhou's own construction against
parallel tracks). The fields are in DIR/fields/fields.geojson (default for DIR: $TRAMLINE_DATA); each plan runs on
one thread and is held against its identity on the way.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TWELVE = ["bg/5", "bg/8", "bg/19", "bg/92", "cz/26", "cz/48", "de-bb/97", "de-sh/12", "de-sh/58", "ec-ro/69", "fi/67",
          "us-csb/18"]
FIFTEEN = ["be-wal/57", "bg/5", "bg/8", "bg/9", "bg/19", "bg/92", "cz/12", "cz/26", "cz/48", "de-bb/97", "de-sh/12",
           "de-sh/58", "fi/67", "fi/89", "us-csb/18"]
WIDTHS = (2, 4, 6)
KINDS = {"straight": [], "curved": ["--curved", "always"], "auto": ["--curved", "auto"]}
COMMON = ["--radius", "6", "--end-rule", "cover", "--min-length", "0", "--threads", "1", "--json", "--quiet"]
TWO_PASSES = ["--headlands", "2", "--obstacle-headlands", "2"]


class Maps:
    def __init__(self, program, fields):
        self.program, self.fields, self.made = program, fields, {}

    def map(self, field, width, *options):
        """What --json says, with `cpu_s`; None where the field is refused, with the reason on stderr."""
        key = (field, width, options)
        if key not in self.made:
            self.made[key] = self.run(field, width, options)
        return self.made[key]

    def run(self, field, width, options):
        command = [self.program, "map", self.fields, "--where", f"id='{field}'", "--width", str(width), *COMMON, *options]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            print(done.stderr, end="", file=sys.stderr)
            return None
        plan = json.loads(done.stdout)
        if plan["identity_error_m2"] > 1e-6:
            sys.exit(f"{field}, w = {width} m: the identity is off by {plan['identity_error_m2']} m²")
        plan["cpu_s"] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return plan


def row(cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def time_table(maps):
    row(["field", "ha", "obstacles", "straight, *w* = 2, 4, 6 m", "curved", "auto"])
    print("|---|--:|--:|--:|--:|--:|")
    for field in TWELVE:
        plans = {kind: [maps.map(field, width, *TWO_PASSES, *options) for width in WIDTHS]
                 for kind, options in KINDS.items()}
        first = plans["straight"][0]
        times = [", ".join(f"{plan['cpu_s']:.1f}" if plan else "–" for plan in some) for some in plans.values()]
        row([field, f"{first['area_m2'] / 1e4:.2f}", first["obstacles"], *times])


def sums_table(maps):
    row(["field", "*w*, m", "tracks", "length, m", "overlap, ha", "curved: tracks", "length, m", "overlap, ha",
         "uncovered, m²"])
    print("|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    for field in TWELVE:
        for width in WIDTHS:
            straight = maps.map(field, width, *TWO_PASSES)
            curved = maps.map(field, width, *TWO_PASSES, *KINDS["curved"])
            cells = [field, width]
            for plan in (straight, curved):
                cells += ([plan["tracks"], f"{plan['track_length_m']:.0f}", f"{plan['overlap_m2'] / 1e4:.2f}"]
                          if plan else ["–"] * 3)
            row([*cells, f"{curved['uncovered_m2']:.1f}" if curved else "–"])
            if straight and straight["uncovered_m2"] > 0.05:
                print(f"{field}, w = {width} m: the straight map leaves {straight['uncovered_m2']} m²", file=sys.stderr)


def paper_table(maps):
    columns = ["tracks", "length, m", "overlap, m²", "uncovered, m²"]
    row(["field", "body, ha", "parallel: tracks", *columns[1:], "paper: tracks", *columns[1:]])
    print("|---|" + "--:|" * 9)
    for field in FIFTEEN:
        cells = []
        for tracks in ([], ["--tracks", "paper"]):
            plan = maps.map(field, 4, "--headlands", "1", "--obstacle-headlands", "1", *KINDS["curved"], *tracks)
            cells = cells or [f"{plan['body_m2'] / 1e4:.2f}" if plan else "–"]
            cells += ([plan["tracks"], f"{plan['track_length_m']:.0f}", f"{plan['overlap_m2']:.0f}",
                       f"{plan['uncovered_m2']:.1f}"] if plan else ["–"] * 4)
        row([field, *cells])


TABLES = {"time": time_table, "sums": sums_table, "paper": paper_table}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", default=os.environ.get("TRAMLINE_DATA", ""))
    parser.add_argument("--tramline", default=str(ROOT / "build/release/apps/tramline/tramline"))
    parser.add_argument("tables", nargs="*", metavar="table", help=", ".join(TABLES))
    options = parser.parse_args()
    wrong = [name for name in options.tables if name not in TABLES]
    if wrong:
        parser.error(f"there is no table {', '.join(wrong)}; choose among {', '.join(TABLES)}")
    fields = Path(options.data) / "fields" / "fields.geojson"
    if not options.data or not fields.exists():
        print("no real fields; set TRAMLINE_DATA to the folder with fields/fields.geojson")
        return
    maps = Maps(options.tramline, str(fields))
    for name in options.tables or TABLES:
        TABLES[name](maps)
        print()


if __name__ == "__main__":
    main()
