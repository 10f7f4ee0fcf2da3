"""What the functions give back."""

from __future__ import annotations

import json
import os
import pathlib
import sqlite3
import tempfile
from collections.abc import Mapping
from contextlib import closing
from functools import cached_property
from typing import Any

from . import _core
from ._core import InputError
from ._plain_layer import plain_features


def _picture(draw: Any) -> str:
    with tempfile.TemporaryDirectory(prefix="tramline-") as folder:
        file = os.path.join(folder, "picture.svg")
        draw(file)
        with open(file, encoding="utf-8") as svg:
            return svg.read()


class Figures:
    """A result with the figures that the program prints with --json (docs/json.md)."""

    def _json(self) -> str:
        raise NotImplementedError

    @cached_property
    def figures(self) -> dict[str, Any]:
        """All figures by their keys."""
        out = json.loads(self._json())
        assert isinstance(out, dict)
        return out

    def __getitem__(self, key: str) -> Any:
        return self.figures[key]

    def _number(self, key: str) -> float:
        return float(self.figures[key])


class Plan(Figures):
    """A plan, with its figures in metres, square metres, seconds and euros."""

    def __init__(self, core: _core.Plan) -> None:
        self._core = core

    def _json(self) -> str:
        return self._core.json

    @property
    def field_id(self) -> str:
        return str(self.figures["field_id"])

    @property
    def crs(self) -> str | None:
        """The CRS in which the field was given; None for plain metres."""
        return self._core.crs or None

    @property
    def area_m2(self) -> float:
        """The land: the field less its obstacles."""
        return self._number("area_m2")

    @property
    def width_m(self) -> float:
        return self._number("width_m")

    @property
    def tracks(self) -> int:
        """Number of pieces of tracks."""
        return int(self.figures["tracks"])

    @property
    def track_length_m(self) -> float:
        return self._number("track_length_m")

    @property
    def turns(self) -> int:
        return int(self.figures["turns"])

    @property
    def stops(self) -> int:
        """Ends of tracks against an obstacle without headland."""
        return int(self.figures["stops"])

    @property
    def subfields(self) -> int:
        return int(self.figures["subfields"])

    @property
    def directions_deg(self) -> tuple[float, ...]:
        """Driving direction of each subfield, clockwise from north, from 0 to 180."""
        return tuple(self.figures["direction_deg"])

    @property
    def overlap_m2(self) -> float:
        return self._number("overlap_m2")

    @property
    def uncovered_m2(self) -> float:
        return self._number("uncovered_m2")

    @property
    def cost(self) -> float:
        """Of the tracks, in the unit of the weights; see `euros` for the whole route."""
        return self._number("cost")

    def _whole(self, key: str) -> float | None:
        whole = self.figures.get("whole_cost")
        return None if whole is None else float(whole[key])

    @property
    def euros(self) -> float | None:
        """What the whole route costs; None without a route."""
        return self._whole("euros")

    @property
    def litres(self) -> float | None:
        """Fuel of the whole route; None without a route."""
        return self._whole("litres")

    @property
    def time_s(self) -> float | None:
        """Of the whole route; None without a route."""
        route = self.figures.get("route")
        return None if route is None else float(route["time_s"])

    @property
    def route_length_m(self) -> float | None:
        route = self.figures.get("route")
        return None if route is None else float(route["length_m"])

    @property
    def cut_short(self) -> bool:
        """Whether the search was ended early."""
        return bool(self.figures["cut_short"])

    @property
    def warnings(self) -> list[str]:
        return list(self.figures["warnings"])

    @property
    def planned(self) -> Plan | None:
        """The plan that given lines were compared with; None unless price() was asked to compare."""
        planned = self._core.planned
        return None if planned is None else Plan(planned)

    @property
    def difference(self) -> dict[str, float | None] | None:
        """`planned` less this plan, with the same in per cent (docs/json.md); None where nothing was compared."""
        compared = self._core.comparison
        return dict(json.loads(compared)["difference"]) if compared else None

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a plan file (.gpkg), with the bytes that the program writes, or a picture (.png, .svg, .pdf).

        The file is written whole or not at all.
        """
        name = os.fspath(path)
        if pathlib.Path(name).suffix.lower() in (".png", ".svg", ".pdf"):
            self._core.draw(name)
        else:
            self._core.save(name)

    @cached_property
    def _plan_file(self) -> tuple[tempfile.TemporaryDirectory[str], str]:
        folder = tempfile.TemporaryDirectory(prefix="tramline-")
        name = os.path.join(folder.name, "plan.gpkg")
        self._core.save(name)
        return folder, name

    def layer(self, name: str) -> Any:
        """A layer of the plan file (docs/plan-file.md), such as "tracks" or "swaths".

        A GeoDataFrame in the CRS of the field where geopandas is installed; otherwise `features(name)`.
        """
        try:
            import geopandas
        except ImportError:
            return self.features(name)
        self._require_layer(name)
        frame = geopandas.read_file(self._plan_file[1], layer=name)
        # The plan file has a plane of its own.
        if self.crs:
            return frame.to_crs(self.crs)
        frame.crs = None  # that of the file is only a name for plain metres
        return frame

    def features(self, name: str) -> dict[str, Any]:
        """The same as a feature collection: in WGS 84, or in plain metres where the field is."""
        self._require_layer(name)
        if not self.crs:
            return plain_features(self._plan_file[1], name)
        with tempfile.TemporaryDirectory(prefix="tramline-") as folder:
            file = os.path.join(folder, "layer.geojson")
            try:
                _core.export_layer(self._plan_file[1], file, name, "wgs84")
            except InputError:
                return {"type": "FeatureCollection", "features": []}  # only an empty layer is refused
            with open(file, encoding="utf-8") as text:
                out = json.load(text)
        assert isinstance(out, dict)
        return out

    @cached_property
    def layers(self) -> tuple[str, ...]:
        """The names of the layers with shapes that this plan has."""
        with closing(sqlite3.connect(self._plan_file[1])) as file:
            return tuple(name for (name,) in file.execute("SELECT table_name FROM gpkg_geometry_columns"))

    def _require_layer(self, name: str) -> None:
        if name not in self.layers:
            raise InputError(f"there is no layer '{name}'; the plan has {', '.join(self.layers)}")

    def __repr__(self) -> str:
        return (
            f"<Plan of {self.field_id}: {self.area_m2 / 1e4:.2f} ha, {self.tracks} tracks, {self.turns} turns, "
            f"overlap {self.overlap_m2:.0f} m², uncovered {self.uncovered_m2:.0f} m²>"
        )

    def _repr_html_(self) -> str:
        return _picture(self._core.draw)


class Evaluation(Figures):
    """What was worked, worked again and missed."""

    def __init__(self, core: _core.Evaluation) -> None:
        self._core = core

    def _json(self) -> str:
        return self._core.json

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a coverage file (.gpkg) or a picture (.png, .svg, .pdf)."""
        name = os.fspath(path)
        if pathlib.Path(name).suffix.lower() in (".png", ".svg", ".pdf"):
            self._core.draw(name)
        else:
            self._core.save(name)

    def _repr_html_(self) -> str:
        return _picture(self._core.draw)


class Verdict(Figures):
    """Whether a plan holds, by a verifier that knows nothing of the planner. True where it does."""

    def __init__(self, text: str) -> None:
        self._text = text

    def _json(self) -> str:
        return self._text

    @property
    def ok(self) -> bool:
        return bool(self.figures["ok"])

    @property
    def violations(self) -> list[Mapping[str, Any]]:
        return list(self.figures["violations"])

    def __bool__(self) -> bool:
        return self.ok


class Comparison(Figures):
    """Plans of a field of which none is better than another in everything, or what it takes with several machines."""

    def __init__(self, core: _core.Comparison) -> None:
        self._core = core

    def _json(self) -> str:
        return self._core.json

    @property
    def points(self) -> list[dict[str, Any]]:
        """Figures of each plan (the key `front` of docs/json.md); empty where machines were compared."""
        return list(self.figures.get("front", ()))

    @property
    def winners(self) -> list[dict[str, Any]]:
        """For each of `for_`, the plan that costs least."""
        return list(self.figures.get("winners", ()))

    @property
    def machines(self) -> list[dict[str, Any]]:
        """What the whole job takes with each machine: hours, litres, euros; or `error`. Empty where plans were compared."""
        return list(self.figures.get("machines", ()))

    def plan(self, point: int) -> Plan:
        """A plan of the front, by the number in `points`."""
        return Plan(self._core.plan(point))

    @property
    def csv(self) -> str:
        return self._core.csv

    def __len__(self) -> int:
        return len(self.points or self.machines)
