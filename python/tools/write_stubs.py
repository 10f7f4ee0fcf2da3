#!/usr/bin/python3
"""Writes tramline/_api.pyi, the keywords of the package, from the options of the program.

Usage: PYTHONPATH=build/release/python write_stubs.py [--check]
With --check nothing is written: the exit code says whether the file is as it would be.
"""

from __future__ import annotations

import pathlib
import sys
from keyword import iskeyword

from tramline import _core

FILE = pathlib.Path(__file__).resolve().parent.parent / "tramline" / "_api.pyi"

HEAD = '''# Written by tools/write_stubs.py from the options of the program.
# fmt: off

import os
from collections.abc import Callable, Sequence
from typing import Any, Union

from ._results import Comparison, Evaluation, Plan, Verdict

_Path = Union[str, os.PathLike[str]]
# A path, WKB, WKT, or anything with __geo_interface__, which includes a dict of GeoJSON.
_Field = Any
_Numbers = Union[str, Sequence[float]]
_Point = Union[_Path, tuple[float, float]]
_Points = Union[str, Sequence[tuple[float, float]]]
_Progress = Callable[[int, int], object]
'''

# The first parameters of each function, and what comes with it besides the options of its command. Options of a field
# that is there already have no use.
FUNCTIONS = {
    "plan": ("field: _Field, *, name: str | None = ..., progress: _Progress | None = ...", "plan", {"all"}, "Plan"),
    "plan_fields": ("gdf: Any, *, plans: bool = ...", "plan", {"all", "id", "where"}, "Any"),
    "compare": ("field: _Field, *, name: str | None = ..., progress: _Progress | None = ...", "compare", {"all"}, "Comparison"),
    "price": (
        "lines: Any, field: _Field | None = ..., *, progress: _Progress | None = ...", "price", {"field"}, "Plan"
    ),
    "evaluate": ("done: Plan | _Path, *, field: _Field | None = ..., plan: Plan | _Path | None = ...", "evaluate", {"field"}, "Evaluation"),
    "check": ("plan: Plan | _Path, *, field: _Field | None = ..., id: str = ...", "check", {"field", "id"}, "Verdict"),
}

NUMBERS = {"M", "DEG", "S", "M/S", "€", "L", "N"}
TYPES = {"": "bool", "FILE": "_Path", "NUMBERS": "_Numbers", "POINT|FILE": "_Point", "POINTS": "_Points"}
SPECIAL = {
    "headlands": "int | str",
    "obstacle_headlands": "int | str",
    "done": "_Path | Sequence[_Path]",
    "route": "bool | str",
    "threads": "int",
    "job": "int",
    "for_": "_Numbers | Sequence[_Numbers]",
    "machines": "_Path | Sequence[_Path]",
}


def type_of(name: str, takes: str) -> str:
    if name in SPECIAL:
        return SPECIAL[name]
    kind = takes.split(":")[0]  # behind the colon is what values may be
    return "float" if kind in NUMBERS else TYPES.get(kind, "str")


def stub(name: str) -> str:
    head, command, left_out, result = FUNCTIONS[name]
    lines = [f"def {name}(", f"    {head},"]
    for option, takes, _ in _core.options(command):
        keyword = option[2:].replace("-", "_")
        keyword += "_" * iskeyword(keyword)
        if keyword not in left_out:
            lines.append(f"    {keyword}: {type_of(keyword, takes)} | None = ...,")
    return "\n".join([*lines, f") -> {result}: ..."])


def main() -> int:
    stubs = [stub(name) for name in FUNCTIONS]
    text = "\n".join([HEAD, *stubs, "def read(path: _Path, *, id: str = ...) -> Plan: ...", ""])
    if "--check" in sys.argv[1:]:
        return 0 if FILE.read_text(encoding="utf-8") == text else 1
    FILE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
