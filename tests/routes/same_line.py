"""Is the line that another program read the same one?"""

import math
import subprocess

EARTH_M = 6371008.8


def run(*args):
    return subprocess.run(args, check=True, capture_output=True, text=True).stdout


class Plane:
    """Metres about a point, enough for the distances between two readings of one line."""

    def __init__(self, lon, lat):
        self.lon, self.lat = lon, lat
        self.across = math.radians(1) * EARTH_M * math.cos(math.radians(lat))

    def __call__(self, lonlat):
        return ((lonlat[0] - self.lon) * self.across, (lonlat[1] - self.lat) * math.radians(1) * EARTH_M)


def distance(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    share = 0 if square == 0 else max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square))
    return math.hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy)


def farthest(points, line, most):
    """The largest distance of the points from a line, both in driving order: each is looked for from where the last one was, and
    found at the first place that is near enough."""
    worst, at = 0.0, 0
    for p in points:
        nearest = (math.inf, at)
        for i in range(max(0, at - 3), min(len(line) - 1, at + 250)):
            nearest = min(nearest, (distance(p, line[i], line[i + 1]), i))
            if nearest[0] <= most:
                break
        worst, at = max(worst, nearest[0]), nearest[1]
    return worst
