"""Plans all fields of a large file on several machines: `tramline batch`, with its chunks on Dask distributed.

    python3 -m tramline.batch parcels.gpkg -o plans --width 24 --scheduler local --workers 4
    python3 -m tramline.batch parcels.gpkg -o plans --width 24 --scheduler tcp://head:8786 --resume

Parcels and folder have to be the same files under the same names on every machine. What is not listed here is an option
of `tramline batch`, and so are the bytes of the result. docs/batch.md says how to start a cluster.
"""

from __future__ import annotations

import argparse
import json
import logging
import sys
import tempfile
import time
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from . import _core
from ._core import InputError, RunError
from ._worker import work_on

# Chunks that are handed out before a worker asks for them.
_WAITING_PER_WORKER = 2
# How long a scheduler or a connection may be gone, and no worker be there at first, before the run ends.
_GONE_S = 60
# How often a chunk may take its worker down with it before it is given up.
_DEATHS_OF_A_CHUNK = 10


class _Pace:
    """A line on a terminal, at most once a second."""

    def __init__(self, all_fields: int, before: int, quiet: bool) -> None:
        self._all, self._done, self._worked = all_fields, before, 0
        self._start = self._last = time.monotonic()
        self._shown = not quiet and sys.stderr.isatty()

    def add(self, fields: int) -> None:
        self._done += fields
        self._worked += fields
        now = time.monotonic()
        if not self._shown or now - self._last < 1:
            return
        self._last = now
        rate = self._worked / (now - self._start)
        left = (self._all - self._done) / rate
        print(f"\r{self._done} of {self._all} fields, {rate:.1f} fields/s, {left:.0f} s left  ", end="", file=sys.stderr)

    def end(self) -> None:
        if self._shown:
            print(file=sys.stderr)


def _finished(client: Any, words: Sequence[str], chunks: list[int]) -> Iterator[int]:
    """Hands out the chunks and gives the number of each when it is done."""
    from distributed import as_completed

    waiting = deque(chunks)
    numbers: dict[str, int] = {}

    def next_one() -> Any:
        chunk = waiting.popleft()
        future = client.submit(work_on, list(words), chunk, pure=False, retries=0)
        numbers[future.key] = chunk
        return future

    running = as_completed(loop=client.loop)
    workers = max(1, len(client.scheduler_info()["workers"]))
    for _ in range(min(len(waiting), _WAITING_PER_WORKER * workers)):
        running.add(next_one())
    for future in running:
        future.result()
        yield numbers.pop(future.key)
        if waiting:
            running.add(next_one())


@contextmanager
def _cluster(scheduler: str, workers: int) -> Iterator[Any]:
    """A client."""
    import dask
    from distributed import Client, LocalCluster

    if scheduler != "local":
        with Client(scheduler, timeout=_GONE_S) as client:
            yield client
        return
    # Elsewhere it is the scheduler's own setting.
    dask.config.set({"distributed.scheduler.allowed-failures": _DEATHS_OF_A_CHUNK})
    # Workers would keep their files where the user happens to be.
    with tempfile.TemporaryDirectory(prefix="tramline-dask-") as folder:
        own = {"n_workers": workers, "threads_per_worker": 1, "dashboard_address": None, "local_directory": folder}
        with LocalCluster(**own) as cluster, Client(cluster, timeout=_GONE_S) as client:
            yield client


def _silence() -> None:
    """What is lost is said in one sentence. Dask gives its loggers levels of their own when it is imported."""
    try:
        import distributed  # noqa: F401
    except ImportError:
        return  # run() says so
    for name in list(logging.root.manager.loggerDict):
        if name.split(".")[0] in ("distributed", "tornado", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)


def run(words: Sequence[str], scheduler: str = "local", workers: int = 2, quiet: bool = False) -> dict[str, Any]:
    """Works on all chunks that are missing and gives the sums of summary.json.

    words: the command line of `tramline batch`, ["parcels.gpkg", "--output=plans", "--width=24"].
    Raises InputError, and RunError where the cluster is lost: with --resume another run goes on.
    """
    try:
        import distributed  # noqa: F401
    except ImportError:
        raise InputError("tramline.batch needs Dask distributed: install python3-distributed") from None
    batch = _core.Batch(list(words))
    missing = batch.missing()
    # Workers find the folder begun, and use a core each.
    theirs = [word for word in words if word != "--resume"] + ["--resume"]
    if batch.threads == 0:
        theirs.append("--threads=1")
    left = sum(batch.fields_in(chunk) for chunk in missing)
    pace = _Pace(batch.fields, batch.fields - left, quiet)
    if missing:
        try:
            with _cluster(scheduler, workers) as client:
                client.wait_for_workers(1, timeout=_GONE_S)
                for chunk in _finished(client, theirs, missing):
                    pace.add(batch.fields_in(chunk))
        except (InputError, RunError):
            raise
        except Exception as fault:  # of many kinds: cancelled futures, closed connections, killed workers
            raise RunError(f"the cluster was lost ({type(fault).__name__}: {fault}); go on with --resume") from fault
    pace.end()
    found = json.loads(batch.finish())
    assert isinstance(found, dict)
    return found


def main(arguments: Sequence[str]) -> int:
    assert __doc__ is not None
    parser = argparse.ArgumentParser(
        prog="python3 -m tramline.batch", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--scheduler", default="local", help="tcp://HOST:PORT, or local: a cluster on this machine")
    parser.add_argument("--workers", type=int, default=2, help="processes of a local cluster (default: 2)")
    parser.add_argument("--json", action="store_true", help="print the sums as JSON")
    parser.add_argument("--quiet", action="store_true", help="print neither progress nor sums")
    own, words = parser.parse_known_args(arguments)
    _silence()
    try:
        sums = run(words, own.scheduler, own.workers, own.quiet)
    except (InputError, RunError) as fault:
        print(f"tramline.batch: {fault}", file=sys.stderr)
        return 2 if isinstance(fault, InputError) else 1
    if own.json:
        print(json.dumps(sums))
    elif not own.quiet:
        print(f"planned {sums['planned']} fields, {sums['refused']} refused (refused.csv says why)")
    if sums["refused"] == 0:
        return 0
    return 3 if sums["planned"] > 0 else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
