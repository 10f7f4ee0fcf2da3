#!/usr/bin/env python3
"""Drives `tramline watch` as a user would: through every kind of source, killed and taken up again, with a
full disk and with all that may be wrong, and compares what it says with `tramline evaluate` on the same lines.

Usage: watch_test.py --tramline PROGRAM --examples FOLDER [--kills N] [--seed N] [unittest arguments]
"""

import argparse
import csv
import fcntl
import functools
import gzip
import json
import math
import operator
import os
import pathlib
import pty
import random
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unittest

OPTIONS = argparse.Namespace()
PATIENCE_S = 60

AREAS = ["gross_m2", "covered_m2", "covered_inside_m2", "outside_m2", "repeated_m2", "sliver_m2", "missed_m2",
         "worked_once_m2", "worked_twice_m2", "worked_more_m2"]
EXACT = ["field_id", "fixes", "fixes_used", "skipped_count", "runs", "missed_regions"]


def sentence(body):
    return f"${body}*{functools.reduce(operator.xor, body.encode()):02X}"


def degrees(value, whole, positive, negative):
    side = positive if value >= 0 else negative
    minutes = abs(value) * 60
    return f"{int(minutes // 60):0{whole}d}{minutes % 60:011.8f},{side}"


def epoch(second, lon, lat, talker="GP"):
    """GGA and RMC of one place, `second` of a day in May 2026."""
    clock = f"{int(second) // 3600:02d}{int(second) % 3600 // 60:02d}{second % 60:06.3f}"
    place = f"{degrees(lat, 2, 'N', 'S')},{degrees(lon, 3, 'E', 'W')}"
    return [sentence(f"{talker}GGA,{clock},{place},4,12,0.8,30.0,M,46.0,M,1.0,0000"),
            sentence(f"{talker}RMC,{clock},A,{place},3.9,,060526,,,D")]


def nmea_drive(fixes=600, step_s=0.5):
    """Passes up and down beside one another on the example field; lines without their ends."""
    out = []
    for i in range(fixes):
        along, lane = i % 150, i // 150
        up = along if lane % 2 == 0 else 150 - along
        lon = 9.1500 + (lane * 4.5 + 0.1 * math.sin(i)) / 67500
        lat = 52.6930 + up / 111200
        out += epoch(28800 + i * step_s, lon, lat)
    return out


def same(test, watched, evaluated, share=1e-6):
    test.assertGreater(evaluated["covered_m2"], 0)
    for key in EXACT:
        test.assertEqual(watched[key], evaluated[key], key)
    for key in AREAS:
        if evaluated[key] is None:
            test.assertIsNone(watched[key], key)
        else:
            test.assertLessEqual(abs(watched[key] - evaluated[key]), share * evaluated["covered_m2"], key)


class Watch:
    """A running watch."""

    def __init__(self, arguments, stdin=subprocess.DEVNULL, **more):
        self.process = subprocess.Popen([OPTIONS.tramline, "watch", "--json", *arguments], stdin=stdin,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)
        self.lines, self.errors = [], []
        self.heard, self.open_streams = threading.Condition(), 2
        self.readers = [threading.Thread(target=self.read, args=pair, daemon=True)
                        for pair in ((self.process.stdout, self.lines), (self.process.stderr, self.errors))]
        for reader in self.readers:
            reader.start()

    def read(self, stream, lines):
        for line in stream:
            with self.heard:
                lines.append(line)
                self.heard.notify_all()
        with self.heard:
            self.open_streams -= 1
            self.heard.notify_all()

    def figures(self):
        return json.loads(self.lines[-1]) if self.lines else {"fixes": 0}

    def until(self, true, what):
        """Waits until something holds of what the watch has said; `true` is asked again after every line."""
        with self.heard:
            self.heard.wait_for(lambda: true() or self.open_streams == 0, PATIENCE_S)
            if not true():
                raise AssertionError(f"waited in vain for {what}; it said {self.lines[-1:]} {self.errors}")

    def until_fixes(self, fixes):
        self.until(lambda: self.figures()["fixes"] >= fixes, f"{fixes} fixes")

    def until_said(self, words):
        self.until(lambda: any(words in line for line in self.errors), f"'{words}'")

    def end(self, how=None):
        """The exit code, and the last line."""
        if how is not None:
            self.process.send_signal(how)
        code = self.process.wait(PATIENCE_S)
        for reader in self.readers:
            reader.join(PATIENCE_S)
        self.process.stdout.close()
        self.process.stderr.close()
        return code, (json.loads(self.lines[-1]) if self.lines else None)


def evaluate(path, *arguments):
    done = subprocess.run([OPTIONS.tramline, "evaluate", path, "--json", *arguments], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


def real_data(test):
    folder = pathlib.Path(os.environ.get("TRAMLINE_DATA", OPTIONS.examples + "/../../shared/data"))
    if not (folder / "logs").is_dir():
        test.skipTest(f"no real logs in {folder}; set TRAMLINE_DATA")
    return folder


def free_port(kind=socket.SOCK_STREAM):
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="tramline-watch-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.field = ["--field", f"{OPTIONS.examples}/riverside.geojson"]
        self.csv = pathlib.Path(OPTIONS.examples) / "riverside-drive.csv"
        self.options = [*self.field, "--width", "5"]
        self.write_nmea(nmea_drive())
        self.started = []
        self.addCleanup(self.stop_all)

    def write_nmea(self, lines):
        """`lines`: two for each place, as of epoch()."""
        self.nmea = self.folder / "drive.nmea"
        self.nmea.write_text("".join(line + "\r\n" for line in lines))
        # The last place comes out with the end of the stream.
        self.known = len(lines) // 2 - 1

    def watch(self, *arguments, **more):
        out = Watch([*arguments], **more)
        self.started.append(out)
        return out

    def stop_all(self):
        for one in self.started:
            if one.process.poll() is None:
                one.process.kill()
                one.end()

    def refused(self, words, *arguments, **more):
        done = subprocess.run([OPTIONS.tramline, "watch", *arguments], capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL, timeout=PATIENCE_S, **more)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, f"^tramline: [^\n]*{words}[^\n]*\n$")


class Threads(Case):
    def test_any_number_gives_the_same_bytes(self):
        said, written = [], []
        for threads in (1, 2, 4):
            file = self.folder / f"{threads}.gpkg"
            with self.csv.open() as lines:
                watch = self.watch(*self.field, "--threads", str(threads), "-o", str(file), stdin=lines,
                                   env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
                code, last = watch.end()
            self.assertEqual(code, 0, watch.errors)
            del last["seconds"]
            said.append(last)
            written.append(file.read_bytes())
        self.assertGreater(said[0]["covered_m2"], 0)
        self.assertEqual(said[1:], said[:-1])
        self.assertTrue(written[0] == written[1] == written[2])


class Sources(Case):
    """The same lines by every road give what `evaluate` gives for the file."""

    def ended(self, watch, evaluated, how=None, share=1e-6):
        code, last = watch.end(how)
        self.assertEqual(code, 0, watch.errors)
        self.assertTrue(last["final"] and last["settled"])
        same(self, last, evaluated, share)

    def test_stdin(self):
        for path, options in ((self.csv, self.field), (self.nmea, self.options)):
            with path.open() as lines:
                self.ended(self.watch(*options, stdin=lines), evaluate(path, *options))

    def test_by_meshes(self):
        options = [*self.field, "--engine", "mesh", "--mesh", "0.1", "--repeat", "strict"]
        with self.csv.open() as lines:
            code, last = self.watch(*options, stdin=lines).end()
        self.assertEqual(code, 0)
        evaluated = evaluate(self.csv, *options)
        same(self, last, evaluated, 0)
        self.assertEqual(last["engine"], "mesh")
        self.assertEqual(last["meshes"], evaluated["meshes"])
        self.assertGreater(last["meshes"]["missed"]["most"], 1000)

    def test_headings_that_contradict_the_way(self):
        # To the north and back to the south, 2 m a second, with angles anticlockwise from east.
        path = self.folder / "angles.csv"
        rows = [(2 * i, 90) for i in range(40)] + [(80 - 2 * i, 270) for i in range(40)]
        path.write_text("time,x,y,heading,width_m\n" + "".join(
            f"2026-05-06T08:{i // 60:02d}:{i % 60:02d}Z,{6 * (heading // 180)},{y},{heading},6\n"
            for i, (y, heading) in enumerate(rows)))
        for reading, wrong in (("compass", True), ("math", False), ("from-track", False)):
            options = ["--log-crs", "none", "--headings", reading]
            with path.open() as lines:
                code, last = self.watch(*options, stdin=lines).end()
            self.assertEqual(code, 0)
            evaluated = evaluate(path, *options)
            same(self, last, evaluated)
            self.assertEqual(last["warnings"], evaluated["warnings"])
            self.assertEqual(last.get("headings"), evaluated.get("headings"))
            self.assertEqual("headings" in last, wrong, reading)
            if wrong:
                self.assertEqual(last["headings"]["better"], "math")

    def test_a_file_being_written(self):
        path = self.folder / "growing.nmea"
        text = self.nmea.read_text()
        with path.open("w") as growing:
            watch = self.watch("--follow", str(path), *self.options)
            growing.write(text[:10007])  # within a line
            growing.flush()
            watch.until_fixes(50)
            growing.write(text[10007:])
            growing.flush()
            watch.until_fixes(self.known)
        self.ended(watch, evaluate(path, *self.options), signal.SIGINT)

    def test_tcp(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            watch = self.watch("--tcp", f"127.0.0.1:{server.getsockname()[1]}", "--once", *self.options)
            peer, _ = server.accept()
            with peer:
                peer.sendall(self.nmea.read_bytes())
        self.ended(watch, evaluate(self.nmea, *self.options))

    def test_a_lost_connection_is_made_again(self):
        lines = self.nmea.read_bytes().splitlines(keepends=True)
        with socket.create_server(("127.0.0.1", 0)) as server:
            watch = self.watch("--tcp", f"127.0.0.1:{server.getsockname()[1]}", *self.options)
            peer, _ = server.accept()
            peer.sendall(b"".join(lines[:400]) + b"$GPGGA,cut")
            watch.until_fixes(199)
            peer.close()
            watch.until_said("is lost")
            peer, _ = server.accept()
            peer.sendall(b"".join(lines[400:]))
            watch.until_said("there again")
            watch.until_fixes(self.known)
            peer.close()
            self.ended(watch, evaluate(self.nmea, *self.options), signal.SIGTERM)

    def test_udp(self):
        port = free_port(socket.SOCK_DGRAM)
        watch = self.watch("--udp", str(port), *self.options)
        watch.until(lambda: watch.lines, "the first line")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            for line in self.nmea.read_bytes().splitlines():
                sender.sendto(line, ("127.0.0.1", port))
                time.sleep(0.0005)
        watch.until_fixes(self.known)
        self.ended(watch, evaluate(self.nmea, *self.options), signal.SIGINT)

    def test_serial(self):
        ours, theirs = pty.openpty()
        try:
            watch = self.watch("--serial", f"{os.ttyname(theirs)},38400", *self.options)
            watch.until(lambda: watch.lines, "the first line")
            mode = termios.tcgetattr(theirs)
            self.assertEqual(mode[5], termios.B38400)
            self.assertFalse(mode[3] & (termios.ICANON | termios.ECHO))
            for line in self.nmea.read_bytes().splitlines(keepends=True):
                os.write(ours, line)
            watch.until_fixes(self.known)
            self.ended(watch, evaluate(self.nmea, *self.options), signal.SIGINT)
        finally:
            os.close(ours)
            os.close(theirs)

    def test_a_serial_device_that_is_unplugged(self):
        ours, theirs = pty.openpty()
        watch = self.watch("--serial", os.ttyname(theirs), "--once", *self.options)
        watch.until(lambda: watch.lines, "the first line")
        for line in self.nmea.read_bytes().splitlines(keepends=True):
            os.write(ours, line)
        watch.until_fixes(self.known)
        os.close(theirs)
        os.close(ours)
        self.ended(watch, evaluate(self.nmea, *self.options))
        self.assertTrue(any("is unplugged" in line for line in watch.errors))

    @unittest.skipUnless(shutil.which("gpsfake") and shutil.which("gpsd", path=os.environ["PATH"] + ":/usr/sbin"),
                         "no gpsd or gpsfake here: apt-get install gpsd gpsd-clients")
    def test_gpsd(self):
        port = free_port()
        # What is fed before the client listens is nobody's.
        fed = self.folder / "fed.nmea"
        fed.write_text((sentence("GPGSV,1,1,00") + "\r\n") * 1500 + self.nmea.read_text())
        faked = subprocess.Popen(["gpsfake", "-q", "-1", "-P", str(port), "-c", "0.002", str(fed)],
                                 stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env={**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin"},
                                 start_new_session=True)
        try:
            for _ in range(500):
                with socket.socket() as probe:
                    if probe.connect_ex(("127.0.0.1", port)) == 0:
                        break
                time.sleep(0.01)
            watch = self.watch("--gpsd", f"127.0.0.1:{port}", *self.options)
            watch.until_fixes(self.known)
            self.ended(watch, evaluate(self.nmea, *self.options), signal.SIGINT, 1e-3)
        finally:
            if faked.poll() is None:
                os.killpg(faked.pid, signal.SIGKILL)
                faked.wait(PATIENCE_S)


class RealDrive:
    """A combine harvester's recorded drive, as its receiver would have told it."""

    def setUp(self):
        super().setUp()
        data = real_data(self)
        places = []
        with (data / "logs" / "isoxml_sh2020_TLG00003.csv").open() as rows:
            for row in csv.DictReader(rows):
                hour, minute, second = row["time"].split("T")[1].split(":")
                places.append((int(hour) * 3600 + int(minute) * 60 + float(second), float(row["lon"]), float(row["lat"])))
        self.write_nmea([line for place in places for line in epoch(*place)])
        self.options = ["--field", str(data / "fields" / "fields.geojson"), "--where",
                        "id='iso-timelogs/ValidTimeLogs-PFD-4'", "--width", "9"]


class RealSources(RealDrive, Sources):
    """A real drive by every road."""

    def test_real_logs(self):
        """Columns of all kinds, strays, sections that are none, widths in feet."""
        for path in sorted((real_data(self) / "logs").glob("*.csv*")):
            with self.subTest(path.name):
                plain = self.folder / path.name.removesuffix(".gz")
                plain.write_bytes(gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes())
                with plain.open() as lines:
                    self.ended(self.watch("--width", "6", stdin=lines), evaluate(plain, "--width", "6"))


class Output(Case):
    def test_killed_and_taken_up_again(self):
        """At random moments; with --follow all of the file is there in the end."""
        dice = random.Random(OPTIONS.seed)
        print(f"seed {OPTIONS.seed}", file=sys.stderr)
        path, out = self.folder / "growing.nmea", self.folder / "out.gpkg"
        text = self.nmea.read_bytes()
        arguments = ["--follow", str(path), *self.options, "-o", str(out), "--save-every", "1"]
        with path.open("wb") as growing:
            written = 0
            for kill in range(OPTIONS.kills):
                watch = self.watch(*arguments)
                part = len(text) * (kill + 1) // OPTIONS.kills
                pause = dice.random() * 2.5 / max(1, (part - written) // 997)
                while written < part:
                    growing.write(text[written:written + 997])
                    growing.flush()
                    written += 997
                    time.sleep(pause)
                time.sleep(dice.random() * 0.1)
                watch.end(signal.SIGKILL)
            growing.write(text[written:])
        lines = pathlib.Path(f"{out}.log").read_bytes().count(b"\n") if pathlib.Path(f"{out}.log").exists() else 0
        watch = self.watch(*arguments)
        watch.until_fixes(self.known)
        code, last = watch.end(signal.SIGINT)
        self.assertEqual(code, 0, watch.errors)
        if lines > 0:
            self.assertTrue(any(f"going on with {out}.log: {lines} lines" in line for line in watch.errors))
        same(self, last, evaluate(path, *self.options))
        same(self, last, evaluate(f"{out}.log", *self.options))
        self.assertEqual(pathlib.Path(f"{out}.log").read_bytes(), text)
        info = subprocess.run(["ogrinfo", "-ro", "-q", str(out), "-sql",
                               "select value from metadata where key = 'areas.covered_m2'"],
                              capture_output=True, text=True, check=True).stdout
        self.assertIn(f"{last['covered_m2']:.6f}"[:9], info)

    def test_no_more_than_a_second_is_lost(self):
        """What was sent a second before the kill is there."""
        out = self.folder / "out.gpkg"
        lines = self.nmea.read_bytes().splitlines(keepends=True)
        watch = self.watch(*self.options, "-o", str(out), stdin=subprocess.PIPE)
        os.write(watch.process.stdin.fileno(), b"".join(lines[:500]))
        time.sleep(1)
        os.write(watch.process.stdin.fileno(), lines[500][:20])
        watch.end(signal.SIGKILL)
        log = pathlib.Path(f"{out}.log")
        self.assertEqual(log.read_bytes(), b"".join(lines[:500]))
        # Power fails within a line.
        log.write_bytes(b"".join(lines[:500]) + lines[500][:20])
        watch = self.watch(*self.options, "-o", str(out), stdin=subprocess.PIPE)
        os.write(watch.process.stdin.fileno(), b"".join(lines[500:]))
        watch.process.stdin.close()
        code, last = watch.end()
        self.assertEqual(code, 0, watch.errors)
        same(self, last, evaluate(self.nmea, *self.options))
        self.assertEqual(log.read_bytes(), self.nmea.read_bytes())

    def test_the_second_watch_is_refused(self):
        out = str(self.folder / "out.gpkg")
        watch = self.watch(*self.options, "-o", out, stdin=subprocess.PIPE)
        watch.until(lambda: watch.lines, "the first line")
        self.refused("is being written by another watch", *self.options, "-o", out)
        watch.process.stdin.write(self.nmea.read_text())
        watch.process.stdin.close()
        code, last = watch.end()
        self.assertEqual((code, last["fixes"]), (0, self.known + 1))

    def test_a_full_disk(self):
        """Says so once, goes on measuring, and has everything in the log when there is room again."""
        out = self.folder / "out.gpkg"
        lines = self.nmea.read_bytes().splitlines(keepends=True)
        watch = self.watch(*self.options, "-o", str(out), "--save-every", "1", stdin=subprocess.PIPE)
        pid, pipe = watch.process.pid, watch.process.stdin.fileno()
        hard = resource.prlimit(pid, resource.RLIMIT_FSIZE)[1]
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (20000, hard))
        os.write(pipe, b"".join(lines[:1000]))
        watch.until_said("out.gpkg.log cannot be written")
        watch.until_fixes(499)
        # It tries to write as often as it says how far it is.
        told = len(watch.lines)
        watch.until(lambda: len(watch.lines) >= told + 3, "three more lines")
        said = [line for line in watch.errors if "out.gpkg.log cannot be written" in line]
        self.assertEqual(len(said), 1, watch.errors)
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (hard, hard))
        watch.until_said("lacks nothing")
        os.write(pipe, b"".join(lines[1000:]))
        watch.process.stdin.close()
        code, last = watch.end()
        self.assertEqual(code, 0, watch.errors)
        same(self, last, evaluate(self.nmea, *self.options))
        self.assertEqual(pathlib.Path(f"{out}.log").read_bytes(), self.nmea.read_bytes())

    def test_without_output_nothing_is_written(self):
        with self.nmea.open() as lines:
            watch = self.watch(*self.options, stdin=lines, cwd=self.folder)
            self.assertEqual(watch.end()[0], 0)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["drive.nmea"])


class RealOutput(RealDrive, Output):
    """A real drive, killed and taken up again."""


class Work(Case):
    def test_lines_on_work(self):
        lines = nmea_drive(300)
        lines.insert(200, "#work=0")
        lines.insert(300, "#work=1")
        path = self.folder / "stated.nmea"
        path.write_text("".join(line + "\n" for line in lines))
        with path.open() as stream:
            watch = self.watch(*self.options, stdin=stream)
        code, last = watch.end()
        self.assertEqual(code, 0, watch.errors)
        same(self, last, evaluate(path, *self.options))
        self.assertEqual(last["runs"], 2)
        # 50 of 300 steps of 1 m were not worked.
        self.assertLess(last["gross_m2"], 0.86 * evaluate(self.nmea, *self.options)["gross_m2"])

    def test_the_space_key(self):
        """On a terminal; and what it said stands in the raw log, so that `evaluate` says the same."""
        ours, theirs = pty.openpty()
        before = termios.tcgetattr(theirs)
        out, path = self.folder / "out.gpkg", self.folder / "growing.nmea"
        lines = nmea_drive(300)

        def own_terminal():
            os.setsid()
            fcntl.ioctl(0, termios.TIOCSCTTY, 0)

        with path.open("w") as growing:
            process = subprocess.Popen([OPTIONS.tramline, "watch", "--follow", str(path), *self.options, "-o",
                                        str(out)], stdin=theirs, stdout=theirs, stderr=theirs,
                                       preexec_fn=own_terminal)
            seen = []
            reader = threading.Thread(target=self.read_terminal, args=(ours, seen), daemon=True)
            reader.start()

            def until(words):
                end = time.monotonic() + PATIENCE_S
                while words not in b"".join(seen):
                    self.assertLess(time.monotonic(), end, b"".join(seen))
                    time.sleep(0.02)

            growing.write("\n".join(lines[:200]) + "\n")
            growing.flush()
            until(b"work on (space)")
            os.write(ours, b" ")
            log = pathlib.Path(f"{out}.log")
            end = time.monotonic() + PATIENCE_S
            while "#!work=0\n" not in log.read_text():
                self.assertLess(time.monotonic(), end)
                time.sleep(0.02)
            growing.write("\n".join(lines[200:]) + "\n")
            growing.flush()
            until(b"work off (space)")
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(PATIENCE_S), 0)
        self.assertEqual(termios.tcgetattr(theirs)[3], before[3], "the terminal is as it was")
        os.close(theirs)
        os.close(ours)
        worked = evaluate(log, *self.options)
        # The first 100 fixes, and half a step where the work ends, are 5 m wide.
        self.assertAlmostEqual(worked["gross_m2"], 99 * 5, delta=15)
        watch = self.watch("--follow", str(path), *self.options, "-o", str(out))
        watch.until_fixes(299)
        code, last = watch.end(signal.SIGINT)
        self.assertEqual(code, 0, watch.errors)
        same(self, last, evaluate(log, *self.options))

    @staticmethod
    def read_terminal(descriptor, seen):
        try:
            while True:
                seen.append(os.read(descriptor, 4096))
        except OSError:
            pass


class Ahead(Case):
    """A square of about 100 m, driven into from its southern edge, one row of a table a second at 2 m/s."""

    def setUp(self):
        super().setUp()
        east, north = 1 / (111320 * math.cos(math.radians(52))), 1 / 111250
        ring = [[10 + x * east, 52 + y * north] for x, y in [(0, 0), (100, 0), (100, 100), (0, 100), (0, 0)]]
        self.square = self.folder / "square.geojson"
        self.square.write_text(json.dumps({"type": "Feature", "properties": {"id": "square"},
                                           "geometry": {"type": "Polygon", "coordinates": [ring]}}))
        self.rows = ["time,lon,lat,heading,speed_mps,width_m,sections"]
        for second in range(8):
            self.rows.append(f"{second},{10 + 50 * east:.9f},{52 + (86 + 2 * second) * north:.9f},0,2,3|3,11")

    def ahead_after(self, rows, *options):
        watch = self.watch("--field", str(self.square), "--look-ahead", *options, stdin=subprocess.PIPE, bufsize=0)
        watch.process.stdin.write("".join(row + "\n" for row in rows))
        watch.until(lambda: watch.figures().get("ahead"), "what lies ahead")
        out = watch.figures()["ahead"]
        watch.process.stdin.close()
        code, last = watch.end()
        self.assertEqual(code, 0, watch.errors)
        self.assertNotIn("ahead", last)
        return out

    def test_the_edge_of_the_field(self):
        """After four rows the boom is 8 m from the edge: 4 s, and the command 0.4 s earlier."""
        for section in self.ahead_after(self.rows[:5], "--off-latency", "0.4"):
            self.assertTrue(section["on"])
            self.assertEqual(section["over"], "open")
            self.assertAlmostEqual(section["need"], 1, 6)
            self.assertFalse(section["next"]["on"])
            self.assertEqual(section["next"]["over"], "outside")
            self.assertAlmostEqual(section["next"]["ahead_m"], 8, 1)
            self.assertAlmostEqual(section["next"]["effect_s"], 4, 1)
            self.assertAlmostEqual(section["next"]["command_s"], 3.6, 1)

    def test_no_further_than_the_horizon(self):
        self.assertEqual([section["next"] for section in self.ahead_after(self.rows[:5], "--horizon", "2")], [None, None])

    def test_rules_that_make_no_sense(self):
        self.refused("share from which a section is switched on", *self.field, "--look-ahead", "--on-from", "0.3", "--off-below", "0.6")
        self.refused("longer than either", *self.field, "--look-ahead", "--on-latency", "9")


class Faults(Case):
    def test_sources_that_cannot_be_opened(self):
        with socket.socket(socket.AF_INET6, socket.SOCK_DGRAM) as taken:
            taken.bind(("::", 0))
            self.refused("--udp .* the port cannot be opened .*another program", "--udp",
                         str(taken.getsockname()[1]), *self.options)
        port = free_port()
        self.refused("nothing answers at 127.0.0.1", "--tcp", f"127.0.0.1:{port}", *self.options, "-o",
                     str(self.folder / "out.gpkg"))
        self.assertEqual([p.name for p in self.folder.iterdir()], ["drive.nmea"], "nothing is left behind")
        self.refused("gpsd does not answer; is it running", "--gpsd", f"127.0.0.1:{port}", *self.options)
        self.refused("there is no host 'nobody.invalid'", "--tcp", "nobody.invalid:1", *self.options)
        self.refused("'/dev/null' cannot be opened: it is no serial device", "--serial", "/dev/null", *self.options)

    def test_a_stream_with_all_that_goes_wrong(self):
        """Stops within a line, stands still, jumps, repeats, goes back in time, changes talker."""
        lines = nmea_drive(200)
        lines[100] = lines[100][:33]
        lines += lines[-6:]
        lines += epoch(28800 + 101, 9.3, 52.8)
        lines += epoch(28800 + 60, 9.1501, 52.6932)
        for i in range(80):
            lines += epoch(28800 + 200 + i, 9.1502, 52.6930 + i / 111200, "GN" if i % 2 else "GL")
        path = self.folder / "wrong.nmea"
        path.write_text("\n".join(lines) + "\n$GPGGA,0801")
        with path.open() as stream:
            watch = self.watch(*self.options, stdin=stream)
        code, last = watch.end()
        self.assertEqual(code, 0, watch.errors)
        evaluated = evaluate(path, *self.options)
        same(self, last, evaluated)
        self.assertEqual(last["warnings"], evaluated["warnings"])
        self.assertEqual(last["skipped"], evaluated["skipped"])

    def test_a_stall_is_told(self):
        watch = self.watch(*self.options, stdin=subprocess.PIPE)
        watch.process.stdin.write("\n".join(nmea_drive(100)) + "\n")
        watch.process.stdin.flush()
        watch.until_fixes(99)
        watch.until(lambda: watch.figures()["stalled_s"], "a stall")
        watch.process.stdin.close()
        code, last = watch.end()
        self.assertEqual((code, last["fixes_used"], last["stalled_s"]), (0, 100, None))

    def test_another_file_is_not_added(self):
        out = str(self.folder / "out.gpkg")
        watch = self.watch("--follow", str(self.nmea), *self.options, "-o", out)
        watch.until_fixes(self.known)
        self.assertEqual(watch.end(signal.SIGINT)[0], 0)
        self.refused("out.gpkg.log was not made from riverside-drive.csv: line 1 differs", "--follow",
                     str(self.csv), *self.options, "-o", out, "--quiet")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--examples", required=True)
    parser.add_argument("--kills", type=int, default=int(os.environ.get("TRAMLINE_KILLS", "4")))
    parser.add_argument("--seed", type=int, default=int(os.environ.get("TRAMLINE_SEED", random.randrange(10**6))))
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.tramline = os.path.abspath(OPTIONS.tramline)
    OPTIONS.examples = os.path.abspath(OPTIONS.examples)
    unittest.main(argv=[sys.argv[0], *rest], verbosity=2)
