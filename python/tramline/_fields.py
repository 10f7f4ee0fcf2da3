"""Whatever holds a field as what the C++ side reads: the name of a file, or features in memory."""

from __future__ import annotations

import json
import os
import re
import struct
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from . import _core
from ._core import InputError

_WKT = re.compile(
    r"\s*(?:SRID=(\d+);)?\s*((?:MULTI)?(?:POLYGON|SURFACE|LINESTRING|CURVE|POINT)|CURVEPOLYGON|GEOMETRYCOLLECTION)"
    r"\s*(?:Z|M|ZM)?\s*(?:\(|EMPTY)",
    re.IGNORECASE,
)
_HEX = re.compile(r"0[01][0-9a-fA-F]{8,}\Z")
_EWKB_SRID = 0x20000000


class Given(NamedTuple):
    """`file` names a file; or `features` are there, and `file` is what messages call them."""

    file: str
    features: _core.Features | None
    number: int = 0  # of features in memory


class _Shape(NamedTuple):
    bytes: bytes
    form: str
    id: str


def given(source: object, what: str, name: str | None = None) -> Given:
    """`what`: the word for it in messages. `name`: the id of a geometry that has none."""
    if isinstance(source, os.PathLike):
        return Given(_file_name(source), None)
    if isinstance(source, str):
        if not (_WKT.match(source) or _HEX.match(source)):
            return Given(source, None)
        return _in_memory(*_of_text(source, name or what), what)
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _in_memory(*_of_wkb(bytes(source), name or what), what)
    if isinstance(source, Sequence):
        return _of_sequence(source, what, name)
    wkb = getattr(source, "wkb", None)
    if isinstance(wkb, bytes):
        # A geometry of shapely, without the detour over texts.
        return _in_memory(*_of_wkb(wkb, name or what), what)
    interface = _interface(source)
    if interface is None:
        raise InputError(
            f"the {what} is a {type(source).__name__}; give a path, WKB, WKT or an object with __geo_interface__"
        )
    return _in_memory(_of_interface(interface, name or what), _crs_of(source), what)


def _file_name(source: os.PathLike[Any]) -> str:
    return os.fsdecode(os.fspath(source))


def _in_memory(shapes: list[_Shape], crs: str, what: str) -> Given:
    features = _core.features([(shape.bytes, shape.form, shape.id) for shape in shapes], crs, what)
    return Given(what, features, len(shapes))


def _of_text(source: str, name: str) -> tuple[list[_Shape], str]:
    found = _WKT.match(source)
    if found is None:
        return _of_wkb(bytes.fromhex(source), name)
    crs = f"EPSG:{found[1]}" if found[1] else ""
    return [_Shape(source[found.start(2) :].encode(), "wkt", name)], crs


def _of_wkb(source: bytes, name: str) -> tuple[list[_Shape], str]:
    wkb, crs = _without_srid(source)
    return [_Shape(wkb, "wkb", name)], crs


def _without_srid(source: bytes) -> tuple[bytes, str]:
    """Plain WKB, and the CRS that EWKB names, as PostGIS writes it; empty where it names none."""
    if len(source) < 9 or source[0] > 1:
        return source, ""
    order = "<" if source[0] == 1 else ">"
    kind, srid = struct.unpack(order + "II", source[1:9])
    if not kind & _EWKB_SRID:
        return source, ""
    return source[:1] + struct.pack(order + "I", kind & ~_EWKB_SRID) + source[9:], f"EPSG:{srid}" if srid else ""


def _of_sequence(source: Sequence[object], what: str, name: str | None) -> Given:
    """Several geometries, such as lines."""
    shapes: list[_Shape] = []
    for one in source:
        interface = _interface(one)
        if interface is None:
            raise InputError(f"the {what} is a {type(source).__name__} of other things than geometries")
        shapes += _of_interface(interface, name or what)
    return _in_memory(shapes, _crs_of(source[0]) if source else "", what)


def _interface(source: object) -> Mapping[str, Any] | None:
    found = source if isinstance(source, Mapping) else getattr(source, "__geo_interface__", None)
    return found if isinstance(found, Mapping) else None


def _of_interface(interface: Mapping[str, Any], name: str) -> list[_Shape]:
    kind = interface.get("type")
    if kind == "FeatureCollection":
        return [shape for feature in interface.get("features", ()) for shape in _of_interface(feature, name)]
    if kind != "Feature":
        return [_Shape(_json(interface), "geojson", name)]
    geometry = interface.get("geometry")
    if not isinstance(geometry, Mapping):
        raise InputError("a feature without a geometry is no field")
    properties = interface.get("properties")
    found = properties.get("id") if isinstance(properties, Mapping) else None
    own = found if found is not None else interface.get("id")
    return [_Shape(_json(geometry), "geojson", name if own is None else str(own))]


def _json(geometry: Mapping[str, Any]) -> bytes:
    try:
        return json.dumps(dict(geometry), default=_plain, allow_nan=False).encode()
    except (TypeError, ValueError) as fault:
        raise InputError(f"the geometry has coordinates that are no numbers: {fault}") from None


def _plain(value: Any) -> Any:
    """Arrays of numpy as lists, its numbers as numbers."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r}")


def _crs_of(source: object) -> str:
    """The CRS that a GeoSeries, GeoDataFrame or anything else with `crs` knows; empty where it knows none."""
    crs = getattr(source, "crs", None)
    if crs is None:
        return ""
    epsg = crs.to_epsg() if hasattr(crs, "to_epsg") else None
    if epsg is not None:
        return f"EPSG:{epsg}"
    return str(crs.to_wkt() if hasattr(crs, "to_wkt") else crs)
