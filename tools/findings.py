#!/usr/bin/env python3
"""Prints the tables of docs/findings.md: the findings of Versleijen 2019, measured anew.

    tools/findings.py [--data DIR] [--tramline PATH] [--threads N]

Every plan follows Versleijen: its strategy, swaths ended where their centre line meets the edge, its rule at obstacles,
3 m wide, turning radius 6 m. The real fields are in DIR/fields/fields.geojson (default for DIR: $TRAMLINE_DATA);
without that file only the example fields are planned.
"""

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from plan_shapes import measure

ROOT = Path(__file__).resolve().parent.parent
VERSLEIJEN = ["--strategy", "sweep", "--end-rule", "centre", "--width", "3"]
# Weights of overlap (1/m²), uncovered (1/m²), a turn and a stop: Versleijen table 2, where stops cost nothing.
SCENARIOS = {"1": "99999,1,1,0", "2": "1,99999,1,0", "3": "1,1,99999,0"}
PURE = {"overlap only": "1,0,0,0", "uncovered only": "0,1,0,0", "turns only": "0,0,1,0"}
EXAMPLES = {"roadside": ["examples/roadside.geojson"],
            "oak-field": ["examples/two-farms.gpkg", "--layer", "parcels", "--where", "id='oak-field'"]}
REAL = ["de-sh/39", "cz/58", "de-sh/4"]
SIZES_M2 = (1e4, 22e4)  # Versleijen's kind of field


class Planner:
    def __init__(self, program, threads, folder):
        self.program, self.threads, self.file = program, threads, str(Path(folder) / "plan.gpkg")

    def plan(self, field, weights, merge=0, decomposition=180, radius=6, avoid="paper"):
        command = [self.program, "plan", *field, *VERSLEIJEN, "--weights", weights, "--merge", str(merge), "--decomposition",
                   str(decomposition), "--radius", str(radius), "--avoid", avoid, "--threads", str(self.threads)]
        run = subprocess.run(command + ["--json", "-o", self.file], cwd=ROOT, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"findings.py: {' '.join(command)}\n{run.stderr}")
        return {**json.loads(run.stdout), **measure(self.file, decomposition)}


def table(title, head, rows):
    print(f"\n{title}\n\n| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)


def figures(plan):
    return [f"{plan['overlap_pct']:.2f}", f"{plan['uncovered_pct']:.2f}", str(plan["turns"]), str(plan["subfields"])]


HEAD = ["overlap %", "uncovered %", "turns", "subfields"]


def angle(plan):
    return f"{plan['angle']:.0f}°"


def series(planner, fields, title, option, values, extra, **settings):
    """Scenario 3 on every field, one setting at different values; values with the same figures share a row."""
    rows = []
    for name, field in fields.items():
        for value in values:
            plan = planner.plan(field, SCENARIOS["3"], **{option: value}, **settings)
            row = [name, str(value), *figures(plan), extra(plan)]
            if rows and rows[-1][0] == name and rows[-1][2:6] == row[2:6]:
                rows[-1][1] += ", " + row[1]
                rows[-1][6] += ", " + row[6] if row[6] != rows[-1][6].split(", ")[-1] else ""
            else:
                rows.append(row)
    table(title[0], ["field", title[1], *HEAD, title[2]], rows)


def tables(planner, fields):
    plans = {name: planner.plan(field, SCENARIOS["3"]) for name, field in fields.items()}
    table("Fields", ["field", "area ha", "obstacles", "longest edge m", "extent along it m", "extent across it m"],
          [[name, f"{p['area_m2'] / 1e4:.1f}", str(p["obstacles"]),
            *(f"{p[key]:.0f}" for key in ("edge_m", "along_m", "across_m"))] for name, p in plans.items()])
    for merge, decomposition in ((0, 180), (15, 205)):
        rows = []
        for name, field in fields.items():
            for number, weights in SCENARIOS.items():
                plan = planner.plan(field, weights, merge, decomposition)
                rows.append([name, number, *figures(plan), angle(plan), f"{plan['reach_m']:.0f}"])
        table(f"Scenarios, merge threshold {merge}°, decomposition threshold {decomposition}°",
              ["field", "scenario", *HEAD, "main tracks to longest edge", "extent along main tracks m"], rows)
    series(planner, fields, ("Merge threshold", "merge °", "main tracks to longest edge"), "merge", (0, 15, 30, 60),
           angle)
    series(planner, fields, ("Decomposition threshold", "decomposition °", "corners above"), "decomposition",
           (180, 205, 230, 255), lambda plan: str(plan["corners"]))
    for avoid in ("paper", "cheapest"):
        series(planner, fields, (f"Turning radius, --avoid {avoid}", "radius m", "detours"), "radius", (3, 6, 9, 12),
               lambda plan: str(plan["detours"]), avoid=avoid)
    objectives = {**{f"scenario {n}": w for n, w in SCENARIOS.items()}, **PURE}
    table("Angle between the main subfield's tracks and the longest edge", ["field", *objectives],
          [[name, *(angle(planner.plan(field, w)) for w in objectives.values())] for name, field in fields.items()])


def census(planner, fields):
    """How many real fields follow the finding: above 45° from the longest edge in scenarios 1 and 2, below in 3."""
    plans = {i: [planner.plan(field, w) for w in SCENARIOS.values()] for i, field in fields.items()}

    def row(name, group):
        across = [sum(p[s]["angle"] > 45 for p in group) for s in range(3)]
        both = sum(p[0]["angle"] > 45 > p[2]["angle"] for p in group)
        shorter = sum(p[0]["reach_m"] < p[2]["reach_m"] - 1 for p in group)
        same = sum(len({round(one["angle"], 3) for one in p}) == 1 for p in group)
        return [name, *map(str, (len(group), *across, both, shorter, same))]

    bands = (("below 1", 0, 1), ("1 to 1.5", 1, 1.5), ("1.5 to 2.5", 1.5, 2.5), ("above 2.5", 2.5, math.inf))
    table("Real fields with obstacles, 1 to 22 ha: how many are driven across their longest edge",
          ["extent along : across the edge", "fields", "scenario 1", "scenario 2", "scenario 3", "1 across and 3 along",
           "extent along tracks shorter in 1 than in 3", "one direction in all three"],
          [row(name, [p for p in plans.values() if low <= p[0]["along_m"] / p[0]["across_m"] < high])
           for name, low, high in bands]
          + [row("all", list(plans.values()))])

    def middle(value):
        return f"{statistics.median(map(value, plans.values())):.2f}"

    table("The same fields: medians, and medians of the ratio to scenario 3",
          ["scenario", "overlap %", "uncovered %", "overlap", "uncovered", "turns"],
          [[str(s + 1), middle(lambda p: p[s]["overlap_pct"]), middle(lambda p: p[s]["uncovered_pct"]),
            *(middle(lambda p: p[s][key] / p[2][key]) for key in ("overlap_m2", "uncovered_m2", "turns"))]
           for s in range(3)])
    return plans


def percent(changes):
    return f"{100 * statistics.median(changes):+.0f} %" if changes else "–"


def thresholds(planner, fields, usual):
    """What thresholds do to the area or number that a scenario minimises, over many fields."""
    rows = []
    for number, factor in (("1", "overlap_m2"), ("3", "turns")):
        for option, values in (("merge", (15, 30, 60)), ("decomposition", (205, 230, 255))):
            for value in values:
                changes, fewer = [], 0
                for name, field in fields.items():
                    before = usual[name][int(number) - 1]
                    after = planner.plan(field, SCENARIOS[number], **{option: value})
                    changes.append(after[factor] / before[factor] - 1)
                    fewer += after["subfields"] < before["subfields"]
                less, more = [c for c in changes if c < -1e-6], [c for c in changes if c > 1e-6]
                rows.append([number, f"{option} {value}°", str(len(less)), percent(less),
                             str(len(changes) - len(less) - len(more)), str(len(more)), percent(more), str(fewer)])
    table("The same fields: what is minimised (1: overlap, 3: turns), against 0° and 180°",
          ["scenario", "setting", "less", "by (median)", "same", "more", "by (median)", "fewer subfields"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--data", type=Path, default=os.environ.get("TRAMLINE_DATA"), help="default: $TRAMLINE_DATA")
    parser.add_argument("--tramline", default=str(ROOT / "build/release/apps/tramline/tramline"))
    parser.add_argument("--threads", type=int, default=0, help="threads to use (default: all cores)")
    arguments = parser.parse_args()
    fields, many = dict(EXAMPLES), {}
    file = Path(arguments.data).resolve() / "fields/fields.geojson" if arguments.data else None
    if file is None or not file.exists():
        print("real fields skipped:", f"{file} is not there" if file else "neither --data nor TRAMLINE_DATA is set",
              file=sys.stderr)
    else:
        sizes = {p["id"]: p["area_m2"] * (p["n_holes"] > 0)
                 for p in (feature["properties"] for feature in json.loads(file.read_text())["features"])}
        many = {i: [str(file), "--where", f"id='{i}'"] for i, m2 in sizes.items() if SIZES_M2[0] <= m2 <= SIZES_M2[1]}
        fields.update({i: many[i] for i in REAL})
    with tempfile.TemporaryDirectory() as scratch:
        planner = Planner(str(Path(arguments.tramline).resolve()), arguments.threads, scratch)
        tables(planner, fields)
        if many:
            thresholds(planner, many, census(planner, many))


if __name__ == "__main__":
    main()
