"""What the tests need: TRAMLINE names the program, EXAMPLES the folder of fields drawn for the project."""

import os
import pathlib
import subprocess

import hypothesis
import pytest

# Few cases, always the same, and no clock: `TRAMLINE_CASES` says how many there are in a long run.
hypothesis.settings.register_profile(
    "tramline",
    max_examples=int(os.environ.get("TRAMLINE_CASES", "15")),
    deadline=None,
    derandomize="TRAMLINE_CASES" not in os.environ,
    print_blob=True,
)
hypothesis.settings.load_profile("tramline")


@pytest.fixture(scope="session")
def examples() -> pathlib.Path:
    return pathlib.Path(os.environ["EXAMPLES"])


@pytest.fixture(scope="session")
def program():
    def run(*words, code=0):
        done = subprocess.run([os.environ["TRAMLINE"], *map(str, words)], capture_output=True, text=True)
        assert done.returncode == code, done.stderr
        return done

    return run
