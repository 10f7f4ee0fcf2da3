"""What the workers of a cluster do. A module of its own: they find it by its name, whatever began the run."""

from __future__ import annotations

import threading
from collections.abc import Sequence

from . import _core

_batches: dict[tuple[str, ...], _core.Batch] = {}
# Workers may have several threads.
_opening = threading.Lock()


def work_on(words: Sequence[str], chunk: int) -> tuple[int, int]:
    """On a worker: reads the features of the chunk, plans them and writes the chunk. Fields planned and refused."""
    key = tuple(words)
    # The file stays open between chunks, and chunks come in its order.
    with _opening:
        if key not in _batches:
            _batches.clear()
            _batches[key] = _core.Batch(list(words))
        batch = _batches[key]
    return batch.work_on(chunk)
