#!/usr/bin/env python3
"""What is too large is refused with a sentence: within a budget of memory, and at once.

Each file would take gigabytes, or minutes, if it were simply read. The files are made here: of one block of
bytes again and again, packed where that is what they are about.
"""

import pathlib
import resource
import sqlite3
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
MB = 1 << 20
# Address space, as `ulimit -v` has it. Libraries and an idle run take some 450 MB of it.
BUDGET = 2048 * MB
SECONDS = 60

GEOJSON = b'{"type":"FeatureCollection","features":['
FEATURE = (b'{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":'
           b"[[[9,54],[9.003,54],[9.003,54.002],[9,54]]]}}")
GPX = b'<gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>'
KML = b'<kml xmlns="http://www.opengis.net/kml/2.2"><Document>'
PLACEMARK = (b"<Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>9,54 9.01,54 9.01,54.01 9,54"
             b"</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n")
TASKS = (b'<ISO11783_TaskData VersionMajor="4"><DVC A="DVC-1"><DET A="DET-1" B="1" C="1" E="0"/></DVC>'
         b'<TSK A="TSK1" G="4">%s</TSK></ISO11783_TaskData>')
TIME_LOG = b'<TIM A=""><PTN A="" B="" D=""/></TIM>'
RECORD = struct.pack("<IHiiBB", 1000, 14000, 540000000, 90000000, 4, 0)


def repeated(unit, size):
    """A block of about a megabyte, and how often it is `size`."""
    block = unit * max(1, MB // max(1, len(unit)))
    return block, size // max(1, len(block)) + 1


def deflated(head, unit, size, tail=b""):
    """The same packed without being made: a block flushed in full can be repeated as it is."""
    block, times = repeated(unit, size)
    packer = zlib.compressobj(6, zlib.DEFLATED, -15)
    start = packer.compress(head) + packer.flush(zlib.Z_FULL_FLUSH)
    middle = packer.compress(block) + packer.flush(zlib.Z_FULL_FLUSH)
    return start + middle * times + packer.compress(tail) + packer.flush(), len(head) + len(block) * times + len(tail)


def write_zip(path, members):
    """Members as name -> (deflated bytes, size). Their checksums are wrong: nobody should come that far."""
    directory = b""
    with open(path, "wb") as out:
        for name, (packed, size) in members.items():
            common = struct.pack("<HHHHHIIIHH", 20, 0, 8, 0, 33, 0, len(packed), size, len(name), 0)
            directory += b"PK\1\2\x14\0" + common + struct.pack("<HHHII", 0, 0, 0, 0, out.tell()) + name.encode()
            out.write(b"PK\3\4" + common + name.encode() + packed)
        at = out.tell()
        count = len(members)
        out.write(directory + b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, count, count, len(directory), at, 0))


class Limits(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="tramline-limits-")
        self.folder = pathlib.Path(self.scratch.name)
        self.addCleanup(self.scratch.cleanup)

    def write(self, name, head, unit, size, tail=b""):
        block, times = repeated(unit, size)
        with open(self.folder / name, "wb") as out:
            out.write(head)
            for _ in range(times):
                out.write(block)
            out.write(tail)
        return name

    def gzip(self, name, head, unit, size):
        packed, _ = deflated(head, unit, size)
        (self.folder / name).write_bytes(b"\x1f\x8b\x08\0\0\0\0\0\0\xff" + packed + bytes(8))
        return name

    def run_program(self, *arguments):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (BUDGET, BUDGET))

        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, timeout=SECONDS,
                              preexec_fn=limit, check=False)

    def refused(self, what, *arguments):
        done = self.run_program(*arguments)
        errors = done.stderr.decode().splitlines()
        self.assertEqual(done.returncode, 2, errors)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(what, errors[0])

    def refused_log(self, what, name):
        self.refused(what, "evaluate", name, "--width", "6")

    def test_kml(self):
        name = self.write("f.kml", KML, PLACEMARK, 200 * MB, b"</Document></kml>")
        self.refused("holds more than 48 MiB of KML", "info", name)

    def test_kmz(self):
        write_zip(self.folder / "f.kmz", {"doc.kml": deflated(KML, PLACEMARK, 300 * MB)})
        self.refused("holds more than 48 MiB of KML", "info", "f.kmz")

    def test_the_largest_kml_is_read(self):
        name = self.write("f.kml", KML, PLACEMARK, 46 * MB, b"</Document></kml>")
        done = self.run_program("info", name, "--json", "--id", "nobody")
        self.assertIn(b"has no field that is called 'nobody'", done.stderr)

    def test_json_that_is_no_collection(self):
        for name, head, tail in (("f.geojson", b'{"type":"Polygon","coordinates":[[[9,54]', b"]]}"),
                                 ("g.json", b'{"type":"Topology","x":"FeatureCollection","arcs":[[[9,54]', b"]]}")):
            self.write(name, head, b",[9.00001,54.00001]", 70 * MB, tail)
            self.refused("JSON of more than 64 MB that is no collection", "info", name)

    def test_one_huge_feature_of_a_collection(self):
        self.write("f.geojson", GEOJSON + FEATURE[:-4], b",[9.00001,54.00001]", 100 * MB, b"]]}}]}")
        self.refused("has a feature of more than a million corners", "info", "f.geojson")

    def test_a_feature_of_a_million_corners_is_read(self):
        self.write("f.geojson", GEOJSON + FEATURE[:-4], b",[9.00001,54.00001]", 19_000_000, b"]]}}]}")
        done = self.run_program("info", "f.geojson", "--json", "--id", "nobody")
        self.assertIn(b"has no field that is called 'nobody'", done.stderr)

    def test_packed_geojson(self):
        self.gzip("f.geojson.gz", GEOJSON + FEATURE, b",\n" + FEATURE, 1100 * MB)
        self.refused("expands to more than 1024 MiB", "info", "f.geojson.gz")
        self.refused_log("expands to more than 1024 MiB", "f.geojson.gz")

    def test_geojson_in_a_zip(self):
        write_zip(self.folder / "f.zip", {"d/f.geojson": deflated(GEOJSON + FEATURE, b",\n" + FEATURE, 1100 * MB)})
        self.refused("expands to more than 1024 MiB", "info", "f.zip")

    def test_gpx(self):
        self.write("f.gpx", GPX, b'<trkpt lat="54" lon="9"><time>2020-01-01T00:00:00Z</time></trkpt>\n', 140 * MB)
        self.refused_log("holds more than 128 MiB", "f.gpx")
        self.gzip("g.gpx.gz", GPX, b'<trkpt lat="54" lon="9"/>', 1100 * MB)
        self.refused_log("holds more than 128 MiB", "g.gpx.gz")

    def test_gpx_of_too_many_elements(self):
        self.write("f.gpx", GPX, b"<a/>", 120 * MB, b"</trkseg></trk></gpx>")
        self.refused_log("so many elements that reading it takes more than 640 MiB", "f.gpx")

    def test_gpx_of_too_many_points(self):
        self.write("f.gpx", GPX, b"<trkpt/>", 25 * MB, b"</trkseg></trk></gpx>")
        self.refused_log("has no track point", "f.gpx")
        self.write("f.gpx", GPX, b"<trkpt lat='5' lon='9'/>", 74 * MB, b"</trkseg></trk></gpx>")
        self.refused_log("holds more than 3000000 fixes", "f.gpx")

    def test_gpx_of_too_many_tracks(self):
        self.write("f.gpx", b"<gpx>", b"<trk><trkseg><trkpt lat='5' lon='9'/></trkseg></trk>", 16 * MB, b"</gpx>")
        self.refused_log("holds more than 10000 tracks", "f.gpx")

    def test_packed_text_logs(self):
        self.gzip("f.csv.gz", b"lon,lat,time\n", b"9,54,0\n", 1100 * MB)
        self.refused_log("holds more than 3000000 fixes", "f.csv.gz")
        self.gzip("g.csv.gz", b"lon,lat,time\n9,54,", b"0" * 64, 1100 * MB)
        self.refused_log("has a line longer than 1048576 bytes", "g.csv.gz")

    def test_lines_without_end(self):
        self.gzip("f.csv.gz", b"lon,lat,time\n", b"x\n", 1000 * MB)
        self.refused_log("has more than 50000000 lines", "f.csv.gz")

    def test_a_quoted_field_without_end(self):
        (self.folder / "f.csv").write_bytes(b'lon,lat,time\n9,54,"' + b'""\n' * 300_000)
        self.refused_log("has no row with a position", "f.csv")
        self.write("g.csv", b'lon,lat,time\n9,54,"', b'""\n', 2 * MB)
        self.refused_log("line 2: a quoted field is never closed", "g.csv")

    def task_set(self, logs, size, record=RECORD, header=TIME_LOG):
        names = [f"TLG{i:05d}" for i in range(1, logs + 1)]
        listed = b"".join(b'<TLG A="%s"/>' % name.encode() for name in names)
        members = {"TASKDATA/TASKDATA.XML": deflated(TASKS % listed, b"", 0)}
        for name in names:
            members[f"TASKDATA/{name}.XML"] = deflated(header, b"", 0)
            members[f"TASKDATA/{name}.BIN"] = deflated(b"", record, size)
        write_zip(self.folder / "tasks.zip", members)

    def test_time_logs(self):
        self.task_set(1, 500 * MB)
        self.refused_log("holds more than 128 MiB when it is expanded", "tasks.zip")
        self.task_set(1, 100 * MB)
        self.refused_log("TLG00001 holds more than 3000000 fixes", "tasks.zip")
        self.task_set(9, 40 * MB)
        self.refused_log("'tasks.zip' holds more than 3000000 fixes", "tasks.zip")

    def test_task_data_of_too_many_elements(self):
        (self.folder / "TASKDATA").mkdir()
        self.write("TASKDATA/TASKDATA.XML", b'<ISO11783_TaskData VersionMajor="4">', b"<a/>", 120 * MB,
                   b"</ISO11783_TaskData>")
        self.refused("so many elements that reading it takes more than 640 MiB", "info", "TASKDATA")
        self.refused_log("so many elements", "TASKDATA")

    def write_field(self):
        (self.folder / "field.geojson").write_bytes(GEOJSON + FEATURE + b"]}")

    def test_machine_files(self):
        self.write_field()
        plan = ("plan", "field.geojson", "--machine")
        self.write("m.toml", b"width_m = 6\n", b"# nothing\n", 100 * MB)
        self.refused("too long for a machine file", *plan, "m.toml")
        (self.folder / "n.toml").write_bytes(b"width_m = 6\n" + b"a." * 400_000 + b"a = 1\n")
        self.refused("line 2: it has more than 64 dots", *plan, "n.toml")

    def test_huge_blobs_of_geopackages(self):
        self.write_field()
        made = self.run_program("plan", "field.geojson", "--width", "6", "-o", "p.gpkg")
        self.assertEqual(made.returncode, 0, made.stderr)
        for column, layer, what in (("geom", "swaths", "swaths"), ("path", "tracks", "path"),
                                    ("value", "metadata", "metadata")):
            with self.subTest(column=column):
                copy = self.folder / f"{column}.gpkg"
                copy.write_bytes((self.folder / "p.gpkg").read_bytes())
                with sqlite3.connect(copy) as database:
                    database.execute("pragma journal_mode = off")
                    database.execute("pragma synchronous = off")
                    for (trigger,) in database.execute("select name from sqlite_master where type = 'trigger'").fetchall():
                        database.execute(f'drop trigger "{trigger}"')
                    value = "zeroblob(250000000)" if column == "geom" else "replace(hex(zeroblob(60000000)), '00', '1 1; ')"
                    database.execute(f"update {layer} set {column} = {value} where rowid = 1")
                database.close()
                self.refused(what, "check", copy.name)
                copy.unlink()


if __name__ == "__main__":
    unittest.main()
