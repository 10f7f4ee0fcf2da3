"""Results: many fields, layers, evaluations, files that cannot be written, threads and interrupts."""

import signal
import sqlite3
import subprocess
import sys
import threading
import time

import geopandas
import pytest
import shapely.geometry as sg
import tramline

PRICES = (0.02, 0.1, 1)
FIELD = sg.Polygon([(0, 0), (260, 0), (280, 120), (0, 100)], [[(50, 50), (50, 60), (60, 60), (60, 50)]])


def test_many_fields():
    frame = geopandas.GeoDataFrame(
        geometry=[sg.box(0, 0, 200, 100), sg.Point(1, 1), None, sg.box(0, 0, 300, 100)],
        index=["north", "pole", "nothing", "south"],
    )
    found = tramline.plan_fields(frame, width=10, prices=PRICES, plans=True)
    assert list(found.index) == list(frame.index)
    assert found.error.isna().tolist() == [True, False, False, True]
    assert "polygon" in found.error["pole"] and "no geometry" in found.error["nothing"]
    assert found.tracks["north"] == 10 and found.area_m2["south"] == 30000
    assert found.plan["north"].field_id == "north"
    again = tramline.plan_fields(frame, width=10, prices=PRICES, threads=1)
    assert again.drop(columns="geometry").equals(found.drop(columns=["geometry", "plan"]))


def test_options_with_which_no_field_could_be_planned_are_refused_at_once(tmp_path):
    frame = geopandas.GeoDataFrame(geometry=[sg.box(0, 0, 200, 100)])
    with pytest.raises(tramline.InputError, match="width"):
        tramline.plan_fields(frame, width=-6)
    with pytest.raises(tramline.InputError, match="minimise"):
        tramline.plan_fields(frame, width=6, minimise="everything")
    with pytest.raises(tramline.InputError, match="none.toml"):
        tramline.plan_fields(frame, machine=tmp_path / "none.toml")
    with pytest.raises(tramline.InputError, match="wdith"):
        tramline.plan_fields(frame, wdith=6)


def test_many_fields_of_a_file(examples):
    found = tramline.plan_fields(examples / "two-farms.gpkg", layer="parcels", width=24, prices=PRICES)
    assert found.crs.to_epsg() == 25832
    # The second is a field on both sides of a lane.
    assert found.error.isna().tolist() == [True, False, True, True] and "2 parts" in found.error[1]
    assert found.area_m2[0] == pytest.approx(43782.0, abs=0.05)


def test_layers_are_those_of_the_file(tmp_path):
    first = tramline.plan(FIELD, width=12, prices=PRICES)
    first.save(tmp_path / "first.gpkg")
    with sqlite3.connect(tmp_path / "first.gpkg") as file:
        tables = {name for (name,) in file.execute("SELECT table_name FROM gpkg_geometry_columns")}
    assert set(first.layers) == tables and {"field", "tracks", "swaths"} <= tables
    plan = tramline.plan(sg.mapping(sg.box(12, 52, 12.003, 52.001)), crs="EPSG:4326", width=12, prices=PRICES)
    features = plan.features("field")["features"]
    assert sg.shape(features[0]["geometry"]).symmetric_difference(sg.box(12, 52, 12.003, 52.001)).area < 1e-12


def test_a_choice_from_what_is_in_memory_is_refused():
    frame = geopandas.GeoDataFrame(geometry=[sg.box(0, 0, 200, 100), sg.box(0, 0, 300, 100)], index=["north", "south"])
    plan = tramline.plan(frame.loc[["south"]], width=10, prices=PRICES)
    assert tramline.check(plan, field=frame.loc[["south"]]).ok
    with pytest.raises(tramline.InputError, match="2 features"):
        tramline.check(plan, field=frame)
    with pytest.raises(tramline.InputError, match="in memory"):
        tramline.plan(FIELD, width=12, where="fid = 1")
    with pytest.raises(tramline.InputError, match="'where' was not expected"):
        tramline.plan_fields(frame, width=12, where="fid = 1")


def test_layers_with_and_without_geopandas(monkeypatch):
    plan = tramline.plan(FIELD, width=12, prices=PRICES)
    frame = plan.layer("swaths")
    assert frame.crs is None
    monkeypatch.setitem(sys.modules, "geopandas", None)
    for name in plan.layers:
        features = plan.layer(name)["features"]
        if name == "swaths":
            assert [sg.shape(f["geometry"]).wkt for f in features] == [shape.wkt for shape in frame.geometry]
            assert features[0]["properties"]["width_m"] == 12
        if name == "field":
            assert sg.shape(features[0]["geometry"]).equals(sg.Polygon(FIELD.exterior))
    with pytest.raises(tramline.InputError, match="there is no layer 'lanes'"):
        plan.layer("lanes")


def test_a_plan_is_evaluated_checked_and_priced(tmp_path):
    plan = tramline.plan(FIELD, width=12, prices=PRICES)
    evaluation = tramline.evaluate(plan)
    assert evaluation["missed_m2"] == pytest.approx(plan.uncovered_m2, abs=0.5)
    assert tramline.check(plan, field=FIELD)
    assert not tramline.check(plan, field=sg.box(0, 0, 260, 100))
    again = tramline.price(plan)
    assert again.overlap_m2 == pytest.approx(plan.overlap_m2, abs=0.01)
    plan.save(tmp_path / "plan.gpkg")
    assert tramline.read(tmp_path / "plan.gpkg")["overlap_m2"] == plan["overlap_m2"]


def test_lines_are_priced():
    lines = [sg.LineString([(0, 6), (200, 6)]), sg.LineString([(200, 17), (0, 17)])]
    plan = tramline.price(lines, sg.box(0, 0, 200, 23), width=12)
    # Two swaths of 12 m with their middles 11 m apart cover 23 m, one metre of it twice.
    assert plan.overlap_m2 == pytest.approx(200, abs=0.01)
    assert plan.uncovered_m2 == pytest.approx(0, abs=0.01)


def test_lines_are_compared_with_a_plan():
    lines = [sg.LineString([(0, 6), (200, 6)]), sg.LineString([(200, 17), (0, 17)])]
    field = sg.box(0, 0, 200, 23)
    assert tramline.price(lines, field, width=12).planned is None
    priced = tramline.price(lines, field, width=12, compare=True, strategy="sweep")
    # Lengthwise two swaths of 12 m are needed in any case, and they are 1 m too wide together.
    assert priced.overlap_m2 == pytest.approx(200, abs=0.01)
    assert priced.planned.tracks == 2 and priced.planned.overlap_m2 == pytest.approx(200, abs=0.01)
    assert priced.difference["turns"] == 0 and priced.difference["overlap_m2"] == pytest.approx(0, abs=0.01)
    # What only that plan has a use for is not ignored.
    with pytest.raises(tramline.InputError, match="compare"):
        tramline.price(lines, field, width=12, strategy="sweep")


def test_comparison_names_winners_and_gives_plans():
    cheap_turns = (0.02, 0.1, 0.001)
    found = tramline.compare(FIELD, width=12, for_=[cheap_turns, "0.0001,0.0001,9"])
    assert len(found.winners) == 2 and len(tramline.compare(FIELD, width=12, for_=cheap_turns).winners) == 1
    fewest = min(point["turns"] for point in found.points)
    assert found.points[found.winners[1]["point"] - 1]["turns"] == fewest
    for point in found.points:
        plan = found.plan(point["point"])
        assert (plan.turns, plan.overlap_m2) == (point["turns"], pytest.approx(point["overlap_m2"], abs=1e-6))
    with pytest.raises(tramline.InputError, match="there is no plan 0"):
        found.plan(0)
    with pytest.raises(tramline.InputError, match="ab"):
        tramline.compare(FIELD, width=12, ab=((0, 0), (1, 1)))


def test_machines_are_compared():
    found = tramline.compare(FIELD, widths=(6, 12, 200), radius=6)
    assert [job["machine"] for job in found.machines] == ["6 m", "12 m", "200 m"]
    for job, width in zip(found.machines, (6, 12)):
        plan = tramline.plan(FIELD, width=width, radius=6)
        assert job["euros"] == pytest.approx(plan.euros, rel=1e-12)
    assert "error" in found.machines[2] and len(found) == 3 and found.points == []
    assert found.csv.count("\n") == 4
    with pytest.raises(tramline.InputError, match="plan()"):
        found.plan(1)
    with pytest.raises(tramline.InputError, match="tracks alone"):
        tramline.compare(FIELD, widths=(6, 12), prices=PRICES)
    with pytest.raises(tramline.InputError, match="for_"):
        tramline.compare(FIELD, widths=(6, 12), for_=PRICES)


def test_comparison():
    found = tramline.compare(FIELD, width=12)
    assert len(found) == len(found.points) > 1
    for a in found.points:
        for b in found.points:
            keys = ("overlap_m2", "uncovered_m2", "turns", "stops")
            assert a is b or any(a[key] < b[key] for key in keys)


def test_pictures():
    plan = tramline.plan(FIELD, width=12, prices=PRICES)
    assert plan._repr_html_().lstrip().startswith("<?xml")
    # By the shoelace formula 29,600 m², less a hole of 100 m².
    assert repr(plan).startswith("<Plan of field: 2.95 ha, ")
    assert "<svg" in tramline.evaluate(plan)._repr_html_()


def test_a_file_that_cannot_be_written(tmp_path):
    plan = tramline.plan(FIELD, width=12, prices=PRICES)
    with pytest.raises(tramline.InputError, match="gpkg"):
        plan.save(tmp_path / "plan.txt")
    with pytest.raises(tramline.RunError):
        plan.save(tmp_path / "missing" / "plan.gpkg")
    assert list(tmp_path.iterdir()) == []


def test_other_threads_go_on_meanwhile():
    """A plan begun on one thread ends only once another has told it to: without the lock both would wait."""
    begun, enough = threading.Event(), threading.Event()

    def progress(done, total):
        begun.set()
        return False if enough.is_set() else None

    thread = threading.Thread(target=lambda: begun.wait() and enough.set())
    before = sys.getswitchinterval()
    sys.setswitchinterval(1000)  # so that others run only where the lock is released
    try:
        thread.start()
        plan = tramline.plan(FIELD, width=3, prices=PRICES, progress=progress)
    finally:
        sys.setswitchinterval(before)
    thread.join(10)
    assert plan.cut_short


def test_progress_ends_a_search():
    assert tramline.plan(FIELD, width=3, prices=PRICES, progress=lambda done, total: False).cut_short


def test_an_exception_of_progress_is_raised():
    def fail(done, total):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        tramline.plan(FIELD, width=3, prices=PRICES, progress=fail)


def test_ctrl_c(tmp_path):
    """print() is no Python code: the interpreter itself would see the signal only after the plan."""
    code = (
        "import tramline\n"
        "tramline.plan('POLYGON((0 0,500 0,620 410,0 300,0 0))', width=2, progress=print)\n"
        "print('planned to the end')"
    )
    run = subprocess.Popen([sys.executable, "-u", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    run.stdout.readline()
    run.send_signal(signal.SIGINT)
    printed, said = run.communicate(timeout=60)
    assert "KeyboardInterrupt" in said
    assert "planned to the end" not in printed
