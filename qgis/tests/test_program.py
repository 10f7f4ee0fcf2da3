"""What of the plugin needs no QGIS: command lines, progress, runs and their ends. Run by Python's unittest.

The environment variable TRAMLINE names the program.
"""

import os
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

# The modules below `program` alone: the package itself is loaded by QGIS.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tramline_processing"))

from program.find import ProgramMissing, find_program, version_of
from program.progress import ProgressReader, step_of
from program.run import Cancelled, RunFailed, run
from program.words import BadWords, words_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TRAMLINE = os.environ.get("TRAMLINE", "tramline")


class Words(unittest.TestCase):
    def test_values(self):
        options = {"width": 6.0, "radius": 5.25, "machine": "", "all": True, "one-file": False, "id": None, "with": ["a b", "c"]}
        self.assertEqual(
            words_of("plan", ["f.gpkg", ""], options, "--clearance 0.5 --ab '1,2 3,4'"),
            ["plan", "f.gpkg", "--width=6", "--radius=5.25", "--all", "--with=a b", "--with=c", "--clearance", "0.5", "--ab", "1,2 3,4"],
        )

    def test_numbers_keep_their_digits(self):
        self.assertEqual(words_of("plan", [], {"width": 0.1 + 0.2}), ["plan", "--width=0.30000000000000004"])

    def test_options_that_the_plugin_gives_are_refused(self):
        for typed, part in (
            ("--json", "--json"), ("-o x.gpkg", "-o"), ("--width=3", "--width"), ("nonsense", "nonsense"), ("--ab '1", "quotation"),
        ):
            with self.subTest(typed=typed), self.assertRaisesRegex(BadWords, part):
                words_of("plan", [], {"width": 6}, typed)


class Progress(unittest.TestCase):
    def setUp(self):
        self.steps, self.messages = [], []
        self.reader = ProgressReader(lambda step: self.steps.append((step.what, step.done, step.total)), self.messages.append)

    def test_lines_that_overwrite_one_another(self):
        text = "\rplanning north: 3 of 20 directions \rplanning north: 20 of 20 directions \r" + " " * 60 + "\rnorth is refused: 1 of 2\n"
        self.reader.feed(text.encode())
        self.reader.end()
        self.assertEqual(self.steps, [("planning north", 3, 20), ("planning north", 20, 20)])
        self.assertEqual(self.messages, ["north is refused: 1 of 2"])

    def test_bytes_come_in_any_pieces(self):
        text = "\rplanning Mühle: 7 of 9 directions \rplanned: 400 of 1000 fields, 12.3 fields/s, 49 s left \x1b[31mö\x1b[0m\n".encode()
        for cut in range(len(text)):
            self.setUp()
            self.reader.feed(text[:cut])
            self.reader.feed(text[cut:])
            self.reader.end()
            self.assertEqual([step[1] for step in self.steps if step[2] == 9], [7], cut)
            self.assertIn(("planned", 400, 1000), self.steps)

    def test_a_step_is_told_before_the_next_one_comes(self):
        self.reader.feed(b"\rplanning north: 3 of 20 directions ")
        self.assertEqual(self.steps, [("planning north", 3, 20)])

    def test_shares(self):
        self.assertEqual(step_of("a: 5 of 20 x").share, 0.25)
        self.assertEqual(step_of("a: 25 of 20 x").share, 1)
        self.assertEqual(step_of("a: 0 of 0 x").share, 0)


class Runs(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def program(self, code):
        """One that does what `code` says, in place of tramline."""
        file = self.folder / "program"
        file.write_text(f"#!{sys.executable} -S\nimport os, signal, sys, time\n{code}\n")
        file.chmod(file.stat().st_mode | stat.S_IXUSR)
        return str(file)

    def test_results_and_progress(self):
        steps, counts = [], []
        program = self.program(
            "sys.stderr.write('\\rplanning a: 1 of 2 directions ')\nsys.stderr.flush()\n"
            "assert sys.stderr.isatty() and not sys.stdout.isatty()\n"
            "print('{\"field_id\": \"a\"}\\n{\"field_id\": \"b\", \"error\": \"too small\"}')\nsys.exit(3)"
        )
        done = run(program, ["plan"], lambda step: steps.append(step.done), counts.append)
        self.assertEqual((done.code, [one["field_id"] for one in done.results]), (3, ["a", "b"]))
        self.assertEqual((steps, counts[-1]), ([1], 2))

    def test_an_object_over_many_lines(self):
        program = self.program("print('{\\n  \"ok\":\\n [1,\\n {}\\n]\\n}')")
        self.assertEqual(run(program, [], None).results, [{"ok": [1, {}]}])

    def test_a_failure_is_its_own_sentence(self):
        program = self.program("sys.exit('tramline: there is no file \\'x\\'; name one that is there')")
        with self.assertRaisesRegex(RunFailed, r"^There is no file 'x'; name one that is there$"):
            run(program, [], None)
        with self.assertRaisesRegex(RunFailed, "signal 9"):
            run(self.program("os.kill(os.getpid(), signal.SIGKILL)"), [], None)
        with self.assertRaisesRegex(RunFailed, "JSON"):
            run(self.program("print('hello')"), [], None)
        with self.assertRaisesRegex(RunFailed, "could not be started"):
            run(str(self.folder), [], None)

    def test_cancelled(self):
        """The process is gone, whatever it does with signals, and so is what it had not finished."""
        output = self.folder / "plan.gpkg"
        output.write_text("an older plan")
        program = self.program(
            "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
            f"open('{self.folder}/.plan.gpkg.%d-0.part' % os.getpid(), 'w').close()\nopen('{self.folder}/pid', 'w').write(str(os.getpid()))\n"
            "sys.stderr.write('\\rplanning a: 1 of 2 directions ')\nsys.stderr.flush()\ntime.sleep(60)"
        )
        steps = []
        start = time.monotonic()
        with self.assertRaises(Cancelled):
            run(program, ["plan", f"--output={output}"], steps.append, cancelled=lambda: bool(steps))
        self.assertLess(time.monotonic() - start, 30)
        with self.assertRaises(ProcessLookupError):
            os.kill(int((self.folder / "pid").read_text()), 0)
        self.assertEqual(list(self.folder.glob(".*")), [])
        self.assertEqual(output.read_text(), "an older plan")

    def test_the_program_ends_with_qgis(self):
        """Whoever runs it is killed, and it gets a SIGHUP."""
        program = self.program(f"open('{self.folder}/pid', 'w').write(str(os.getpid()))\ntime.sleep(60)")
        child = os.fork()
        if child == 0:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            run(program, [], None)
            os._exit(0)
        file = self.folder / "pid"
        while not (file.exists() and file.read_text()):
            time.sleep(0.01)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        until = time.monotonic() + 20
        while _lives(int(file.read_text())) and time.monotonic() < until:
            time.sleep(0.01)
        self.assertFalse(_lives(int(file.read_text())))


def _lives(pid):
    """A process that ended and that nobody has asked about is a zombie."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Program(unittest.TestCase):
    def test_the_program_itself(self):
        program = find_program(TRAMLINE)
        self.assertRegex(version_of(program), r"^tramline \d+\.\d+\.\d+$")
        field = ROOT / "examples/narrow-parcel.geojson"
        done = run(program, words_of("plan", [field], {"width": 6, "prices": "0.02,0.1,1", "json": True}), None)
        self.assertGreater(done.results[0]["tracks"], 0)
        with self.assertRaisesRegex(RunFailed, "none.gpkg"):
            run(program, words_of("plan", ["none.gpkg"], {"width": 6, "json": True}), None)

    def test_a_bad_path(self):
        with self.assertRaisesRegex(ProgramMissing, "There is no program '/nowhere/tramline'. Choose it under Settings"):
            find_program("/nowhere/tramline")
        with self.assertRaisesRegex(ProgramMissing, "is not a program"):
            find_program(str(ROOT))
        with self.assertRaisesRegex(ProgramMissing, "is not the program tramline"):
            version_of("/bin/ls")


class Zip(unittest.TestCase):
    def test_holds_all_of_the_plugin_in_the_version_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("one.zip", "two.zip"):
                subprocess.run([ROOT / "tools/qgis_plugin.sh", f"{folder}/{name}"], check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(pathlib.Path(folder, "one.zip").read_bytes(), pathlib.Path(folder, "two.zip").read_bytes())
            with zipfile.ZipFile(f"{folder}/one.zip") as plugin:
                names = plugin.namelist()
                metadata = plugin.read("tramline_processing/metadata.txt").decode()
        own = [file.relative_to(ROOT / "qgis").as_posix() for file in (ROOT / "qgis/tramline_processing").rglob("*.py")]
        self.assertLessEqual({*own, "tramline_processing/LICENSE", "tramline_processing/icon.svg"}, set(names))
        self.assertIn(f"\nversion={version_of(find_program(TRAMLINE)).split()[1]}\n", metadata)


if __name__ == "__main__":
    unittest.main()
