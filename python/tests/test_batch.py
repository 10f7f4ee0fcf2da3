"""tramline.batch: the folder that `tramline batch` writes, to the bit."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest
import tramline.batch


@pytest.fixture(scope="module")
def parcels(tmp_path_factory):
    """Fields side by side, one of them too small to be planned."""
    features = []
    for number in range(9):
        x, wide = 400 * number, 2 if number == 4 else 200 + 10 * number
        high = 2 if number == 4 else 100
        ring = [[x, 0], [x + wide, 0], [x + wide, high + 20 * (number != 4)], [x, high], [x, 0]]
        geometry = {"type": "Polygon", "coordinates": [ring]}
        features.append({"type": "Feature", "properties": {"id": f"f{number}"}, "geometry": geometry})
    file = tmp_path_factory.mktemp("parcels") / "parcels.geojson"
    file.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    return file


def words(parcels, folder):
    return [str(parcels), f"--output={folder}", "--crs=none", "--width=12", "--prices=0.02,0.1,1", "--chunk=2"]


def files_in(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_same_bytes_as_the_program(parcels, program, tmp_path):
    program("batch", *words(parcels, tmp_path / "program"), code=3)
    command = [sys.executable, "-m", "tramline.batch", *words(parcels, tmp_path / "dask"), "--workers", "2", "--json"]
    here = tmp_path / "here"
    here.mkdir()
    done = subprocess.run(command, capture_output=True, text=True, cwd=here)
    assert done.returncode == 3, done.stderr
    assert json.loads(done.stdout)["planned"] == 8
    assert list(here.iterdir()) == [], "workers keep their files elsewhere"
    assert files_in(tmp_path / "dask") == files_in(tmp_path / "program")


def test_threads_of_one_worker_take_turns_in_reading(parcels, program, tmp_path):
    program("batch", *words(parcels, tmp_path / "program"), code=3)
    command = words(parcels, tmp_path / "threads")
    begun = tramline.batch._core.Batch(command)
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda chunk: tramline.batch.work_on([*command, "--resume"], chunk), begun.missing()))
    begun.finish()
    assert files_in(tmp_path / "threads") == files_in(tmp_path / "program")


def test_goes_on_with_what_the_program_began(parcels, program, tmp_path):
    program("batch", *words(parcels, tmp_path / "whole"), code=3)
    program("batch", *words(parcels, tmp_path / "begun"), code=3)
    for name in ("chunks/000002.jsonl", "chunks/000005.jsonl", "summary.json"):
        (tmp_path / "begun" / name).unlink()
    with pytest.raises(tramline.InputError, match="resume"):
        tramline.batch.run(words(parcels, tmp_path / "begun"))
    tramline.batch.run([*words(parcels, tmp_path / "begun"), "--resume"], workers=1)
    assert files_in(tmp_path / "begun") == files_in(tmp_path / "whole")


def test_bad_input_starts_no_cluster(tmp_path):
    with pytest.raises(tramline.InputError, match="no file"):
        tramline.batch.run(["none.gpkg", f"--output={tmp_path / 'out'}"])
    assert not (tmp_path / "out").exists()


def test_a_scheduler_that_is_not_there(parcels, tmp_path, monkeypatch):
    monkeypatch.setattr(tramline.batch, "_GONE_S", 1)
    with pytest.raises(tramline.RunError, match="--resume"):
        tramline.batch.run(words(parcels, tmp_path / "out"), scheduler="tcp://127.0.0.1:9")
