"""What the package says of itself: types, and the examples of the documentation."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PYTHON_BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)


def blocks(page):
    return PYTHON_BLOCK.findall((ROOT / page).read_text(encoding="utf-8"))


EXAMPLES = [(page, number) for page in ("docs/python.md", "README.md") for number, _ in enumerate(blocks(page))]


def test_there_are_eight_examples():
    assert len(blocks("docs/python.md")) == 8


@pytest.mark.parametrize("page, number", EXAMPLES)
def test_example(page, number, examples, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copytree(examples, "examples")
    exec(compile(blocks(page)[number], f"{page}, example {number + 1}", "exec"), {"__name__": "__main__"})


def test_stubs_have_the_options_of_the_program():
    done = subprocess.run([sys.executable, "-B", ROOT / "python/tools/write_stubs.py", "--check"])
    assert done.returncode == 0, "write_stubs.py has not been run since the options changed"


def test_types(tmp_path):
    """The package and a user's code are checked; wrong types are found."""
    (tmp_path / "right.py").write_text(
        "import tramline\n"
        "plan = tramline.plan('f.gpkg', width=6, radius=6.5, headlands='auto', reverse=True)\n"
        "area: float = plan.area_m2\n"
        "ok: bool = tramline.check(plan).ok\n"
    )
    (tmp_path / "wrong.py").write_text("import tramline\ntramline.plan('f.gpkg', width='six')\ntramline.plan('f', wdith=6)\n")

    def mypy(*files):
        return subprocess.run(
            ["mypy", "--config-file", ROOT / "python/mypy.ini", "--cache-dir", tmp_path / "cache", *files],
            capture_output=True,
            text=True,
            env={**os.environ, "MYPYPATH": str(ROOT / "python")},
        )

    right = mypy("-p", "tramline")
    assert right.returncode == 0, right.stdout + right.stderr
    right = mypy(tmp_path / "right.py")
    assert right.returncode == 0, right.stdout + right.stderr
    wrong = mypy(tmp_path / "wrong.py").stdout
    assert 'wrong.py:2: error: Argument "width"' in wrong and "wrong.py:3: error: Unexpected keyword" in wrong
