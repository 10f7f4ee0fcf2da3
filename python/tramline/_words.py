"""Keywords as the options of the program, which the C++ side reads."""

from __future__ import annotations

import numbers
import os
from collections.abc import Iterable
from typing import Any

from ._core import InputError

# Options that take their value again for each of several.
_REPEATED = {"done", "for_"}


def words(options: dict[str, Any]) -> list[str]:
    """["--width=6", "--reverse"] for {"width": 6, "reverse": True}.

    None, and False for a flag, stand for the option left out.
    """
    out: list[str] = []
    for name, value in options.items():
        # Words of Python itself are written with a line behind: for_.
        option = "--" + name.rstrip("_").replace("_", "-")
        if name == "route" and isinstance(value, bool):
            value = "whole" if value else "none"
        if value is None or value is False:
            continue
        if value is True:
            out.append(option)
        elif name in _REPEATED:
            out.extend(f"{option}={text(one, name)}" for one in _each_of(value))
        else:
            out.append(f"{option}={text(value, name)}")
    return out


def _each_of(value: Any) -> list[Any]:
    """The values of an option that may have several; a sequence of numbers is one value."""
    if isinstance(value, (str, os.PathLike)) or not isinstance(value, Iterable):
        return [value]
    parts = list(value)
    numeric = parts and all(isinstance(part, numbers.Real) for part in parts)
    return [parts] if numeric else parts


def text(value: object, name: str) -> str:
    """As it would be typed; numbers with all their digits."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, Iterable):
        parts = [text(one, name) for one in value]
        # Points are separated by spaces, their coordinates by commas.
        return (" " if any("," in part for part in parts) else ",").join(parts)
    raise InputError(f"{name} takes a number, a text or a sequence of them, not {value!r}")
