"""examples/field_study.py, with a few of its fields."""

import csv
import runpy
import sys

import pytest


def test_study(examples, tmp_path, monkeypatch, capsys):
    script = examples / "field_study.py"
    monkeypatch.setattr(sys, "argv", [str(script), "-o", str(tmp_path), "--fields", "1"])
    study = runpy.run_path(str(script), run_name="__main__")
    fields = study["drawn_fields"]()
    assert len(fields) == 20 and all(field.is_valid for field in fields.values())
    areas_ha = sorted(field.area / 1e4 for field in fields.values())
    assert round(areas_ha[0], 1) == 0.8 and round(areas_ha[-1], 1) == 8.6
    rows = list(csv.DictReader((tmp_path / "study.csv").open()))
    (name,) = {row["field"] for row in rows}
    assert len(rows) == 3 * (2 + 12)
    for width in ("6", "12", "24"):
        of_width = {row["direction"]: row for row in rows if row["width_m"] == width}
        assert float(of_width["best"]["area_ha"]) == pytest.approx(fields[name].area / 1e4, rel=1e-9)
        best = float(of_width["best"]["euros_per_ha"])
        # No direction that is given is cheaper than the one that is found.
        assert all(best <= float(row["euros_per_ha"]) * (1 + 1e-6) for row in of_width.values())
        assert float(of_width["45°"]["direction_deg"]) == pytest.approx(45)
    for picture in ("directions.png", "widths.png"):
        assert (tmp_path / picture).read_bytes().startswith(b"\x89PNG")
    assert "longest side" in capsys.readouterr().out
