"""The plugin in QGIS without windows: by qgis_process, and by Python for what only a program with a project can do.

The environment variable TRAMLINE names the program, PLUGIN the zip of the plugin; without it the sources are taken as they are.
Needs Debian's qgis and python3-qgis.
"""

import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TRAMLINE = os.path.abspath(os.environ.get("TRAMLINE", "tramline"))
# The script that Debian puts before it has options that qgis_process does not know.
QGIS_PROCESS = shutil.which("qgis_process.bin") or shutil.which("qgis_process")

TEMPORARY = tempfile.TemporaryDirectory(prefix="tramline-qgis-")
FOLDER = pathlib.Path(TEMPORARY.name)
# QGIS changes the journal of GeoPackages that it opens.
EXAMPLES = FOLDER / "examples"
shutil.copytree(ROOT / "examples", EXAMPLES)
if "PLUGIN" in os.environ:
    shutil.unpack_archive(os.environ["PLUGIN"], FOLDER / "plugins", "zip")
PLUGINS = FOLDER / "plugins" if "PLUGIN" in os.environ else ROOT / "qgis"
ENVIRONMENT = {
    **os.environ,
    "QGIS_PLUGINPATH": str(PLUGINS),
    "QGIS_CUSTOM_CONFIG_PATH": str(FOLDER / "profile"),
    "QT_QPA_PLATFORM": "offscreen",
    "XDG_RUNTIME_DIR": str(FOLDER),
    "PYTHONDONTWRITEBYTECODE": "1",
    "TRAMLINE": TRAMLINE,
}


def qgis_process(*words, environment=ENVIRONMENT):
    return subprocess.run([QGIS_PROCESS, *map(str, words)], capture_output=True, text=True, env=environment)


def words_of(algorithm, parameters):
    return ["run", f"tramline:{algorithm}", "--", *(f"{name}={value}" for name, value in parameters.items())]


def said(done):
    """What was printed, on a line for people to search."""
    return " ".join((done.stdout + done.stderr).split())


def setUpModule():
    (FOLDER / "profile").mkdir()
    enabled = qgis_process("plugins", "enable", "tramline_processing")
    assert "tramline_processing" in enabled.stdout, said(enabled)


def tearDownModule():
    TEMPORARY.cleanup()


class ByQgisProcess(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=FOLDER))

    def run_algorithm(self, algorithm, **parameters):
        """The results, from the table that qgis_process prints."""
        done = qgis_process(*words_of(algorithm, parameters))
        self.assertEqual(done.returncode, 0, said(done))
        table = done.stdout.split("Results\n----------------\n")[1]
        return dict(line.split(":\t", 1) for line in table.splitlines() if ":\t" in line), said(done)

    def refused(self, algorithm, pattern, **parameters):
        done = qgis_process(*words_of(algorithm, parameters))
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(said(done), pattern)
        self.assertNotIn("Traceback", said(done))

    def printed(self, *words):
        done = subprocess.run([TRAMLINE, *map(str, words), "--json"], capture_output=True, text=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_all_algorithms_are_there(self):
        listed = qgis_process("list").stdout
        for name in ("plan", "map", "evaluate", "repair", "compare", "batch", "check"):
            self.assertIn(f"tramline:{name}\t", listed)
            self.assertIn("OUTPUT" if name != "check" else "REPORT", qgis_process("help", f"tramline:{name}").stdout)

    def test_three_fields_are_planned_as_by_the_program(self):
        for file, layer, words in (
            ("narrow-parcel.geojson", "", {"WIDTH": 6, "RADIUS": 6}),
            ("terrace.kml", "", {"WIDTH": 12, "RADIUS": 6, "AIM": 1}),
            ("two-farms.gpkg", "|layername=parcels", {"WIDTH": 24, "AIM": 1, "PRICES": "0.02,0.1,1"}),
        ):
            with self.subTest(file=file):
                name = pathlib.Path(file).stem
                output, picture = self.folder / f"{name}.gpkg", self.folder / f"{name}.png"
                found, _ = self.run_algorithm("plan", FIELD=f"{EXAMPLES / file}{layer}", OUTPUT=output, PICTURE=picture, **words)
                options = ["--width", words["WIDTH"]] + (["--radius", 6] if "RADIUS" in words else [])
                options += ["--prices", words.get("PRICES", "0.02,0.10,1,5,5")] if "AIM" in words else []
                several = ["--all", "--one-file"] if layer else []
                own = self.folder / f"{name}-own.gpkg"
                lines = self.printed("plan", EXAMPLES / file, *options, *several, *(["--layer", "parcels"] if layer else []), "-o", own)
                plans = [line for line in lines if "area_m2" in line]
                self.assertEqual(int(found["FIELDS"]), len(plans))
                self.assertAlmostEqual(float(found["OVERLAP_M2"]), sum(plan["overlap_m2"] for plan in plans), 6)
                self.assertEqual(output.read_bytes(), own.read_bytes())
                self.assertEqual(found["TRACKS"], f"{output}|layername=tracks")
                self.assertEqual(picture.exists(), not several)

    def test_map_along_a_line(self):
        found, _ = self.run_algorithm(
            "map", FIELD=EXAMPLES / "roadside.geojson", GUIDE=EXAMPLES / "roadside-lines.geojson", OPTIONS="--guide-where 'fid = 1'",
            WIDTH=12, HEADLANDS=1, OUTPUT=self.folder / "map.gpkg",
        )
        with sqlite3.connect(self.folder / "map.gpkg") as file:
            (guide,) = file.execute("SELECT value FROM metadata WHERE key = 'settings.guide'").fetchone()
        self.assertTrue(guide)
        self.assertGreater(int(found["TRACK_COUNT"]), 0)

    def test_a_drive_is_evaluated_and_repaired(self):
        coverage, repair = self.folder / "coverage.gpkg", self.folder / "repair.gpkg"
        drive, field = EXAMPLES / "riverside-drive.csv", EXAMPLES / "riverside.geojson"
        found, _ = self.run_algorithm("evaluate", LOG=drive, FIELD=field, OUTPUT=coverage)
        (own,) = self.printed("evaluate", drive, "--field", field)
        self.assertAlmostEqual(float(found["MISSED_M2"]), own["missed_m2"], 6)
        repaired, _ = self.run_algorithm("repair", COVERAGE=coverage, WIDTH=12, RADIUS=6, OUTPUT=repair)
        self.assertGreater(int(repaired["GAPS_TAKEN"]), 0)
        self.assertLess(float(repaired["MISSED_AFTER_M2"]), float(repaired["MISSED_BEFORE_M2"]))
        checked, _ = self.run_algorithm("check", PLAN=repair, REPORT=self.folder / "report.html")
        self.assertEqual((checked["HOLDS"], checked["VIOLATIONS"]), ("true", "0"))
        self.assertIn("holds", (self.folder / "report.html").read_text())

    def test_a_plan_that_does_not_hold(self):
        plan = self.folder / "plan.gpkg"
        self.run_algorithm("plan", FIELD=EXAMPLES / "narrow-parcel.geojson", WIDTH=6, AIM=2, OUTPUT=plan)
        with sqlite3.connect(plan) as file:
            file.execute("UPDATE metadata SET value = '1' WHERE key = 'tally.overlap_m2'")
        found, log = self.run_algorithm("check", PLAN=plan, FIELD=EXAMPLES / "narrow-parcel.geojson")
        self.assertEqual(found["HOLDS"], "false")
        self.assertIn("overlap", log)

    def test_plans_and_widths_are_compared(self):
        table, plan = self.folder / "front.csv", self.folder / "knee.gpkg"
        field = EXAMPLES / "narrow-parcel.geojson"
        found, _ = self.run_algorithm("compare", FIELD=field, WIDTH=6, TABLE=table, OUTPUT=plan, POINT="knee")
        rows = table.read_text().splitlines()
        self.assertEqual(int(found["PLANS"]), len(rows) - 1)
        self.assertTrue(plan.exists())
        found, _ = self.run_algorithm("compare", FIELD=EXAMPLES / "roadside.geojson", WIDTHS="12,24", RADIUS=6, TABLE=table)
        self.assertEqual(found["PLANS"], "2")

    def test_a_register(self):
        folder = self.folder / "plans"
        parameters = {"FIELD": f"{EXAMPLES / 'two-farms.gpkg'}|layername=parcels", "WIDTH": 24, "PRICES": "0.02,0.1,1", "OUTPUT": folder}
        found, _ = self.run_algorithm("batch", CHUNK=2, **parameters)
        self.assertEqual(json.loads((folder / "summary.json").read_text())["planned"], int(found["FIELDS"]))
        self.refused("batch", "holds a batch already", CHUNK=2, **parameters)
        (folder / "chunks/000001.jsonl").unlink()
        again, _ = self.run_algorithm("batch", CHUNK=2, RESUME="true", **parameters)
        self.assertEqual(again["FIELDS"], found["FIELDS"])

    def test_bad_input(self):
        field, output = EXAMPLES / "narrow-parcel.geojson", self.folder / "plan.gpkg"
        self.refused("plan", "Give a working width", FIELD=field, OUTPUT=output)
        self.refused("plan", "prices", FIELD=field, WIDTH=6, AIM=1, PRICES="1,x", OUTPUT=output)
        self.refused("plan", "Leave --width out", FIELD=field, WIDTH=6, OPTIONS="--width 3", OUTPUT=output)
        self.refused("plan", "Could not load source layer", FIELD=self.folder / "none.gpkg", WIDTH=6, OUTPUT=output)
        self.refused("evaluate", "[Nn]ame a log", OUTPUT=output)
        self.refused("repair", "none.gpkg", COVERAGE=self.folder / "none.gpkg", WIDTH=6, OUTPUT=output)
        self.refused("check", "not .*plan", PLAN=EXAMPLES / "two-farms.gpkg")
        bow = {"type": "Polygon", "coordinates": [[[0, 0], [0, 0], [0, 0], [0, 0]]]}
        nothing = self.folder / "nothing.geojson"
        nothing.write_text(json.dumps({"type": "Feature", "properties": {}, "geometry": bow}))
        self.refused("plan", "no area", FIELD=nothing, WIDTH=6, OUTPUT=output)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["nothing.geojson"])

    def test_a_bad_program(self):
        for path, pattern in (
            ("/nowhere/tramline", "There is no program '/nowhere/tramline'. Choose it under"), ("/bin/ls", "is not the program tramline"),
        ):
            done = qgis_process(
                *words_of("plan", {"FIELD": EXAMPLES / "narrow-parcel.geojson", "WIDTH": 6, "OUTPUT": self.folder / "p.gpkg"}),
                environment={**ENVIRONMENT, "TRAMLINE": path},
            )
            self.assertNotEqual(done.returncode, 0)
            self.assertRegex(said(done), pattern)

    def test_killed(self):
        """The program ends with the process that had begun it."""
        words = words_of("plan", {"FIELD": EXAMPLES / "riverside.geojson", "WIDTH": 3, "OUTPUT": self.folder / "plan.gpkg"})
        process = subprocess.Popen([QGIS_PROCESS, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=ENVIRONMENT)
        child = wait_for(lambda: children_of(process.pid))
        process.send_signal(signal.SIGKILL)
        process.communicate()
        wait_for(lambda: not any(pathlib.Path(f"/proc/{one}").exists() for one in child))
        self.assertEqual(list(self.folder.iterdir()), [])


def children_of(pid):
    """Of those, the ones that plan."""
    out = []
    for file in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = file.read_text().rsplit(")", 1)[1].split()[1]
            if int(parent) == pid and b"--output" in (file.parent / "cmdline").read_bytes():
                out.append(int(file.parent.name))
        except OSError:
            pass
    return out


def wait_for(what, seconds=60):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        found = what()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError("it did not happen")


class InAProject(unittest.TestCase):
    """As in the windows of QGIS, with layers of a project."""

    @classmethod
    def setUpClass(cls):
        os.environ.update(ENVIRONMENT)
        from qgis.core import QgsApplication

        QgsApplication.setPrefixPath("/usr", True)
        cls.application = QgsApplication([], False, str(FOLDER / "profile"))
        cls.application.initQgis()
        sys.path[:0] = [str(PLUGINS), os.path.join(QgsApplication.pkgDataPath(), "python/plugins")]
        from processing.core.Processing import Processing

        Processing.initialize()
        from tramline_processing.plugin import Plugin

        cls.plugin = Plugin(None)
        cls.plugin.initProcessing()

    @classmethod
    def tearDownClass(cls):
        cls.plugin.unload()

    def setUp(self):
        from qgis.core import QgsProcessingContext, QgsProcessingFeedback, QgsProject

        self.folder = pathlib.Path(tempfile.mkdtemp(dir=FOLDER))
        self.project = QgsProject.instance()
        self.project.clear()
        self.context = QgsProcessingContext()
        self.context.setProject(self.project)
        self.feedback = QgsProcessingFeedback(False)

    def run_algorithm(self, name, parameters):
        """Whether it went well, and its results; the layers are loaded as the toolbox does."""
        from processing.gui.Postprocessing import handleAlgorithmResults
        from qgis.core import QgsApplication

        algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"tramline:{name}")
        results, good = algorithm.run(parameters, self.context, self.feedback)
        if good:
            self.assertTrue(handleAlgorithmResults(algorithm, self.context, self.feedback, parameters=parameters))
        return good, results

    def layer(self, file, name="fields"):
        from qgis.core import QgsVectorLayer

        layer = QgsVectorLayer(str(file), name, "ogr")
        self.assertTrue(layer.isValid())
        self.project.addMapLayer(layer)
        return layer

    def test_layers_are_loaded_in_their_order_and_styled(self):
        field = self.layer(EXAMPLES / "riverside.geojson")
        good, results = self.run_algorithm("plan", {"FIELD": field, "WIDTH": 24, "RADIUS": 8, "OUTPUT": str(self.folder / "plan.gpkg")})
        self.assertTrue(good)
        group = self.project.layerTreeRoot().findGroup("Plan fields: riverside")
        names = [layer.name() for layer in group.findLayers()]
        for above, below in (("route_legs", "tracks"), ("tracks", "overlap"), ("overlap", "swaths"), ("swaths", "field")):
            self.assertLess(names.index(above), names.index(below), names)
        for node in group.findLayers():
            # The plain style of QGIS is a single symbol of one layer; only the outline of the field has such a one too.
            if node.name() not in ("field", "obstacles", "swaths", "overlap", "uncovered", "worked", "headland", "given_up"):
                xml = self.style_of(node.layer())
                self.assertNotEqual(xml, self.style_of(self.plain(node.layer())), node.name())
        self.assertEqual(self.project.mapLayersByName("tracks")[0].source(), results["TRACKS"])

    def plain(self, layer):
        from qgis.core import QgsVectorLayer

        options = QgsVectorLayer.LayerOptions()
        options.loadDefaultStyle = False
        return QgsVectorLayer(layer.source(), layer.name(), "ogr", options)

    def style_of(self, layer):
        """The renderer without its colours, which QGIS chooses at random."""
        return type(layer.renderer()).__name__, len(layer.renderer().legendSymbolItems()), [
            type(part).__name__ for item in layer.renderer().legendSymbolItems() if item.symbol() for part in item.symbol().symbolLayers()
        ]

    def test_selections_filters_and_layers_in_memory(self):
        from qgis.core import QgsFeatureRequest, QgsProcessingFeatureSourceDefinition, QgsVectorLayer

        parcels = self.layer(f"{EXAMPLES / 'two-farms.gpkg'}|layername=parcels", "my parcels")
        ids = sorted(parcels.allFeatureIds())
        parcels.selectByIds(ids[:1])
        chosen = QgsProcessingFeatureSourceDefinition(parcels.id(), True)
        good, found = self.run_algorithm("plan", {"FIELD": chosen, "WIDTH": 24, "AIM": 1, "OUTPUT": str(self.folder / "one.gpkg")})
        self.assertTrue(good)
        self.assertEqual(found["FIELDS"], 1)
        # The same numbers of features as in the file itself, so that the plan can be compared with it.
        good, checked = self.run_algorithm("check", {"PLAN": str(self.folder / "one.gpkg"), "FIELD": parcels})
        self.assertTrue(good and checked["HOLDS"])
        parcels.setSubsetString(f"fid = {ids[0]}")
        good, filtered = self.run_algorithm("plan", {"FIELD": parcels, "WIDTH": 24, "AIM": 1, "OUTPUT": str(self.folder / "two.gpkg")})
        self.assertTrue(good)
        self.assertEqual(filtered["OVERLAP_M2"], found["OVERLAP_M2"])
        memory = QgsVectorLayer("MultiPolygon?crs=EPSG:25832&field=name:string", "drawn", "memory")
        memory.dataProvider().addFeatures(list(parcels.getFeatures(QgsFeatureRequest())))
        memory.startEditing()
        for feature in memory.getFeatures():
            memory.changeAttributeValue(feature.id(), 0, "the mill")
        self.project.addMapLayer(memory)
        good, drawn = self.run_algorithm(
            "plan", {"FIELD": memory, "ID_FIELD": "name", "WIDTH": 24, "AIM": 1, "OUTPUT": str(self.folder / "three.gpkg")}
        )
        self.assertTrue(good)
        self.assertEqual(drawn["OVERLAP_M2"], found["OVERLAP_M2"])
        self.assertIsNotNone(self.project.layerTreeRoot().findGroup("Plan fields: the mill"))

    def test_temporary_outputs(self):
        parcels = self.layer(f"{EXAMPLES / 'two-farms.gpkg'}|layername=parcels", "parcels")
        parameters = {"FIELD": parcels, "WIDTH": 24, "PRICES": "0.02,0.1,1", "OUTPUT": "TEMPORARY_OUTPUT"}
        good, found = self.run_algorithm("batch", parameters)
        self.assertTrue(good, self.feedback.textLog())
        self.assertTrue(pathlib.Path(found["OUTPUT"], "fields.csv").exists())
        self.assertEqual(len(self.project.mapLayersByName("fields")), 1)
        self.assertEqual(len(self.project.mapLayersByName("tracks")), 1)
        good, again = self.run_algorithm("plan", {**parameters, "AIM": 1})
        self.assertTrue(good, self.feedback.textLog())
        self.assertAlmostEqual(again["OVERLAP_M2"], found["OVERLAP_M2"], 6)

    def test_gates_are_given_in_the_crs_of_the_project(self):
        field = self.layer(EXAMPLES / "narrow-parcel.geojson")
        at = field.extent().center()
        from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform

        other = QgsCoordinateReferenceSystem("EPSG:3857")
        moved = QgsCoordinateTransform(field.crs(), other, self.project).transform(at)
        parameters = {"FIELD": field, "WIDTH": 6, "START": f"{moved.x()!r},{moved.y()!r} [EPSG:3857]"}
        good, _ = self.run_algorithm("plan", {**parameters, "OUTPUT": str(self.folder / "a.gpkg")})
        self.assertTrue(good)
        parameters["START"] = f"{at.x()!r},{at.y()!r} [{field.crs().authid()}]"
        self.run_algorithm("plan", {**parameters, "OUTPUT": str(self.folder / "b.gpkg")})
        gates = []
        for name in ("a", "b"):
            with sqlite3.connect(self.folder / f"{name}.gpkg") as file:
                (gate,) = file.execute("SELECT value FROM metadata WHERE key = 'settings.route.start'").fetchone()
            gates.append([float(number) for number in gate.split()])
        self.assertAlmostEqual(gates[0][0], gates[1][0], 3)
        self.assertAlmostEqual(gates[0][1], gates[1][1], 3)

    def test_cancelled(self):
        field = self.layer(EXAMPLES / "riverside.geojson")
        begun = threading.Event()
        self.feedback.progressChanged.connect(lambda progress: begun.set())
        threading.Thread(target=lambda: begun.wait(60) and self.feedback.cancel()).start()
        start = time.monotonic()
        good, _ = self.run_algorithm("plan", {"FIELD": field, "WIDTH": 3, "OUTPUT": str(self.folder / "plan.gpkg")})
        self.assertFalse(good)
        self.assertTrue(begun.is_set())
        self.assertLess(time.monotonic() - start, 60)
        self.assertIn("cancelled", self.feedback.textLog())
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(children_of(os.getpid()), [])

    def test_the_program_of_the_settings(self):
        from processing.core.ProcessingConfig import ProcessingConfig

        field = self.layer(EXAMPLES / "narrow-parcel.geojson")
        # QGIS itself refuses paths where there is nothing.
        ProcessingConfig.setSettingValue("TRAMLINE_PROGRAM", str(EXAMPLES / "narrow-parcel.geojson"))
        self.addCleanup(ProcessingConfig.setSettingValue, "TRAMLINE_PROGRAM", "")
        good, _ = self.run_algorithm("plan", {"FIELD": field, "WIDTH": 6, "OUTPUT": str(self.folder / "plan.gpkg")})
        self.assertFalse(good)
        self.assertRegex(self.feedback.textLog(), "narrow-parcel.geojson' is not a program. Choose it under Settings")


if __name__ == "__main__":
    unittest.main()
