#!/usr/bin/env python3
"""Tests the runner of the golden cases: what must fail has to be reported as failing."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import run_golden

# Stands in for the program: does what its first argument says.
FAKE = r"""#!/bin/bash
case "$1" in
  plan) echo '{"area_m2": 12.5, "seconds": 0.125}'; echo "read $2 in 0.2 s" >&2; echo x > "$3" ;;
  two) echo "tramline: no such file: $2" >&2; exit 2 ;;
  chatty) echo "half a result"; echo "tramline: no such file: $2" >&2; exit 2 ;;
  long) printf 'tramline: bad\nand more\n' >&2; exit 2 ;;
  litter) touch half-written.gpkg; echo "tramline: disk full" >&2; exit 1 ;;
  colour) printf '\033[31mred\033[0m\n' ;;
  spoil) echo "more" >> "$2" ;;
  version) echo 1.2.3 ;;
  crash) kill -SEGV $$ ;;
esac
"""


class RunnerTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        self.program = self.root / "fake"
        self.program.write_text(FAKE)
        self.program.chmod(0o755)
        self.case = self.root / "case"
        self.case.mkdir()

    def faults(self, update=False, **files):
        for name, text in files.items():
            (self.case / name.replace("_", ".", 1)).write_text(text)
        return run_golden.verdict(self.case, self.program, self.root, update)

    def good(self, **changes):
        files = {
            "command": "plan $CASE/a.geojson $OUT/a.gpkg",
            "stdout": '{"area_m2": 12.5, "seconds": X}\n',
            "stderr": "read $CASE/a.geojson in X s\n",
            "exit": "0\n",
            "files": "a.gpkg\n",
        }
        return self.faults(**{**files, **changes})

    def test_a_case_that_holds_passes(self):
        self.assertEqual(self.good(), [])

    def test_what_differs_is_reported(self):
        for change in ({"stdout": '{"area_m2": 12.6, "seconds": X}\n'}, {"stderr": "read nothing\n"}, {"exit": "1\n"},
                       {"files": ""}, {"files": "a.gpkg\na.png\n"}, {"expect": "no such file\n"},
                       {"stdout": '{"area_m2": 12.5, "seconds": X}'}):
            with self.subTest(change):
                self.assertEqual(len(self.good(**change)), 1)
            (self.case / "expect").unlink(missing_ok=True)

    def test_a_missing_golden_of_a_success_is_reported(self):
        self.assertEqual(len(self.faults(command="plan a $OUT/a.gpkg", exit="0", files="a.gpkg", expect="read")), 1)

    def test_bad_input_told_in_one_sentence_passes(self):
        self.assertEqual(self.faults(command="two missing.geojson", exit="2", expect="# names it\nmissing\\.geojson"), [])

    def test_an_expectation_that_is_not_met_is_reported(self):
        self.assertEqual(len(self.faults(command="two missing.geojson", exit="2", expect="other\\.geojson")), 1)

    def test_output_beside_a_refusal_is_reported(self):
        self.assertTrue(self.faults(command="chatty x", exit="2", expect="x"))

    def test_a_refusal_of_two_lines_is_reported(self):
        self.assertTrue(self.faults(command="long", exit="2", expect="bad"))

    def test_a_file_left_by_a_failed_run_is_reported(self):
        self.assertEqual(len(self.faults(command="litter", exit="1", expect="disk full")), 1)

    def test_colour_codes_are_reported(self):
        self.assertTrue(self.faults(command="colour", exit="0", stdout="\033[31mred\033[0m\n", stderr=""))

    def test_a_changed_input_is_reported(self):
        self.assertEqual(len(self.faults(command="spoil $INPUT/field", exit="0", stdout="", stderr="",
                                         setup_sh="echo field > field")), 1)

    def test_a_crash_is_reported_whatever_exit_says(self):
        self.assertTrue(self.faults(command="crash", exit="-11"))

    def test_the_version_is_masked(self):
        self.assertEqual(self.faults(command="version", exit="0", stdout="VERSION\n", stderr=""), [])

    def test_a_setup_that_fails_is_reported(self):
        self.assertTrue(self.faults(command="two x", exit="2", expect="x", setup_sh="false"))

    def test_an_unknown_place_is_reported(self):
        self.assertTrue(self.faults(command="two $NOWHERE", exit="2", expect="no such"))

    def test_update_writes_goldens_that_pass(self):
        self.assertEqual(self.faults(update=True, command="plan $CASE/a.geojson $OUT/a.gpkg"), [])
        self.assertEqual((self.case / "stdout").read_text(), '{"area_m2": 12.5, "seconds": X}\n')
        self.assertEqual((self.case / "files").read_text(), "a.gpkg\n")
        self.assertEqual(self.faults(), [])

    def test_update_does_not_hide_a_wrong_exit_code(self):
        self.assertTrue(self.faults(update=True, command="plan a $OUT/a.gpkg", exit="2", expect="a"))
        self.assertEqual(sorted(p.name for p in self.case.iterdir()), ["command", "exit", "expect"])

    def test_update_does_not_hide_an_unmet_expectation(self):
        self.assertTrue(self.faults(update=True, command="two x", expect="names the layer"))

    def test_the_exit_code_of_the_runner_tells(self):
        self.good()
        call = ["--tramline", str(self.program), "--examples", str(self.root), str(self.case)]
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(run_golden.main(call), 0)
            (self.case / "exit").write_text("1\n")
            self.assertEqual(run_golden.main(call), 1)


if __name__ == "__main__":
    unittest.main()
