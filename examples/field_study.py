#!/usr/bin/python3
"""How much do the driving direction and the working width matter? A study of twenty fields.

    python3 examples/field_study.py -o out/study

For each field the script plans tracks along the best direction, along the longest side, and along directions 15° apart, and does so
for three widths. It writes study.csv, a row for each plan, and two plots: what a direction costs above the best one, and what is worked
twice or missed by field and width. Money is counted at 2 ct a m² worked twice, 10 ct a m² missed and 1 € a turn.

Needs the package tramline (docs/python.md), and Debian's python3-shapely, python3-geopandas and python3-matplotlib.
"""

from __future__ import annotations

import argparse
import math
import pathlib
from concurrent.futures import ThreadPoolExecutor

import matplotlib
import pandas
import shapely.affinity
import shapely.geometry as sg

import tramline

matplotlib.use("Agg")  # files alone, no windows
import matplotlib.pyplot as plt  # noqa: E402

WIDTHS_M = (6, 12, 24)
ANGLES_DEG = range(0, 180, 15)
PRICES = (0.02, 0.10, 1)


def drawn_fields() -> dict[str, sg.Polygon]:
    """Twenty fields in plain metres: four of each of five kinds, 0.8 to 8.6 ha, turned so that no side runs north by chance."""
    fields = {}
    for number in range(4):
        long, short = 180 + 60 * number, 70 + 35 * number
        fields[f"rectangle {number + 1}"] = sg.box(0, 0, long, short)
        fields[f"wedge {number + 1}"] = sg.Polygon([(0, 0), (long, 0), (long - 20 * number, short), (0, short / 3)])
        # Two arms at right angles.
        fields[f"corner {number + 1}"] = sg.box(0, 0, long, short).union(sg.box(0, 0, short, long * 0.8))
        # A straight road below, a bend of a stream above.
        bend = [(long * k / 12, short + 25 * (number + 1) * math.sin(math.pi * k / 12)) for k in range(12, -1, -1)]
        fields[f"stream {number + 1}"] = sg.Polygon([(0, 0), (long, 0), *bend])
        pond = sg.Point(long * 0.6, short * 0.45).buffer(8 + 4 * number, 8)
        ragged = sg.Polygon([(0, 0), (long * 0.5, -15), (long, 10), (long * 0.9, short), (long * 0.4, short + 20), (-10, short * 0.8)])
        fields[f"pond {number + 1}"] = ragged.difference(pond)
    return {name: shapely.affinity.rotate(shape, 17 + 23 * k, origin=(0, 0)) for k, (name, shape) in enumerate(sorted(fields.items()))}


def longest_side(field: sg.Polygon) -> tuple[tuple[float, float], tuple[float, float]]:
    corners = list(field.exterior.coords)
    return max(zip(corners, corners[1:]), key=lambda side: math.dist(*side))


def line_at(angle_deg: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """A line in this direction, clockwise from north."""
    angle = math.radians(angle_deg)
    return (0.0, 0.0), (1000 * math.sin(angle), 1000 * math.cos(angle))


def studied(name: str, field: sg.Polygon, width_m: float, direction: str, ab) -> dict[str, object]:
    """A row of the table; `ab` is None where the planner chooses."""
    plan = tramline.plan(field, name=name, width=width_m, prices=PRICES, ab=ab, threads=1)
    return {
        "field": name,
        "width_m": width_m,
        "direction": direction,
        "direction_deg": plan.directions_deg[0],
        "subfields": plan.subfields,
        "area_ha": plan.area_m2 / 1e4,
        "turns": plan.turns,
        "overlap_m2": plan.overlap_m2,
        "uncovered_m2": plan.uncovered_m2,
        "euros_per_ha": plan.cost / plan.area_m2 * 1e4,
    }


def study(fields: dict[str, sg.Polygon]) -> pandas.DataFrame:
    tasks = []
    for name, field in fields.items():
        for width_m in WIDTHS_M:
            tasks.append((name, field, width_m, "best", None))
            tasks.append((name, field, width_m, "longest side", longest_side(field)))
            tasks += [(name, field, width_m, f"{angle}°", line_at(angle)) for angle in ANGLES_DEG]
    # The package lets other threads run while it plans.
    with ThreadPoolExecutor() as pool:
        return pandas.DataFrame(list(pool.map(lambda task: studied(*task), tasks)))


def draw_directions(table: pandas.DataFrame, file: pathlib.Path) -> None:
    """What each direction costs above the best plan, over the angle to the longest side."""
    figure, axes = plt.subplots(1, len(WIDTHS_M), figsize=(12, 4))
    for axis, width_m in zip(axes, WIDTHS_M):
        of_width = table[table.width_m == width_m]
        for _, rows in of_width.groupby("field"):
            by_direction = rows.set_index("direction")
            best = by_direction.loc["best", "euros_per_ha"]
            side = by_direction.loc["longest side", "direction_deg"]
            swept = by_direction.loc[[f"{angle}°" for angle in ANGLES_DEG]]
            apart = [min((angle - side) % 180, (side - angle) % 180) for angle in swept.direction_deg]
            axis.plot(*zip(*sorted(zip(apart, swept.euros_per_ha - best))), color="0.6", linewidth=0.8)
        axis.set(title=f"{width_m} m wide", xlabel="angle to the longest side, °", xlim=(0, 90), xticks=range(0, 91, 15))
    axes[0].set_ylabel("€ per ha above the best plan")
    figure.tight_layout()
    figure.savefig(file)
    plt.close(figure)


def draw_widths(table: pandas.DataFrame, file: pathlib.Path) -> None:
    """Land worked twice or missed in the best plan, by field and width."""
    best = table[table.direction == "best"].copy()
    best["percent"] = (best.overlap_m2 + best.uncovered_m2) / (best.area_ha * 100)
    axis = best.pivot(index="field", columns="width_m", values="percent").plot.bar(figsize=(12, 4.5), width=0.8)
    axis.set(xlabel="", ylabel="worked twice or missed, % of the field")
    axis.legend([f"{width_m} m" for width_m in WIDTHS_M], title="working width")
    axis.figure.tight_layout()
    axis.figure.savefig(file)
    plt.close(axis.figure)


def summary(table: pandas.DataFrame) -> str:
    lines = ["width   best   longest side   at random   fields where the longest side costs 10 % more"]
    for width_m, rows in table.groupby("width_m"):
        best = rows[rows.direction == "best"].set_index("field").euros_per_ha
        side = rows[rows.direction == "longest side"].set_index("field").euros_per_ha
        swept = rows[rows.direction.str.endswith("°")].euros_per_ha
        lines.append(
            f"{width_m:3d} m  {best.mean():5.1f}   {side.mean():12.1f}   {swept.mean():9.1f}   {(side > 1.1 * best).sum()} of {len(best)}"
        )
    return "\n".join([*lines, "(means over the fields, € per ha)"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("study"), help="folder of table and plots")
    parser.add_argument("--fields", type=int, default=20, help="take the first so many fields alone")
    asked = parser.parse_args()
    asked.output.mkdir(parents=True, exist_ok=True)
    table = study(dict(list(drawn_fields().items())[: asked.fields]))
    table.to_csv(asked.output / "study.csv", index=False)
    draw_directions(table, asked.output / "directions.png")
    draw_widths(table, asked.output / "widths.png")
    print(summary(table))


if __name__ == "__main__":
    main()
