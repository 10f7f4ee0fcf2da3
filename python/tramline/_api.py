"""The functions of the package. Their keywords are declared in _api.pyi, which tools/write_stubs.py makes from the
options of the program: what one takes, the other does."""

from __future__ import annotations

import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from . import _core
from ._core import InputError
from ._fields import Given, given
from ._results import Comparison, Evaluation, Plan, Verdict
from ._words import words

_NUMBERS = (
    "area_m2",
    "tracks",
    "track_length_m",
    "turns",
    "stops",
    "subfields",
    "overlap_m2",
    "uncovered_m2",
    "cost",
    "time_s",
    "litres",
    "euros",
)


def _none_of(options: dict[str, Any], why: str, *names: str) -> None:
    for name in names:
        if name in options:
            raise InputError(f"'{name}' was not expected: {why}")


_ONE_FIELD = "this takes one field; plan_fields() plans many"


def _require_file(source: Given, options: dict[str, Any]) -> None:
    """Layers and filters choose from a file: with geometries in memory they would be ignored."""
    if source.features is not None:
        _none_of(options, "it chooses from a file, and the field is in memory", "layer", "where", "id")


def plan(field: Any, *, name: str | None = None, progress: Any = None, **options: Any) -> Plan:
    """Plans a field, as `tramline plan` does with the options of the same names.

    field: a path, WKB, WKT, or anything with __geo_interface__ (shapely, geopandas, a dict of GeoJSON).
    crs: of coordinates that do not say theirs; without one they are plain metres.
    name: the id of a field that has none.
    progress: called with (done, total); ends the search with the best plan so far where it returns False.
    Raises InputError, a ValueError, for what cannot be planned and RunError where a run fails.
    """
    _none_of(options, _ONE_FIELD, "all")
    source = given(field, "field", name)
    _require_file(source, options)
    return Plan(_core.plan([source.file, *words(options)], source.features, progress))


def plan_fields(gdf: Any, *, threads: int = 0, plans: bool = False, **options: Any) -> Any:
    """Plans every field of a GeoDataFrame, or of a file, and gives their figures with the same index.

    A field that is refused has the reason in the column `error`, and no figures. plans: a column `plan` of the
    plans themselves, too. The result does not depend on threads. Raises InputError for options with which no
    field could be planned.
    """
    import geopandas

    _none_of(options, "every field is planned; choose rows of the GeoDataFrame", "all", "id", "name", "where")
    if isinstance(gdf, (str, os.PathLike)):
        layer = options.pop("layer", None)
        gdf = geopandas.read_file(gdf, layer=layer) if layer else geopandas.read_file(gdf)

    _core.require_plannable(["fields", *words(options)])

    def one(item: tuple[Any, Any]) -> Plan | str:
        index, shape = item
        if shape is None or shape.is_empty:
            return "the field has no geometry"
        try:
            feature = {"type": "Feature", "properties": {"id": str(index)}, "geometry": shape.__geo_interface__}
            return plan(_WithCrs(feature, gdf.crs), threads=1, **options)
        except InputError as fault:
            return str(fault)

    with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        found = list(pool.map(one, zip(gdf.index, gdf.geometry)))
    table: dict[str, list[Any]] = {
        key: [getattr(result, key) if isinstance(result, Plan) else None for result in found] for key in _NUMBERS
    }
    table["error"] = [None if isinstance(result, Plan) else result for result in found]
    if plans:
        table["plan"] = [result if isinstance(result, Plan) else None for result in found]
    return geopandas.GeoDataFrame(table, index=gdf.index, geometry=list(gdf.geometry), crs=gdf.crs)


class _WithCrs:
    def __init__(self, feature: dict[str, Any], crs: Any) -> None:
        self.__geo_interface__ = feature
        self.crs = crs


def read(path: Any, *, id: str = "") -> Plan:
    """The plan in a plan file; of a file of many plans that of the field of this id or key."""
    return Plan(_core.read(os.fspath(path), id))


def _field_words(field: Any, options: dict[str, Any]) -> tuple[list[str], _core.Features | None]:
    if field is None:
        return words(options), None
    source = given(field, "field")
    if source.number > 1:
        raise InputError(f"the field has {source.number} features; give the one that was planned or worked")
    return [f"--field={source.file}", *words(options)], source.features


def evaluate(done: Any, *, field: Any = None, plan: Any = None, **options: Any) -> Evaluation:
    """Evaluates a drive: which land was covered, repeated and missed, as `tramline evaluate` does.

    done: a Plan, whose own drive is evaluated, or the path of a log. field: where the log was to work.
    plan: a Plan, or the path of one, to compare the log with.
    """
    if isinstance(done, Plan):
        if field is not None or plan is not None:
            raise InputError("field and plan go with a log; a plan is evaluated on the land it was made for")
        return Evaluation(_core.evaluate(words(options), None, done._core, done.field_id))
    chosen = read(plan) if plan is not None and not isinstance(plan, Plan) else plan
    more, features = _field_words(field, options)
    name = chosen.field_id if chosen is not None else ""
    log = os.fspath(done)
    return Evaluation(_core.evaluate([log, *more], features, chosen._core if chosen is not None else None, name))


def check(plan: Any, *, field: Any = None, id: str = "", **options: Any) -> Verdict:
    """Verifies a Plan, or the plan in a file, independently of the planner, as `tramline check` does.

    field: what the plan was made from: field and obstacles have to be the same.
    """
    more, features = _field_words(field, options)
    if not isinstance(plan, Plan):
        return Verdict(_core.check(os.fspath(plan), id, more, features))
    with tempfile.TemporaryDirectory(prefix="tramline-") as folder:
        file = os.path.join(folder, "plan.gpkg")
        plan.save(file)
        return Verdict(_core.check(file, id, more, features))


def price(lines: Any, field: Any = None, *, progress: Any = None, **options: Any) -> Plan:
    """The plan that given lines are, with its figures, as `tramline price` has it.

    lines: centre lines in driving order: a path, a Plan, or anything with __geo_interface__; a list of them too.
    field: needed for lines; the tracks of a plan bring their own.
    compare: plan the field as well; the result has that plan in `planned`, and the differences in `difference`.
    """
    if isinstance(lines, Plan):
        with tempfile.TemporaryDirectory(prefix="tramline-") as folder:
            file = os.path.join(folder, "plan.gpkg")
            lines.save(file)
            return price(file, field, progress=progress, **options)
    source = given(lines, "lines")
    more, features = _field_words(field, options)
    return Plan(_core.price([source.file, *more], features, source.features, progress))


def compare(field: Any, *, name: str | None = None, progress: Any = None, **options: Any) -> Comparison:
    """The plans of a field that are worth a choice, as `tramline compare` finds them.

    for_: prices, or several of them, whose cheapest plan is named (`winners`).
    widths, machines: compares instead what the whole job takes with each of them (`machines`).
    """
    _none_of(options, _ONE_FIELD, "all")
    source = given(field, "field", name)
    _require_file(source, options)
    return Comparison(_core.compare([source.file, *words(options)], source.features, progress))


__all__ = ["check", "compare", "evaluate", "plan", "plan_fields", "price", "read"]
