"""The package gives the bytes that the program gives."""

import json
import os

import pytest
import tramline

OBSTACLES = f"{os.environ['EXAMPLES']}/riverside-obstacles.geojson"

REQUESTS = {
    "a parcel planned to be driven": ("narrow-parcel.geojson", {"width": 6, "radius": 6}),
    "tracks alone": ("roadside.geojson", {"width": 24, "prices": (0.02, 0.1, 1), "clearance": 0.5}),
    "in plain metres": ("plain-metres.gpkg", {"width": 12, "weights": (1, 1, 1), "headlands": 1}),
    "one field of many": ("two-farms.gpkg", {"layer": "parcels", "id": "mill-field", "width": 24, "prices": (0.02, 0.1, 1)}),
    "with obstacles of a file": (
        "riverside.geojson",
        {"width": 24, "like": "versleijen", "obstacles": OBSTACLES, "threads": 1},
    ),
}


def words_of(options):
    out = []
    for name, value in options.items():
        typed = ",".join(map(str, value)) if isinstance(value, tuple) else value
        out += ["--" + name.replace("_", "-"), str(typed)]
    return out


@pytest.mark.parametrize("what", REQUESTS)
def test_plan_file_and_figures(what, examples, program, tmp_path):
    file, options = REQUESTS[what]
    printed = program("plan", examples / file, *words_of(options), "-o", tmp_path / "program.gpkg", "--json").stdout
    plan = tramline.plan(examples / file, **options)
    plan.save(tmp_path / "package.gpkg")
    assert (tmp_path / "package.gpkg").read_bytes() == (tmp_path / "program.gpkg").read_bytes()
    expected = json.loads(printed)
    del expected["seconds"]
    assert {key: value for key, value in plan.figures.items() if key != "seconds"} == expected


def test_picture(examples, program, tmp_path):
    file = examples / "narrow-parcel.geojson"
    program("plan", file, "--width", 6, "--minimise", "turns", "--picture", tmp_path / "program.svg")
    tramline.plan(file, width=6, minimise="turns").save(tmp_path / "package.svg")
    assert (tmp_path / "package.svg").read_bytes() == (tmp_path / "program.svg").read_bytes()


def test_other_commands(examples, program, tmp_path):
    field = examples / "narrow-parcel.geojson"
    plan_file = tmp_path / "plan.gpkg"
    program("plan", field, "--width", 6, "--minimise", "turns", "-o", plan_file)

    def same(result, *words):
        expected = json.loads(program(*words, "--json").stdout)
        assert {k: v for k, v in result.figures.items() if k != "seconds"} == {
            k: v for k, v in expected.items() if k != "seconds"
        }

    same(tramline.check(plan_file, field=field), "check", plan_file, "--field", field)
    same(tramline.price(plan_file), "price", plan_file)
    same(tramline.compare(field, width=6), "compare", field, "--width", 6)
    drive = examples / "riverside-drive.csv"
    riverside = examples / "riverside.geojson"
    evaluation = tramline.evaluate(drive, field=riverside, width=24)
    same(evaluation, "evaluate", drive, "--field", riverside, "--width", 24)
    evaluation.save(tmp_path / "package.gpkg")
    program("evaluate", drive, "--field", riverside, "--width", 24, "-o", tmp_path / "program.gpkg")
    assert (tmp_path / "package.gpkg").read_bytes() == (tmp_path / "program.gpkg").read_bytes()
