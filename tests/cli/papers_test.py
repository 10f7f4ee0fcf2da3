#!/usr/bin/env python3
"""docs/papers is what `make papers` writes: its inputs, a few of its tables, and its pages, which show what the tables have.

usage: papers_test.py --tramline PROGRAM --root REPOSITORY
"""
import argparse
import csv
import pathlib
import re
import sys
import tempfile
import unittest

ARGUMENTS = argparse.Namespace(tramline="tramline", root=pathlib.Path("."))
QUICK = ["zhang-table-1", "zhang-table-1-printed", "versleijen-table-6", "versleijen-table-14"]


def kept():
    return ARGUMENTS.root / "docs/papers"


class Papers(unittest.TestCase):
    def assert_same_files(self, folder, committed, names):
        for name in names:
            with self.subTest(name):
                self.assertEqual((folder / name).read_text(encoding="utf-8"), (committed / name).read_text(encoding="utf-8"),
                                 "run `make papers`")

    def test_inputs_are_drawn_as_committed(self):
        from papers import __main__ as papers
        committed = ARGUMENTS.root / "examples/papers"
        with tempfile.TemporaryDirectory() as folder:
            papers.write_inputs(pathlib.Path(folder))
            drawn = sorted(file.name for file in pathlib.Path(folder).iterdir())
            self.assertEqual(drawn, sorted(file.name for file in committed.iterdir()))
            self.assert_same_files(pathlib.Path(folder), committed, drawn)

    def test_quick_tables_are_as_committed(self):
        from papers import __main__ as papers
        from papers.program import Program
        with tempfile.TemporaryDirectory() as folder:
            papers.write_tables(Program(ARGUMENTS.tramline), pathlib.Path(folder), QUICK)
            self.assert_same_files(pathlib.Path(folder), kept() / "tables", [f"{name}.csv" for name in QUICK])

    def test_the_exact_engine_finds_the_areas_of_the_routes(self):
        """Against polygon booleans, not against what was committed."""
        with open(kept() / "tables/zhang-table-1.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 11)
        for row in rows:
            for area in ("coverage m²", "repeated m²", "leakage m²"):
                self.assertAlmostEqual(float(row[area]), float(row[f"{area}, exact engine"]), delta=0.006)

    def test_pages_show_every_table(self):
        from papers import __main__ as papers
        self.assertEqual(sorted(file.stem for file in (kept() / "tables").iterdir()), sorted(papers.TABLES))
        for name in papers.TABLES:
            page = (kept() / f"{name.split('-')[0]}.md").read_text(encoding="utf-8")
            with open(kept() / f"tables/{name}.csv", newline="", encoding="utf-8") as file:
                for row in list(csv.reader(file))[1:]:
                    self.assertIn("| " + " | ".join(row) + " |", page, name)

    def test_pictures_are_shown_and_there(self):
        pages = "".join(file.read_text(encoding="utf-8") for file in kept().glob("*.md"))
        shown = set(re.findall(r"\(pictures/([^)]+)\)", pages))
        self.assertEqual(shown, {file.name for file in (kept() / "pictures").iterdir()})


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--root", required=True, type=pathlib.Path)
    ARGUMENTS = parser.parse_args()
    sys.path.insert(0, str(ARGUMENTS.root / "tools"))
    unittest.main(argv=sys.argv[:1])
