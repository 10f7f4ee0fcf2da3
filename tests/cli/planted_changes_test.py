#!/usr/bin/env python3
"""Plants one change after another into a plan file: `tramline check` has to find it, or to say that it does not
verify the figure. The table is the list of what the verifier believes: a new column or key gets a row.

usage: planted_changes_test.py --tramline PROGRAM --examples FOLDER [--every-plan]

Each change is planted into the first plan that it changes; with --every-plan into all of them.
"""
import argparse
import json
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

FOUND = "found"


def key(name, value):
    """Sets a key of the table metadata. `value`: SQL, in which `value` is the old one."""
    return f"UPDATE metadata SET value = {value} WHERE key = '{name}'"


def where_above_0(name):
    """Restricts a change of a key to plans in which another one is above 0."""
    return f" AND (SELECT CAST(value AS REAL) FROM metadata WHERE key = '{name}') > 0"


def row(layer, assignment, where="fid = (SELECT min(fid) FROM {layer})"):
    return f"UPDATE {layer} SET {assignment} WHERE " + where.format(layer=layer)


COST = "(SELECT value FROM metadata WHERE key = 'cost')"

FIGURES = "overlap_m2, uncovered_m2, turns, stops, crossings, tracks, track_length_m, worked_m2, cost"

# (what, SQL, FOUND or the name that has to be among those not verified)
CHANGES = [
    ("bound above the cost", key("proof.bound", f"{COST} * 1.01"), FOUND),
    ("bound equal to the cost", key("proof.bound", COST), "proof.bound"),
    ("a plan made here said to be of given lines", "INSERT INTO metadata (key, value) VALUES ('origin', 'lines')",
     "origin"),
    ("bound raised a little", key("proof.bound", f"{COST} * 0.9"), "proof.bound"),
    ("negative bound", key("proof.bound", "'-1'"), FOUND),
    ("one-direction bound above its cost",
     key("proof.one_direction_bound", "(SELECT value + 1 FROM metadata WHERE key = 'proof.one_direction_cost')"),
     FOUND),
    ("one-direction bound equal to its cost",
     key("proof.one_direction_bound", "(SELECT value FROM metadata WHERE key = 'proof.one_direction_cost')"),
     "proof.one_direction_bound"),
    ("negative one-direction bound", key("proof.one_direction_bound", "'-0.5'"), FOUND),
    ("one-direction cost below the bound", key("proof.one_direction_cost", "'0.001'") + where_above_0("proof.bound"),
     FOUND),
    ("one-direction cost raised", key("proof.one_direction_cost", "value + 1"), "proof.one_direction_cost"),
    ("directions tried", key("directions_tried", "value + 1"), "directions_tried"),
    ("cost lowered", key("cost", "value * 0.999"), FOUND),
    ("price of overlap lowered", key("objective.overlap", "value * 0.9"), FOUND),
    ("price of uncovered land lowered", key("objective.uncovered", "value * 0.9"), FOUND),
    ("price of a turn lowered", key("objective.turn", "value * 0.9"), FOUND),
    ("price of a stop lowered", key("objective.stop", "value * 0.9") + where_above_0("tally.stops"), FOUND),
    ("price of a turn negative", key("objective.turn", "'-1'"), FOUND),
    ("price of a subfield lowered", key("objective.subfield", "value * 0.9"), "objective.subfield"),
    ("worked area", key("tally.worked_m2", "value + 1"), FOUND),
    ("overlap", key("tally.overlap_m2", "value - 1"), FOUND),
    ("uncovered land", key("tally.uncovered_m2", "value - 1"), FOUND),
    ("track length", key("tally.track_length_m", "value - 1"), FOUND),
    ("pieces", key("tally.pieces", "value - 1"), FOUND),
    ("crossings", key("tally.crossings", "value + 1"), FOUND),
    ("turns", key("tally.turns", "value - 1"), FOUND),
    ("stops", key("tally.stops", "value - 1"), FOUND),
    ("subfields", key("tally.subfields", "value + 1"), FOUND),
    ("worked area of the tracks", key("track_tally.worked_m2", "value + 1"), FOUND),
    ("overlap of the tracks", key("track_tally.overlap_m2", "value - 1"), FOUND),
    ("uncovered body", key("track_tally.uncovered_m2", "value - 1"), FOUND),
    ("worked area of the headland", key("headland.worked_m2", "value + 1"), FOUND),
    ("overlap in the headland", key("headland.overlap_m2", "value - 1"), FOUND),
    ("uncovered headland", key("headland.uncovered_m2", "value + 1"), FOUND),
    ("headlands raised", key("settings.headlands", "'2'"), FOUND),
    ("headlands lowered", key("settings.headlands", "'0'"), FOUND),
    ("headlands of obstacles raised", key("settings.obstacle_headlands", "'3'"), "settings.obstacle_headlands"),
    ("headlands of obstacles lowered", key("settings.obstacle_headlands", "'0'"), "settings.obstacle_headlands"),
    ("passes round an obstacle", key("headland.obstacle_passes", "replace(value, '1', '0')"), FOUND),
    ("working width", key("machine.width_m", "'6.01'"), FOUND),
    ("turning radius lowered", key("machine.radius_m", "'5'"), "machine.radius_m"),
    ("least length lowered", key("machine.min_length_m", "'1'"), "machine.min_length_m"),
    ("edges in words", key("edges.exterior", "'soft and hard'"), FOUND),
    ("edges of obstacles in words", key("edges.obstacles", "'soft'"), FOUND),
    ("kind of the file", key("kind", "'repair'"), FOUND),
    ("degrees of a setting", key("settings.merge_threshold_deg", "'2'"), FOUND),
    ("warnings emptied", key("warnings", "'[]'"), FOUND),
    ("a figure in a warning", key("warnings", "replace(value, 'shorter than', 'shorter than 3 or')"), FOUND),
    ("repairs emptied", key("field.repairs", "'[]'"), "field.repairs"),
    ("strategy", key("settings.strategy", "'sweep'"), "settings.strategy"),
    ("search tolerance", key("settings.direction_tolerance_rad", "value * 1.0000000000000002"),
     "settings.direction_tolerance"),
    ("kind of a track", row("tracks", "kind = 'detour'"), FOUND),
    ("kind of a straight track: curved", row("tracks", "kind = 'curved'"), FOUND),
    ("heading", row("tracks", "heading_deg = heading_deg + 1"), FOUND),
    ("length of a track", row("tracks", "length_m = length_m + 1"), FOUND),
    ("smallest radius", row("tracks", "smallest_radius_m = 3"), FOUND),
    ("obstacles of a track", row("tracks", "obstacles = '1'"), FOUND),
    ("sides of a track", row("tracks", "sides = 'left'"), FOUND),
    ("stop at a start", row("tracks", "stop_at_start = 1 - stop_at_start"), FOUND),
    ("stop at an end", row("tracks", "stop_at_end = 1 - stop_at_end"), FOUND),
    ("crossing", row("tracks", "after_crossing = 1"), FOUND),
    ("order of tracks", row("tracks", "\"order\" = 900"), FOUND),
    ("width of a swath", row("swaths", "width_m = width_m + 0.01"), FOUND),
    ("area of a swath", row("swaths", "area_m2 = area_m2 + 1"), FOUND),
    ("overlap of a swath", row("swaths", "overlap_m2 = overlap_m2 + 1"), FOUND),
    ("overlap of a swath left out", row("swaths", "overlap_m2 = NULL"), "swaths.overlap_m2"),
    ("kind of an obstacle", row("obstacles", "kind = 'passable'"), FOUND),
    ("area of the field", row("field", "area_m2 = area_m2 + 1"), FOUND),
    ("area of the body", row("body", "area_m2 = area_m2 + 1"), FOUND),
    ("direction in degrees", row("subfields", "direction_deg = direction_deg + 1"), FOUND),
    ("direction in radians", row("subfields", "direction_rad = direction_rad + 0.01"), FOUND),
    ("number of a subfield", row("subfields", "number = 7"), FOUND),
    ("number of a pass", row("headland_passes", "number = 2"), FOUND),
    ("length of a pass", row("headland_passes", "length_m = length_m + 1"), FOUND),
    ("radius of a pass", row("headland_passes", "smallest_radius_m = 1"), FOUND),
    ("overlap layer emptied", "DELETE FROM overlap", FOUND),
    ("uncovered layer emptied", "DELETE FROM uncovered", FOUND),
    ("unworked headland emptied", "DELETE FROM headland_unworked", FOUND),
    ("a swath left out", "DELETE FROM swaths WHERE fid = 1", FOUND),
    ("a track left out", "DELETE FROM tracks WHERE fid = 1", FOUND),
    ("dropped pieces left out", "DELETE FROM dropped", "dropped"),
    ("cost of a way", row("encounters", "cost_left = cost_left + 1", "cost_left IS NOT NULL AND chosen <> 'left'"),
     "encounters.cost_left"),
    ("cost of the other way", row("encounters", "cost_right = cost_right + 1", "chosen <> 'right'"),
     "encounters.cost_right"),
    ("a way cheaper than the chosen one", row("encounters", "cost_left = -50, why_not_left = ''", "chosen <> 'left'"),
     FOUND),
    ("the chosen way", row("encounters", "chosen = CASE chosen WHEN 'cut' THEN 'left' ELSE 'cut' END"), FOUND),
    ("number of an encounter", row("encounters", "number = 99"), FOUND),
    ("front: overlap", row("front", "overlap_m2 = overlap_m2 - 1", "number = 2"), FOUND),
    ("front: uncovered land", row("front", "uncovered_m2 = uncovered_m2 - 1", "number = 2"), FOUND),
    ("front: turns", row("front", "turns = turns - 1", "number = 2"), FOUND),
    ("front: stops", row("front", "stops = stops + 1", "number = 2"), FOUND),
    ("front: tracks", row("front", "tracks = tracks + 1", "number = 2"), FOUND),
    ("front: length", row("front", "track_length_m = track_length_m - 1", "number = 2"), FOUND),
    ("front: worked area", row("front", "worked_m2 = worked_m2 + 1", "number = 2"), FOUND),
    ("front: cost", row("front", "cost = cost * 0.99", "number = 2"), FOUND),
    ("front: marks", row("front", "marks = ''", "marks <> ''"), FOUND),
    ("front: a plan like the one before",
     row("front", f"({FIGURES}) = (SELECT {FIGURES} FROM front WHERE number = 1)", "number = 2"), FOUND),
    ("front: directions", row("front", "direction_rad = '[0.5]'", "number = 2"), FOUND),
    ("front: degrees", row("front", "direction_deg = '[1]'", "number = 2"), FOUND),
    ("front: prices", row("front", "laid_for_turn = 9", "number = 2"), "front.laid_for"),
    ("front: number", row("front", "number = 77", "number = 2"), FOUND),
    ("route: a leg is missing", "DELETE FROM route_legs WHERE seq = 3", FOUND),
    ("route: a leg comes twice", row("route_legs", "seq = 3", "seq = 5"), FOUND),
    ("route: what a leg is", row("route_legs", "kind = 'transit'", "seq = 1"), FOUND),
    ("route: work off on a track", row("route_legs", "work = 0", "seq = 1"), FOUND),
    ("route: work on in a turn", row("route_legs", "work = 1", "seq = 2"), FOUND),
    ("route: gear", row("route_legs", "gear = 'reverse'", "seq = 2"), FOUND),
    ("route: another piece", row("route_legs", "piece = 2", "seq = 1"), FOUND),
    ("route: length of a leg", row("route_legs", "length_m = length_m + 0.1", "seq = 2"), FOUND),
    ("route: time of a leg", row("route_legs", "time_s = time_s - 1", "seq = 1"), FOUND),
    ("route: room that is there", row("route_legs", "missing_m = 3", "seq = 2"), FOUND),
    ("route: stretches of another leg",
     "UPDATE route_legs SET stretches = (SELECT stretches FROM route_legs WHERE seq = 2) WHERE seq = 4", FOUND),
    ("route: bound raised", key("route.bound_s", "value + 10"), FOUND),
    ("route: bound above the time", key("route.bound_s", "value * 2"), FOUND),
    ("route: what a stop counts raised", key("route.stop_s", "value + 10"), FOUND),
    # Along edges of worked land and of the body, metres may belong to either side.
    ("route: over worked land", key("route.over_worked_m", "value + 500"), FOUND),
    ("route: over unworked land", key("route.over_unworked_m", "'0'"), FOUND),
    ("route: over land of tracks", key("route.over_tracks_m", "value + 500"), FOUND),
    ("route: end at another place", key("settings.route.end", "'40 40'"), FOUND),
    ("route: speed at work", key("machine.working_speed_mps", "'2'"), FOUND),
    ("route: speed of turns", key("machine.turning_speed_mps", "'3'"), FOUND),
    ("whole cost: euros lowered", key("whole_cost.euros", "value * 0.999"), FOUND),
    ("whole cost: hours lowered", key("whole_cost.hours", "value * 0.999"), FOUND),
    ("whole cost: litres lowered", key("whole_cost.litres", "value * 0.999"), FOUND),
    ("whole cost: price of an hour raised", key("whole_cost.rates.price_per_hour", "value + 1"), FOUND),
    ("whole cost: fuel an hour", key("whole_cost.rates.fuel_l_per_h", "value + 1"), FOUND),
    ("whole cost: price of fuel", key("whole_cost.rates.fuel_price", "value * 0.9"), FOUND),
    ("whole cost: sections", key("whole_cost.rates.sections", "value + 1"), FOUND),
    ("whole cost: input", key("whole_cost.rates.input_price_per_ha", "value * 0.9"), FOUND),
    ("whole cost: margin", key("whole_cost.rates.margin_per_ha", "value * 0.9"), FOUND),
    ("whole cost: price of a stop", key("whole_cost.rates.price_per_stop", "value + 1"),
     "whole_cost.rates.price_per_stop"),
    ("whole cost: operation", key("whole_cost.rates.operation", "'mowing'"), FOUND),
    ("operation of the machine", key("machine.operation", "'seeding'"), FOUND),
    ("sections of the machine", key("machine.sections", "'8'"), FOUND),
]


def plans(tramline, examples, folder):
    """One with a front and tracks that stop, one with headlands, and one with a route from end to end: a change is
    planted where it changes anything."""
    wanted = [("front", "riverside.geojson", ["--width", "6", "--front"]),
              ("headlands", "riverside.geojson",
               ["--width", "12", "--headlands", "1", "--obstacle-headlands", "1", "--prices", "0.02,0.10,1,5,5"]),
              ("route", "plain-metres.gpkg",
               ["--width", "6", "--end", "20,20", "--operation", "spraying", "--sections", "4"])]
    for name, field, options in wanted:
        subprocess.run([tramline, "plan", str(examples / field), "--radius", "6", "--quiet", "-o",
                        str(folder / f"{name}.gpkg"), *options], check=True, stdout=subprocess.DEVNULL)
    return [folder / f"{name}.gpkg" for name, _, _ in wanted]


def checked(tramline, plan):
    run = subprocess.run([tramline, "check", str(plan), "--json"], capture_output=True, text=True, check=False)
    return json.loads(run.stdout) if run.returncode in (0, 1) else None


def planted(plan, sql, folder):
    """A copy with the change, or None where it changes nothing."""
    copy = folder / "changed.gpkg"
    shutil.copy(plan, copy)
    with sqlite3.connect(copy) as file:
        file.execute("PRAGMA synchronous = OFF")
        file.execute("PRAGMA journal_mode = MEMORY")
        for trigger, in file.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
            file.execute(f'DROP TRIGGER "{trigger}"')
        words = sql.split()
        rows = f"SELECT * FROM {words[2] if words[0] in ('DELETE', 'INSERT') else words[1]}"
        try:
            before = file.execute(rows).fetchall()
        except sqlite3.OperationalError:
            return None  # not every plan has every table
        file.execute(sql)
        file.commit()
        return copy if file.execute(rows).fetchall() != before else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--examples", required=True, type=pathlib.Path)
    parser.add_argument("--every-plan", action="store_true")
    options = parser.parse_args()
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        originals = plans(options.tramline, options.examples, folder)
        for plan in originals:
            if not checked(options.tramline, plan)["ok"]:
                faults.append(f"{plan.name}: an honest plan does not hold")
        for what, sql, expected in CHANGES:
            copies = 0
            for plan in originals:
                if copies > 0 and not options.every_plan:
                    break
                copy = planted(plan, sql, folder)
                if copy is None:
                    continue
                copies += 1
                verdict = checked(options.tramline, copy)
                if verdict is None or not verdict["ok"]:
                    continue  # refused or found
                if expected == FOUND or expected not in verdict["not_verified"]:
                    faults.append(f"{plan.name}: {what}: holds")
            if copies == 0:
                faults.append(f"{what}: changes nothing in any plan")
    for fault in faults:
        print(fault)
    print(f"{len(CHANGES)} changes, {len(faults)} not caught")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
