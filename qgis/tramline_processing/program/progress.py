"""What the program says on stderr while it works: lines of progress, which overwrite one another, and messages."""

import re

_PROGRESS = re.compile(r"(?P<what>.*): (?P<done>\d+) of (?P<total>\d+) (?P<unit>\S.*)")
_COLOURS = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


class Step:
    """So much is done: "planning mill-field", 3 of 20 "directions"."""

    def __init__(self, what, done, total, unit):
        self.what, self.done, self.total, self.unit = what, done, total, unit

    @property
    def share(self):
        """From 0 to 1."""
        return min(1.0, self.done / self.total) if self.total > 0 else 0.0


def step_of(line):
    """The step that a line tells of; None: it is a message."""
    found = _PROGRESS.fullmatch(line.strip())
    if found is None:
        return None
    return Step(found["what"], int(found["done"]), int(found["total"]), found["unit"])


class ProgressReader:
    """Takes bytes as they come and tells of steps and messages, each as soon as it is whole."""

    def __init__(self, on_step, on_message):
        self._on_step, self._on_message = on_step, on_message
        self._rest = b""

    def feed(self, data):
        """A line of progress begins with \\r and has no end of its own."""
        *whole, self._rest = re.split(rb"[\r\n]", self._rest + data)
        for line in whole:
            self._tell(line)
        # Progress is written in one go, and ends in a space.
        if self._rest.endswith(b" ") and step_of(self._rest.decode("utf-8", "replace")) is not None:
            self._tell(self._rest)
            self._rest = b""

    def end(self):
        self._tell(self._rest)
        self._rest = b""

    def _tell(self, line):
        text = _COLOURS.sub("", line.decode("utf-8", "replace")).strip()
        if not text:
            return
        step = step_of(text)
        if step is not None:
            self._on_step(step)
        else:
            self._on_message(text)
