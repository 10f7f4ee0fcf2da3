"""Layers of a plan in plain metres, which no GeoJSON file may hold: its coordinates are longitude and latitude."""

from __future__ import annotations

import sqlite3
import struct
from contextlib import closing
from typing import Any

# Bytes of the envelope in a GeoPackage's header, by its kind (GeoPackage 1.3, section 2.1.3).
_ENVELOPE_BYTES = (0, 32, 48, 48, 64)
_POINT, _LINE, _POLYGON = 1, 2, 3


def plain_features(plan_file: str, layer: str) -> dict[str, Any]:
    """The layer as a feature collection in the coordinates of the file."""
    with closing(sqlite3.connect(f"file:{plan_file}?mode=ro", uri=True)) as file:
        file.row_factory = sqlite3.Row
        (column,) = file.execute("SELECT column_name FROM gpkg_geometry_columns WHERE table_name = ?", (layer,)).fetchone()
        rows = file.execute(f'SELECT * FROM "{layer}"').fetchall()
    return {"type": "FeatureCollection", "features": [_feature(row, column) for row in rows]}


def _feature(row: sqlite3.Row, column: str) -> dict[str, Any]:
    properties = {key: row[key] for key in row.keys() if key not in (column, "fid")}
    blob = row[column]
    geometry = None if blob is None else _geometry(blob[8 + _ENVELOPE_BYTES[(blob[3] >> 1) & 7] :])
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def _geometry(wkb: bytes) -> dict[str, Any]:
    """Of the three kinds that plan files have."""
    order = "<" if wkb[0] == 1 else ">"
    (kind,) = struct.unpack_from(order + "I", wkb, 1)
    if kind == _POINT:
        return {"type": "Point", "coordinates": list(struct.unpack_from(order + "2d", wkb, 5))}
    if kind == _LINE:
        return {"type": "LineString", "coordinates": _points(wkb, order, 5)[0]}
    assert kind == _POLYGON
    (count,) = struct.unpack_from(order + "I", wkb, 5)
    rings, at = [], 9
    for _ in range(count):
        ring, at = _points(wkb, order, at)
        rings.append(ring)
    return {"type": "Polygon", "coordinates": rings}


def _points(wkb: bytes, order: str, at: int) -> tuple[list[list[float]], int]:
    (count,) = struct.unpack_from(order + "I", wkb, at)
    numbers = struct.unpack_from(f"{order}{2 * count}d", wkb, at + 4)
    return [list(pair) for pair in zip(numbers[::2], numbers[1::2])], at + 4 + 16 * count
