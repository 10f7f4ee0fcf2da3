"""Fields in every form they may have, and things that are no fields."""

import json
import math
import struct

import geopandas
import hypothesis.strategies as st
import pytest
import shapely.affinity
import shapely.geometry as sg
import tramline
from hypothesis import given

PRICES = (0.02, 0.1, 1)


@st.composite
def fields(draw):
    """Rings round a middle that do not cross themselves, some of them with a hole."""
    corners = draw(st.integers(3, 12))
    reach = draw(st.lists(st.floats(80, 200), min_size=corners, max_size=corners))
    turn = draw(st.floats(0, 1))
    ring = [
        (r * math.cos(2 * math.pi * (k + turn) / corners), r * math.sin(2 * math.pi * (k + turn) / corners))
        for k, r in enumerate(reach)
    ]
    hole = [(10, 10), (10, -10), (-10, -10), (-10, 10)]
    return sg.Polygon(ring, [hole] if draw(st.booleans()) else [])


def ewkb(shape, srid):
    wkb = shape.wkb
    (kind,) = struct.unpack("<I", wkb[1:5])
    return wkb[:1] + struct.pack("<II", kind | 0x20000000, srid) + wkb[5:]


@given(fields())
def test_every_form_gives_the_same_plan(field):
    forms = [
        field,
        field.wkb,
        bytearray(field.wkb),
        field.wkb_hex,
        field.__geo_interface__,
        json.loads(json.dumps(field.__geo_interface__)),
        {"type": "Feature", "properties": {}, "geometry": field.__geo_interface__},
        geopandas.GeoSeries([field]),
        geopandas.GeoDataFrame(geometry=[field]),
    ]
    plans = [tramline.plan(form, width=24, prices=PRICES, ab=((0, 0), (100, 10)), name="f") for form in forms]
    # GeoSeries number their features, and these are the ids.
    assert len({(p["tracks"], p["overlap_m2"], p["uncovered_m2"], p["cost"]) for p in plans}) == 1


@given(fields())
def test_areas_add_up(field):
    plan = tramline.plan(field, width=24, prices=PRICES, ab=((0, 0), (10, 100)))
    assert plan.area_m2 == pytest.approx(field.area, rel=1e-9)
    worked = plan.width_m * plan.track_length_m
    # Swaths are united on a grid of 1e-6 m, and their outlines are some kilometres long.
    assert worked == pytest.approx(plan.area_m2 - plan.uncovered_m2 + plan.overlap_m2, abs=0.01)
    # Another road to the land that is missed: shapely's union of the swaths.
    missed = field
    for feature in plan.features("swaths")["features"]:
        missed = missed.difference(sg.shape(feature["geometry"]))
    assert missed.area == pytest.approx(plan.uncovered_m2, abs=0.01)


@given(st.one_of(st.text(), st.binary(), st.none(), st.integers(), st.dictionaries(st.text(), st.integers())))
def test_what_is_no_field_is_refused_as_such(thing):
    with pytest.raises(tramline.InputError):
        tramline.plan(thing, width=3)


@given(st.binary(min_size=1, max_size=40))
def test_broken_wkb(tail):
    with pytest.raises(tramline.InputError):
        tramline.plan(b"\x01\x03\x00\x00\x00" + tail, width=3)


@pytest.mark.parametrize("number", [math.nan, math.inf, -1, 0, 1e300])
def test_widths_that_are_none(number):
    with pytest.raises(tramline.InputError, match="width"):
        tramline.plan(sg.box(0, 0, 100, 100), width=number)


def test_coordinate_reference_systems():
    utm = shapely.affinity.translate(sg.box(0, 0, 240, 120), 500000, 5_800_000)
    frame = geopandas.GeoSeries([utm], crs="EPSG:32632")
    plans = [
        tramline.plan(frame, width=24, prices=PRICES),
        tramline.plan(utm, crs="EPSG:32632", width=24, prices=PRICES),
        tramline.plan("SRID=32632;" + utm.wkt, width=24, prices=PRICES),
        tramline.plan(ewkb(utm, 32632), width=24, prices=PRICES),
        tramline.plan(frame.to_crs("EPSG:4326"), width=24, prices=PRICES),
    ]
    for plan in plans:
        # On the ground: scale 0.9996 on the central meridian.
        assert plan.area_m2 == pytest.approx(utm.area / 0.9996**2, rel=1e-6)
    assert plans[0].crs == "EPSG:32632"
    tracks = plans[0].layer("tracks")
    assert tracks.crs.to_epsg() == 32632
    assert utm.buffer(1).contains(tracks.unary_union)


def test_degrees_without_a_name_are_refused_with_advice():
    with pytest.raises(tramline.InputError, match="EPSG:4326"):
        tramline.plan(sg.box(9.1, 52.0, 9.11, 52.01), width=6)


def test_messages_name_keywords():
    with pytest.raises(tramline.InputError, match=r"^obstacle_headlands: takes"):
        tramline.plan(sg.box(0, 0, 100, 100), obstacle_headlands="many")
    with pytest.raises(tramline.InputError, match="nonsense"):
        tramline.plan(sg.box(0, 0, 100, 100), nonsense=3)
    with pytest.raises(ValueError, match="no file"):
        tramline.plan("there-is-none.gpkg")


def test_options_that_may_have_several_values_take_them_from_anything():
    from tramline._words import words

    assert words({"done": []}) == []
    assert words({"done": "a.gpkg"}) == ["--done=a.gpkg"]
    assert words({"done": ("a.gpkg", "b.gpkg")}) == ["--done=a.gpkg", "--done=b.gpkg"]
    assert words({"for_": iter([(0.1, 0.2, 1), (0.3, 0.1, 2)])}) == ["--for=0.1,0.2,1", "--for=0.3,0.1,2"]
    assert words({"for_": (0.1, 0.2, 1)}) == ["--for=0.1,0.2,1"]
