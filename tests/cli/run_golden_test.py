#!/usr/bin/env python3
"""Tests the runner of the golden cases and the form of their files: what must fail has to be reported."""

import contextlib
import io
import pathlib
import re
import tempfile
import unittest

import json_form
import run_golden
from case_file import SECTIONS, BadCase, CaseFile

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
  say) cat "$2" ;;
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
        self.case = self.root / "a.case"

    def faults(self, update=False, comment="", **sections):
        """The faults of a case of these sections; setup_sh stands for setup.sh, and None for no section."""
        by_keyword = {re.sub("[.-]", "_", name): name for name in SECTIONS}
        named = {by_keyword[keyword]: text for keyword, text in sections.items() if text is not None}
        CaseFile(comment, named).write(self.case)
        return self.verdict(update)

    def verdict(self, update=False):
        return run_golden.verdict(self.case, self.program, self.root, update)

    def good(self, **changes):
        sections = {
            "command": "plan $INPUT/a.geojson $OUT/a.gpkg\n",
            "stdout": '{\n  "area_m2": 12.5,\n  "seconds": X\n}\n',
            "stderr": "read $INPUT/a.geojson in X s\n",
            "exit": "0\n",
            "files": "a.gpkg\n",
        }
        return self.faults(**{**sections, **changes})

    def test_a_case_that_holds_passes(self):
        self.assertEqual(self.good(), [])

    def test_what_differs_is_reported(self):
        for change in ({"stdout": '{\n  "area_m2": 12.6,\n  "seconds": X\n}\n'}, {"stderr": "read nothing\n"},
                       {"exit": "1\n"}, {"files": ""}, {"files": "a.gpkg\na.png\n"},
                       {"expect": "no such file\n"}, {"stdout": '{"area_m2": 12.5, "seconds": X}\n'},
                       {"stdout": '{\n  "area_m2": 12.5,\n  "seconds": X\n}'}):
            with self.subTest(change):
                self.assertEqual(len(self.good(**change)), 1)

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

    def test_a_case_without_an_exit_code_is_reported(self):
        self.assertTrue(self.good(exit=None))
        self.assertTrue(self.good(exit="success\n"))

    def test_update_writes_goldens_that_pass(self):
        self.assertEqual(self.faults(update=True, command="plan $INPUT/a.geojson $OUT/a.gpkg\n"), [])
        sections = CaseFile.read(self.case).sections
        self.assertEqual(sections["stdout"], '{\n  "area_m2": 12.5,\n  "seconds": X\n}\n')
        self.assertEqual(sections["files"], "a.gpkg\n")
        self.assertEqual(self.verdict(), [])

    def test_update_leaves_what_a_person_wrote(self):
        written = {"comment": "# Why it is here.\n\n", "command": "two x # x is not there\n", "exit": "2\n",
                   "setup_sh": "# nothing to make\n\ntrue\n", "expect": "# names it\nx\n",
                   "expect_stdout": "^$\n"}
        self.assertEqual(self.faults(update=True, **written), [])
        after = CaseFile.read(self.case)
        self.assertEqual(after.sections.pop("stderr"), "tramline: no such file: x\n")
        self.assertEqual(self.faults(**written), [])
        before = CaseFile.read(self.case)
        self.assertEqual((after.comment, after.sections), (before.comment, before.sections))

    def test_an_exact_case_pins_the_bytes(self):
        self.assertTrue(self.good(exact=""))
        self.assertEqual(self.good(exact="", stdout='{"area_m2": 12.5, "seconds": X}\n'), [])
        self.assertEqual(self.good(exact="", stdout="", update=True), [])
        self.assertEqual(CaseFile.read(self.case).sections["stdout"], '{"area_m2": 12.5, "seconds": X}\n')

    def test_json_is_compared_to_nine_digits(self):
        golden = '{\n  "area_m2": 1234.56789,\n  "bends": 2\n}\n'

        def fails(printed):
            setup = f"cat > said <<'END'\n{printed}\nEND\n"
            return bool(self.faults(command="say $INPUT/said", setup_sh=setup,
                                    exit="0", stdout=golden, stderr=""))

        for printed in ('{"area_m2":1234.56789,"bends":2}', '{"area_m2": 1234.567891, "bends": 2}',
                        '{"area_m2":1234.5678904,"bends":2}', '{"area_m2":1.23456789e3,\n"bends":2}'):
            self.assertFalse(fails(printed), printed)
        for printed in ('{"area_m2":1234.56799,"bends":2}', '{"area_m2":1234.56788,"bends":2}',
                        '{"bends":2,"area_m2":1234.56789}', '{"area_m2":1234.56789,"bends":2.0}',
                        '{"area_m2":1234.56789,"bends":3}', '{"area_m2":1234.56789}',
                        '{"area_m2":1234.56789,"bends":2}\n{"area_m2":1234.56789,"bends":2}'):
            self.assertTrue(fails(printed), printed)

    def test_update_takes_away_goldens_of_what_is_no_longer_said(self):
        stale = {"stdout": "x\n", "files": "x\n"}
        self.assertEqual(self.faults(update=True, command="two x", expect="x\n", **stale), [])
        self.assertEqual(list(CaseFile.read(self.case).sections), ["command", "exit", "expect", "stderr"])

    def test_update_does_not_hide_a_wrong_exit_code(self):
        written = {"command": "plan a $OUT/a.gpkg\n", "exit": "2\n", "expect": "a\n"}
        self.assertTrue(self.faults(update=True, **written))
        self.assertEqual(CaseFile.read(self.case).sections, written)

    def test_update_does_not_hide_an_unmet_expectation(self):
        self.assertTrue(self.faults(update=True, command="two x", expect="names the layer"))

    def test_the_exit_code_of_the_runner_tells(self):
        self.good()
        for cases in (self.case, self.root):
            call = ["--tramline", str(self.program), "--examples", str(self.root), str(cases)]
            with contextlib.redirect_stdout(io.StringIO()):
                self.good()
                self.assertEqual(run_golden.main(call), 0)
                self.good(exit="1\n")
                self.assertEqual(run_golden.main(call), 1)

    def test_setups_are_written_for_those_who_look_over_scripts(self):
        self.good(setup_sh="echo field > field\n")
        run_golden.main(["--setups", str(self.root / "setups"), str(self.case)])
        found = {path.name: path.read_text() for path in (self.root / "setups").iterdir()}
        self.assertEqual(found, {f"{self.root.name}-a.sh": "echo field > field\n"})


class CaseFileTest(unittest.TestCase):
    def test_a_case_is_written_for_people(self):
        case = CaseFile("# Why.\n", {"exit": "0\n", "stdout": "a\n\nb\n", "command": "plan\n"})
        self.assertEqual(case.written(), "# Why.\n=== command\nplan\n=== exit\n0\n=== stdout\na\n\nb\n")

    def test_any_content_survives(self):
        for content in ("", "\n", "\n\n", "a", "a\n", "a\n\n", "\na", " a \n", "#\n", "m²\n", "a\r\nb\rc\n",
                        "\f\v\x1c\u2028\n", "=== stdout\n", "===", "====\n", "a === b\n", "\\=== stdout\n",
                        "\\\\===", "\\", "\\b\n", "=== without a line feed\n",
                        "a\n=== without a line feed", "\\=== without a line feed\n"):
            for other in ("", "b", "b\n"):
                with self.subTest(content=content, other=other):
                    sections = {"command": other, "stderr": content, "stdout": other}
                    case = CaseFile.parsed(CaseFile("#\n", sections).written())
                    self.assertEqual((case.comment, case.sections), ("#\n", sections))

    def test_an_empty_section_is_not_a_missing_one(self):
        case = CaseFile.parsed("=== command\nplan\n=== stdout\n")
        self.assertEqual(case.sections, {"command": "plan\n", "stdout": ""})

    def test_sections_may_stand_in_any_order(self):
        case = CaseFile.parsed("=== exit\n0\n=== command\nplan\n")
        self.assertEqual(case.sections, {"command": "plan\n", "exit": "0\n"})

    def test_what_is_no_case_is_refused(self):
        for text in ("", "\n", "plan\n", "=== exit\n0\n",
                     "=== command\nplan\n=== stduot\n", "=== command\nplan\n===\n",
                     "=== command\nplan\n===stdout\n", "=== command\nplan\n=== stdout \n",
                     "=== command\nplan\n=== stdout\r\n", "=== command\nplan\n=== command\nplan\n",
                     "=== command\nplan\n=== exit\n0\n=== exit\n0\n",
                     "why\n=== command\nplan\n", "=== command\nplan", "=== command\nplan\n=== stdout",
                     "=== without a line feed\n=== command\nplan\n", "=== command\n=== without a line feed\n",
                     "=== command\nplan\n=== exact\nyes\n", "=== command\nplan\n=== exact\n\n",
                     "=== command\na\n=== without a line feed\nb\n",
                     "=== command\na\n=== without a line feed\n=== without a line feed\n"):
            with self.subTest(text), self.assertRaises(BadCase):
                CaseFile.parsed(text)

    def test_the_cases_of_the_project_are_written_as_update_writes_them(self):
        paths = sorted((run_golden.HERE / "cases").rglob("*.case"))
        self.assertGreater(len(paths), 100)
        for path in paths:
            with self.subTest(path.relative_to(run_golden.HERE)):
                self.assertEqual(CaseFile.read(path).written().encode(), path.read_bytes())

    def test_one_case_of_the_project_is_exact(self):
        cases = [CaseFile.read(path) for path in (run_golden.HERE / "cases").rglob("*.case")]
        exact = [case for case in cases if "exact" in case.sections]
        self.assertEqual(len(exact), 1)
        printed = exact[0].sections["stdout"].replace('"seconds":X', '"seconds":0')
        self.assertNotEqual(json_form.normalised(printed), printed)


class JsonFormTest(unittest.TestCase):
    def test_a_key_a_line(self):
        printed = '{"b":[{"x":1.50,"y":-0.0},{}],"a":[],"c":[1,2.5],"d":["m²",null,true]}\n'
        self.assertEqual(json_form.normalised(printed), """{
  "b": [
    {
      "x": 1.5,
      "y": -0.0
    },
    {}
  ],
  "a": [],
  "c": [1, 2.5],
  "d": [
    "m²",
    null,
    true
  ]
}
""")

    def test_the_tenth_digit_does_not_count_and_the_eighth_does(self):
        def form(number):
            return json_form.normalised(f'{{"cost":{number}}}\n')

        for a, b in (("1.234567891", "1.234567894"), ("-1.234567891e-12", "-1.234567894e-12"),
                     ("123456789.1", "123456789.4"), ("1e3", "1000.0")):
            self.assertEqual(form(a), form(b))
        for a, b in (("1.2345678", "1.2345679"), ("1.2345678e-12", "1.2345679e-12"), ("2", "2.0"),
                     ("1234567890123", "1234567890124"), ("1.5", "-1.5"), ("1.5", '"1.5"'), ("0", "false")):
            self.assertNotEqual(form(a), form(b))

    def test_the_order_of_keys_counts(self):
        self.assertNotEqual(json_form.normalised('{"a":1,"b":2}\n'), json_form.normalised('{"b":2,"a":1}\n'))

    def test_documents_stand_one_a_line(self):
        self.assertEqual(json_form.normalised('{"a":1}\n{"a":2}\n'), '{\n  "a": 1\n}\n{\n  "a": 2\n}\n')

    def test_its_own_form_stays(self):
        once = json_form.normalised('{"a":{"b":[[1.25,2],[]]},"c":"\\u0007 \\" m²"}\n')
        self.assertEqual(json_form.normalised(once), once)

    def test_what_is_not_json_stays_text(self):
        for text in ("", "\n", "3 fields\n", "12.50\n", '"a"\n', "null\n", '{"a":NaN}\n', '{"a":-Infinity}\n',
                     '{"a":Infinity}\n', '{"a":1e999}\n', '{"a":1,"a":1}\n', '{"a":1}', '{"a":1}\n\n',
                     ' {"a":1}\n', '{"a":1} \n', '{"a":1} {"a":2}\n', '{"a":1}\n3 fields\n',
                     '{"a":1}\n\n{"a":1}\n',
                     '{\n"a":1\n}\n{\n"a":2\n}\n', "{'a':1}\n", '{"a":1,}\n'):
            with self.subTest(text):
                self.assertEqual(json_form.normalised(text), text)


if __name__ == "__main__":
    unittest.main()
