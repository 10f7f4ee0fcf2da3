#!/usr/bin/env python3
"""Runs the program on one case after another and compares everything a user could see.

A case is a file cases/VERB/NAME.case, in the form that case_file.py describes, with the sections

  command        the arguments of the program on one line, quoted as in a shell
  setup.sh       optional; bash, run first in $INPUT to make what the command reads
  exit           the expected exit code
  files          names of the files that have to lie in $OUT afterwards, one a line. Nothing else
                 may: a run that fails leaves nothing half-written
  expect         regular expressions, one a line, each of which stderr has to match; instead of, or
                 besides, the golden stderr. Lines that begin with # are comments
  stderr         the expected error output, masked (see below)
  expect-stdout  the same as expect for stdout
  stdout         the same as stderr for stdout; JSON in one form (see below)
  exact          empty; where it stands, JSON on stdout is compared as the program prints it

In `command` and in the environment of setup.sh these are known:

  $EXAMPLES  the examples of the project     $COMMON  what several cases share: inputs, and scripts
  $TRAMLINE  the program                              that make them
  $INPUT     a fresh folder for what setup.sh makes
  $OUT       a fresh folder for what the program writes
  $KEPT      what set-ups keep for other cases (common/kept.sh), beside the program

What holds for every case without being said: the program does not die of a signal; it prints no
colour codes; it leaves $INPUT as it was; with exit code 2 it prints nothing on stdout and one
sentence on stderr that begins with "tramline: ". A stream with neither golden nor expectations
has to be empty if the run is to fail, and is an error in the case if it is to succeed.

Masks, so that goldens hold everywhere: "seconds": 0.25 becomes "seconds": X; a time such as 0.25 s
or 12 ms becomes X s or X ms; a version, alone on a line or after the word tramline, becomes VERSION;
the folders above become their names again.

JSON on stdout is compared, and stands in goldens, in the form that json_form.py gives it: a key a line, and
numbers with nine digits, for the last digits of a double differ from one processor or compiler to the next.
One case is exact, so that the layout the program chooses is pinned too.

--update writes stdout, stderr and files as the program gives them, and exit where there is none. What
a person has decided stays: comments and the other sections as they are; a run with another exit code
than the case asks for writes nothing, and an `expect` has to match nevertheless.

--setups FOLDER runs nothing, and writes the setup of every case into that folder as VERB-NAME.sh, for
those who look over shell scripts.
"""

import argparse
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import json_form
from case_file import BadCase, CaseFile

TIME_LIMIT_S = 300
HERE = pathlib.Path(__file__).resolve().parent

MASKS = [
    (re.compile(r'("seconds"\s*:\s*)[-+0-9.eE]+'), r"\1X"),
    (re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)? (s|ms)\b"), r"X \1"),
    (re.compile(r"^(tramline )?\d+\.\d+\.\d+$", re.MULTILINE), r"\1VERSION"),
]


class Run:
    """What one run of the program left behind, masked."""

    def __init__(self, exit_code, stdout, stderr, files, input_changes):
        self.exit_code = exit_code
        self.stdout = stdout
        self.stderr = stderr
        self.files = files
        self.input_changes = input_changes


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
            "TRAMLINE": program,
            "KEPT": pathlib.Path(program).resolve().parent / "kept-inputs",
            "INPUT": pathlib.Path(scratch).resolve() / "input",
            "OUT": pathlib.Path(scratch).resolve() / "out",
        }
        places["INPUT"].mkdir()
        places["OUT"].mkdir()
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "SOURCE_DATE_EPOCH": "1700000000"}
        if "setup.sh" in case.sections:
            script = pathlib.Path(scratch) / "setup.sh"
            script.write_bytes(case.sections["setup.sh"].encode("utf-8"))
            made = subprocess.run(["bash", "-euo", "pipefail", script], cwd=places["INPUT"],
                                  env={**environment, **{k: str(v) for k, v in places.items()}},
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
            if made.returncode != 0:
                raise BadCase(f"setup.sh failed ({made.returncode}):\n{made.stdout}{made.stderr}")
        before = contents_under(places["INPUT"])

        words = shlex.split(case.sections["command"], comments=True)
        arguments = [expanded(word, places) for word in words]
        done = subprocess.run([program, *arguments], cwd=places["OUT"], env=environment,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=TIME_LIMIT_S, check=False)
        after = contents_under(places["INPUT"])
        changes = sorted(n for n in before.keys() | after.keys() if before.get(n) != after.get(n))
        stdout = done.stdout.decode("utf-8", "replace")
        if "exact" not in case.sections:
            stdout = json_form.normalised(stdout)
        return Run(done.returncode, masked(stdout, places),
                   masked(done.stderr.decode("utf-8", "replace"), places), files_under(places["OUT"]), changes)


def first_difference(expected, found):
    for number, (a, b) in enumerate(zip(expected.splitlines() + [""], found.splitlines() + [""]), 1):
        if a != b:
            return f"line {number}\n    expected: {a}\n    found:    {b}"
    return "one of them goes on longer, or ends without a line feed"


def stream_faults(case, name, expect_name, found, expected_exit):
    for pattern in case.lines(expect_name):
        if not re.search(pattern, found, re.MULTILINE):
            yield f"{name} does not match /{pattern}/; found:\n{found}"
    golden = case.sections.get(name)
    if golden is not None:
        if golden != found:
            yield f"{name} differs in {first_difference(golden, found)}"
    elif expect_name not in case.sections:
        if expected_exit == 0:
            yield f"the case has no golden {name}; run with --update and read what it wrote"
        elif found:
            yield f"{name} is not empty:\n{found}"


def faults_of(case, run):
    """Yields one sentence for everything in the run that the case does not allow."""
    expected_exit = case.exit_code()
    if expected_exit is None:
        raise BadCase("there is no section '=== exit'")
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
    expected_files = sorted(case.lines("files"))
    if run.files != expected_files:
        yield f"files in $OUT: {run.files} instead of {expected_files}"
    if run.input_changes:
        yield f"the run changed its input: {run.input_changes}"


def take_goldens(case, run):
    """Puts what the run gave into the case."""
    def take(name, text, wanted):
        if wanted:
            case.sections[name] = text
        else:
            case.sections.pop(name, None)

    succeeded = run.exit_code == 0
    take("exit", f"{run.exit_code}\n", True)
    take("stdout", run.stdout, bool(run.stdout) or succeeded and "expect-stdout" not in case.sections)
    take("stderr", run.stderr, bool(run.stderr) or succeeded and "expect" not in case.sections)
    take("files", "".join(name + "\n" for name in run.files), bool(run.files))


def verdict(path, program, examples, update):
    """Returns the list of faults of the case in this file, empty if it passes."""
    try:
        case = CaseFile.read(path)
        run = run_case(case, program, examples)
        if update and case.exit_code() in (None, run.exit_code):
            take_goldens(case, run)
            case.write(path)
        return list(faults_of(case, run))
    except subprocess.TimeoutExpired:
        return [f"the program still ran after {TIME_LIMIT_S} s"]
    except (BadCase, OSError, ValueError) as error:
        return [f"the case cannot be run: {error}"]


def write_setups(paths, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for path in paths:
        case = CaseFile.read(path)
        if "setup.sh" in case.sections:
            script = folder / f"{path.parent.name}-{path.stem}.sh"
            script.write_bytes(case.sections["setup.sh"].encode("utf-8"))


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Runs golden command-line cases.")
    parser.add_argument("--tramline", type=pathlib.Path, help="the program")
    parser.add_argument("--examples", type=pathlib.Path, default=HERE.parents[1] / "examples")
    parser.add_argument("--update", action="store_true", help="write the goldens as the program gives them")
    parser.add_argument("--setups", type=pathlib.Path, metavar="FOLDER", help="only write the setups there")
    parser.add_argument("cases", nargs="*", type=pathlib.Path,
                        help="case files, or folders of them (default: all)")
    options = parser.parse_args(arguments)

    cases = []
    for path in options.cases or [HERE / "cases"]:
        cases += sorted(path.rglob("*.case")) if path.is_dir() else [path]
    if options.setups:
        write_setups(cases, options.setups)
        return 0
    if not options.tramline:
        parser.error("--tramline is missing")
    failed = 0
    for case in cases:
        faults = verdict(case.resolve(), options.tramline.resolve(), options.examples.resolve(), options.update)
        failed += bool(faults)
        print(f"{'FAIL' if faults else 'ok  '} {case.parent.name}/{case.stem}")
        for fault in faults:
            print("  " + fault.rstrip().replace("\n", "\n  "))
    print(f"{len(cases) - failed} of {len(cases)} cases pass")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
