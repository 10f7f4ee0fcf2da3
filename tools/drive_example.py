#!/usr/bin/env python3
"""Drives the example field: writes examples/riverside-drive.csv, the log of an imagined sprayer.

The tracks are those of `tramline plan`, 12 m wide. The driver steers by hand, switches the work on late and off late,
leaves one track out, and two of the eight nozzle groups are blocked for a while.

    tools/drive_example.py TRAMLINE [FOLDER]        (default: examples/)
"""

import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

WIDTH_M, SECTIONS, SPEED_MPS, RADIUS_M = 12, 8, 2.4, 6
EARTH_M = 6371000.0
LEFT_OUT = 9  # the track that is forgotten, by order
BLOCKED = range(14, 16)  # the tracks on which sections 6 and 7 spray nothing
LATE_ON_M, LATE_OFF_M = 3.0, 2.0


def planned_tracks(tramline, field):
    with tempfile.TemporaryDirectory() as folder:
        plan, tracks = f"{folder}/plan.gpkg", f"{folder}/tracks.geojson"
        subprocess.run([tramline, "plan", field, "--width", str(WIDTH_M), "--radius", str(RADIUS_M), "-o", plan, "--quiet"], check=True)
        subprocess.run([tramline, "export", plan, "-o", tracks, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        features = json.load(open(tracks))["features"]
    return [f["geometry"]["coordinates"] for f in sorted(features, key=lambda f: f["properties"]["order"])]


def at_distances(line, first, step):
    """Places along a polyline every `step` metres from `first` on, and the way left over."""
    places, left = [], first
    for (x0, y0), (x1, y1) in zip(line, line[1:]):
        length = math.hypot(x1 - x0, y1 - y0)
        while left <= length:
            places.append((x0 + (x1 - x0) * left / length, y0 + (y1 - y0) * left / length))
            left += step
        left -= length
    return places


def stretched(line, metres):
    (x0, y0), (x1, y1) = line[-2], line[-1]
    length = math.hypot(x1 - x0, y1 - y0)
    return line[:-1] + [(x1 + (x1 - x0) * metres / length, y1 + (y1 - y0) * metres / length)]


def drive(tracks):
    """Fixes (x, y, working sections), one a second."""
    chance = random.Random(7)
    fixes, wander = [], 0.0
    for order, track in enumerate(tracks, 1):
        if order == LEFT_OUT:
            continue
        length = sum(math.dist(a, b) for a, b in zip(track, track[1:]))
        track = stretched(track, 8.0)
        (x0, y0), (x1, y1) = track[0], track[1]
        across = ((y0 - y1) / math.dist(track[0], track[1]), (x1 - x0) / math.dist(track[0], track[1]))
        for i, (x, y) in enumerate(at_distances(track, chance.uniform(0, SPEED_MPS), SPEED_MPS)):
            wander = 0.9 * wander + chance.gauss(0, 0.09)
            on = LATE_ON_M <= i * SPEED_MPS <= length + LATE_OFF_M
            sections = ["1" if on else "0"] * SECTIONS
            if order in BLOCKED and length * 0.3 < i * SPEED_MPS < length * 0.7:
                sections[5] = sections[6] = "0"
            fixes.append((x + wander * across[0], y + wander * across[1], "".join(sections)))
    return fixes


def main():
    tramline = sys.argv[1]
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else "examples")
    tracks = planned_tracks(tramline, str(folder / "riverside.geojson"))
    lon0, lat0 = tracks[0][0]
    metres = math.radians(1) * EARTH_M
    squeeze = math.cos(math.radians(lat0))
    flat = [[((lon - lon0) * metres * squeeze, (lat - lat0) * metres) for lon, lat in track] for track in tracks]
    with open(folder / "riverside-drive.csv", "w", encoding="ascii") as out:
        out.write("time,lon,lat,speed_mps,width_m,sections\n")
        for i, (x, y, sections) in enumerate(drive(flat)):
            clock = f"2026-05-06T{8 + i // 3600:02d}:{i // 60 % 60:02d}:{i % 60:02d}Z"
            lon, lat = lon0 + x / metres / squeeze, lat0 + y / metres
            out.write(f"{clock},{lon:.8f},{lat:.8f},{SPEED_MPS},{WIDTH_M},{sections}\n")


if __name__ == "__main__":
    main()
