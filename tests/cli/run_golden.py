#!/usr/bin/env python3
"""Runs the program on one case after another and compares everything a user could see.

A case is a folder with

  command        the arguments of the program on one line, quoted as in a shell
  setup.sh       optional; bash, run first in $INPUT to make what the command reads
  stdout         the expected output, masked (see below)
  stderr         the same for the error output
  expect         regular expressions, one a line, each of which stderr has to match; instead of, or
                 besides, the golden stderr. Lines that begin with # are comments
  expect-stdout  the same for stdout
  exit           the expected exit code
  files          names of the files that have to lie in $OUT afterwards, one a line. Nothing else
                 may: a run that fails leaves nothing half-written

In `command` and in the environment of setup.sh these are known:

  $EXAMPLES  the examples of the project     $COMMON  inputs that several cases share
  $CASE      the folder of the case          $TRAMLINE  the program
  $INPUT     a fresh folder for what setup.sh makes
  $OUT       a fresh folder for what the program writes

What holds for every case without being said: the program does not die of a signal; it prints no
colour codes; it leaves $INPUT as it was; with exit code 2 it prints nothing on stdout and one
sentence on stderr that begins with "tramline: ". A stream with neither golden nor expectations
has to be empty if the run is to fail, and is an error in the case if it is to succeed.

Masks, so that goldens hold everywhere: "seconds": 0.25 becomes "seconds": X; a time such as 0.25 s
or 12 ms becomes X s or X ms; a version, alone on a line or after the word tramline, becomes VERSION;
the folders above become their names again.

--update writes stdout, stderr and files as the program gives them, and exit where there is none. What
a person has decided stays: a run with another exit code than the case asks for writes nothing, and
an `expect` has to match nevertheless.
"""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

TIME_LIMIT_S = 120
HERE = pathlib.Path(__file__).resolve().parent

MASKS = [
    (re.compile(r'("seconds"\s*:\s*)[-+0-9.eE]+'), r"\1X"),
    (re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)? (s|ms)\b"), r"X \1"),
    (re.compile(r"^(tramline )?\d+\.\d+\.\d+$", re.MULTILINE), r"\1VERSION"),
]


class BadCase(Exception):
    """The case itself is at fault, not the program."""


class Run:
    """What one run of the program left behind, masked."""

    def __init__(self, exit_code, stdout, stderr, files, input_changes):
        self.exit_code = exit_code
        self.stdout = stdout
        self.stderr = stderr
        self.files = files
        self.input_changes = input_changes


def lines_of(path):
    return [line for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]


def files_under(folder):
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if not p.is_dir())


def contents_under(folder):
    return {name: (folder / name).read_bytes() for name in files_under(folder)}


def masked(text, places):
    # Longest first: one folder may lie in another.
    for name, path in sorted(places.items(), key=lambda place: -len(str(place[1]))):
        text = text.replace(str(path), "$" + name)
    for pattern, replacement in MASKS:
        text = pattern.sub(replacement, text)
    return text


def expanded(word, places):
    def place(match):
        if match.group(1) not in places:
            raise BadCase(f"command: there is no ${match.group(1)}")
        return str(places[match.group(1)])

    return re.sub(r"\$([A-Z]+)", place, word)


def run_case(case, program, examples):
    with tempfile.TemporaryDirectory(prefix="tramline-case-") as scratch:
        places = {
            "EXAMPLES": examples,
            "COMMON": HERE / "common",
            "CASE": case,
            "TRAMLINE": program,
            "INPUT": pathlib.Path(scratch).resolve() / "input",
            "OUT": pathlib.Path(scratch).resolve() / "out",
        }
        places["INPUT"].mkdir()
        places["OUT"].mkdir()
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "SOURCE_DATE_EPOCH": "1700000000"}
        if (case / "setup.sh").exists():
            made = subprocess.run(["bash", "-euo", "pipefail", case / "setup.sh"], cwd=places["INPUT"],
                                  env={**environment, **{k: str(v) for k, v in places.items()}},
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
            if made.returncode != 0:
                raise BadCase(f"setup.sh failed ({made.returncode}):\n{made.stdout}{made.stderr}")
        before = contents_under(places["INPUT"])

        words = shlex.split((case / "command").read_text(), comments=True)
        arguments = [expanded(word, places) for word in words]
        done = subprocess.run([program, *arguments], cwd=places["OUT"], env=environment,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=TIME_LIMIT_S, check=False)
        after = contents_under(places["INPUT"])
        changes = sorted(n for n in before.keys() | after.keys() if before.get(n) != after.get(n))
        return Run(done.returncode, masked(done.stdout.decode("utf-8", "replace"), places),
                   masked(done.stderr.decode("utf-8", "replace"), places), files_under(places["OUT"]), changes)


def first_difference(expected, found):
    for number, (a, b) in enumerate(zip(expected.splitlines() + [""], found.splitlines() + [""]), 1):
        if a != b:
            return f"line {number}\n    expected: {a}\n    found:    {b}"
    return "one of them goes on longer, or ends without a line feed"


def stream_faults(case, name, expect_name, found, expected_exit):
    golden, expect = case / name, case / expect_name
    if expect.exists():
        for pattern in lines_of(expect):
            if not re.search(pattern, found, re.MULTILINE):
                yield f"{name} does not match /{pattern}/; found:\n{found}"
    if golden.exists():
        if golden.read_text() != found:
            yield f"{name} differs in {first_difference(golden.read_text(), found)}"
    elif not expect.exists():
        if expected_exit == 0:
            yield f"the case has no golden {name}; run with --update and read what it wrote"
        elif found:
            yield f"{name} is not empty:\n{found}"


def faults_of(case, run):
    """Yields one sentence for everything in the run that the case does not allow."""
    expected_exit = int((case / "exit").read_text())
    if run.exit_code < 0:
        yield f"the program died of signal {-run.exit_code}"
    if run.exit_code != expected_exit:
        yield f"exit code {run.exit_code} instead of {expected_exit}; stderr:\n{run.stderr}"
    yield from stream_faults(case, "stdout", "expect-stdout", run.stdout, expected_exit)
    yield from stream_faults(case, "stderr", "expect", run.stderr, expected_exit)
    if "\x1b" in run.stdout + run.stderr:
        yield "colour codes in the output, which is not a terminal"
    if run.exit_code == 2:
        if run.stdout:
            yield f"bad input, and yet something on stdout:\n{run.stdout}"
        if not re.fullmatch(r"tramline: [^\n]+\n", run.stderr):
            yield f"bad input is not told in one sentence that begins with 'tramline: '; found:\n{run.stderr}"
    expected_files = sorted(lines_of(case / "files")) if (case / "files").exists() else []
    if run.files != expected_files:
        yield f"files in $OUT: {run.files} instead of {expected_files}"
    if run.input_changes:
        yield f"the run changed its input: {run.input_changes}"


def write_goldens(case, run):
    if (case / "exit").exists() and int((case / "exit").read_text()) != run.exit_code:
        return

    def write(name, text, wanted):
        if wanted:
            (case / name).write_text(text)
        elif (case / name).exists():
            (case / name).unlink()

    write("exit", f"{run.exit_code}\n", True)
    write("stdout", run.stdout, bool(run.stdout) or run.exit_code == 0 and not (case / "expect-stdout").exists())
    write("stderr", run.stderr, bool(run.stderr) or run.exit_code == 0 and not (case / "expect").exists())
    write("files", "".join(name + "\n" for name in run.files), bool(run.files))


def verdict(case, program, examples, update):
    """Returns the list of faults of one case, empty if it passes."""
    try:
        run = run_case(case, program, examples)
        if update:
            write_goldens(case, run)
        return list(faults_of(case, run))
    except subprocess.TimeoutExpired:
        return [f"the program still ran after {TIME_LIMIT_S} s"]
    except (BadCase, OSError, ValueError) as error:
        return [f"the case cannot be run: {error}"]


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Runs golden command-line cases.")
    parser.add_argument("--tramline", required=True, type=pathlib.Path, help="the program")
    parser.add_argument("--examples", type=pathlib.Path, default=HERE.parents[1] / "examples")
    parser.add_argument("--update", action="store_true", help="write the goldens as the program gives them")
    parser.add_argument("cases", nargs="*", type=pathlib.Path, help="case folders (default: all)")
    options = parser.parse_args(arguments)

    cases = options.cases or sorted(p.parent for p in (HERE / "cases").glob("*/command"))
    failed = 0
    for case in cases:
        faults = verdict(case.resolve(), options.tramline.resolve(), options.examples.resolve(), options.update)
        failed += bool(faults)
        print(f"{'FAIL' if faults else 'ok  '} {case.name}")
        for fault in faults:
            print("  " + fault.rstrip().replace("\n", "\n  "))
    print(f"{len(cases) - failed} of {len(cases)} cases pass")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
