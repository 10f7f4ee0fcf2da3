"""A field that can be worked out by hand: 200 m from west to east by 100 m from south to north, its south-western corner at
52° N, 9° E."""

import json
import math

# Radii of curvature of WGS 84 at 52°: 6,375,150 m along the meridian and 6,391,435 m across it.
LAT_DEGREE_M = 111267.35
LON_DEGREE_M = 68678.02


def place(east_m, north_m):
    return (9 + east_m / LON_DEGREE_M, 52 + north_m / LAT_DEGREE_M)


def write_field(path, name, east_m=0):
    corners = [place(east_m + x, y) for x, y in ((0, 0), (200, 0), (200, 100), (0, 100), (0, 0))]
    feature = {"type": "Feature", "properties": {"id": name}, "geometry": {"type": "Polygon", "coordinates": [corners]}}
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))


def convergence_deg(east_m):
    """By how much true north turns over so many metres to the east, to the left."""
    return east_m / LON_DEGREE_M * math.sin(math.radians(52))
