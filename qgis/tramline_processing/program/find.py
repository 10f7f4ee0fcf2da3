"""Where the program is."""

import os
import re
import shutil
import subprocess

_WHERE = "Choose it under Settings > Options > Processing > Providers > tramline, or put it on the PATH."

_VERSION = re.compile(r"\d+\.\d+\.\d+\S*")


class ProgramMissing(Exception):
    """There is no program, or something else of its name; the message says what to do."""


def find_program(chosen):
    """The path of the program.

    chosen: what the user has set; empty: that of the environment variable TRAMLINE, else the one on the PATH.
    """
    wanted = chosen or os.environ.get("TRAMLINE", "")
    if not wanted:
        found = shutil.which("tramline")
        if found is None:
            raise ProgramMissing(f"The program tramline was not found. {_WHERE}")
        return found
    wanted = os.path.expanduser(wanted)
    if not os.path.exists(wanted):
        raise ProgramMissing(f"There is no program '{wanted}'. {_WHERE}")
    if os.path.isdir(wanted) or not os.access(wanted, os.X_OK):
        raise ProgramMissing(f"'{wanted}' is not a program. {_WHERE}")
    return wanted


def version_of(program):
    """Its name and version, by asking the program."""
    try:
        done = subprocess.run(
            [program, "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=30
        )
        said = done.stdout.strip()
    except (OSError, subprocess.TimeoutExpired, UnicodeDecodeError):
        said = ""
    if not _VERSION.fullmatch(said):
        raise ProgramMissing(f"'{program}' is not the program tramline. {_WHERE}")
    return f"tramline {said}"
