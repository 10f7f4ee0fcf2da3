"""Runs the program: its JSON as it comes, its progress, and an end when the user wants it."""

import contextlib
import glob
import json
import os
import selectors
import subprocess
import time

try:
    import fcntl
    import pty
    import termios
    import tty
except ImportError:  # on Windows, where there is no program either
    pty = None

from .progress import ProgressReader

# How often it is asked whether the user wants an end, s.
_ASKED_EVERY_S = 0.1
# How long the program may take to end before it is killed, s.
_TO_END_S = 3


class RunFailed(Exception):
    """The program has refused the input or failed; the message is its own sentence."""


class Cancelled(Exception):
    """The user has ended the run."""


class Done:
    """code: the exit code. results: the objects that were printed, in their order. messages: lines on stderr."""

    def __init__(self, code, results, messages):
        self.code, self.results, self.messages = code, results, messages


def run(program, words, on_step, on_result=lambda number: None, cancelled=lambda: False, fine=(0, 3)):
    """Runs `program` with `words`, which make it print JSON.

    on_step: told of each Step. on_result: told how many results there are when one more has come. cancelled: asked ten times a
    second. fine: the exit codes that are no failure where there are results. Throws RunFailed, and Cancelled after the program has ended.
    """
    messages = []
    reader = ProgressReader(on_step, messages.append)
    results = _Results(on_result)
    with _started(program, words) as (process, errors):
        try:
            _follow(process, errors, results, reader, cancelled)
        except BaseException:
            _end(process)
            _remove_unfinished(words, process.pid)
            raise
        code = process.wait()
    reader.end()
    results.end()
    if code not in fine or not results.objects:
        raise RunFailed(_sentence(code, messages, results.objects))
    return Done(code, results.objects, messages)


class _Results:
    """An object for each line, or one object over many lines."""

    def __init__(self, on_result):
        self.objects, self._on_result, self._text = [], on_result, b""

    def feed(self, data):
        *lines, self._text = (self._text + data).split(b"\n")
        for number, line in enumerate(lines):
            if not self._take(line):
                self._text = b"\n".join(lines[number:] + [self._text])
                return

    def end(self):
        if self._text.strip() and not self._take(self._text):
            raise RunFailed("The program printed something else than JSON: is it a version of tramline that this plugin knows?")
        self._text = b""

    def _take(self, text):
        if not text.strip():
            return True
        try:
            self.objects.append(json.loads(text))
        except ValueError:
            return False
        self._on_result(len(self.objects))
        return True


@contextlib.contextmanager
def _started(program, words):
    """The process, and what its stderr is read from.

    Progress is told to terminals only. The program gets one of its own, which also ends it (SIGHUP) where QGIS itself is
    ended: nobody would be there for its results.
    """
    if pty is None:
        raise RunFailed("The program tramline runs on Linux and other Unix systems.")
    ours, theirs = pty.openpty()
    try:
        tty.setraw(theirs)
        process = subprocess.Popen(
            [program, *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=theirs,
            start_new_session=True,
            preexec_fn=_take_terminal,
        )
    except OSError as fault:
        os.close(ours)
        raise RunFailed(f"The program '{program}' could not be started: {fault.strerror}.") from None
    finally:
        os.close(theirs)
    try:
        with process:
            yield process, ours
    finally:
        os.close(ours)


def _take_terminal():
    fcntl.ioctl(2, termios.TIOCSCTTY, 0)


def _follow(process, errors, results, reader, cancelled):
    """Until both streams have ended."""
    streams = {process.stdout.fileno(): results.feed, errors: reader.feed}
    with selectors.DefaultSelector() as selector:
        for stream in streams:
            selector.register(stream, selectors.EVENT_READ)
        while selector.get_map():
            if cancelled():
                raise Cancelled("The run was cancelled.")
            for key, _ in selector.select(_ASKED_EVERY_S):
                data = _read(key.fd)
                if data:
                    streams[key.fd](data)
                else:
                    selector.unregister(key.fd)


def _read(stream):
    try:
        return os.read(stream, 1 << 16)
    except OSError:  # a terminal whose other end is closed
        return b""


def _end(process):
    process.terminate()
    until = time.monotonic() + _TO_END_S
    while process.poll() is None and time.monotonic() < until:
        time.sleep(0.02)
    if process.poll() is None:
        process.kill()
    process.wait()


def _remove_unfinished(words, pid):
    """What a process that was ended had not yet given its name."""
    for word in words:
        name, _, file = word.partition("=")
        if name in ("--output", "--picture", "--csv") and not os.path.isdir(file):
            folder, base = os.path.split(os.path.abspath(file))
            for left in glob.glob(os.path.join(glob.escape(folder), f".{glob.escape(base)}.{pid}-*.part")):
                with contextlib.suppress(OSError):
                    os.remove(left)


def _sentence(code, messages, results):
    """The program ends bad input and failures with one sentence; of many fields each refused one has its own."""
    said = " ".join(str(one["error"]) for one in results if "error" in one) or " ".join(messages)
    said = said.removeprefix("tramline: ")
    if said:
        return said[:1].upper() + said[1:]
    return f"The program was ended by signal {-code}." if code < 0 else f"The program ended with exit code {code}."
