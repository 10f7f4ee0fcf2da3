#!/usr/bin/env python3
"""What a line card says, read from the PDF by pdftotext, against values worked out by hand.

The field is 200 m by 100 m. With a working width of 10 m and two headland passes, tracks from south to north lie 25, 35, …,
175 m from its western edge and reach from 20 m to 80 m north of its southern one.
"""

import json
import math
import re
import subprocess

from rectangle import LAT_DEGREE_M, LON_DEGREE_M, OfRectangle, convergence_deg, place, run_tests, write_field

TRACKS = 16
NAME = "Große Breite"


def run(*args):
    return subprocess.run(args, check=True, capture_output=True, text=True).stdout


class LineCards(OfRectangle):
    @classmethod
    def prepare(cls):
        write_field(cls.folder / "field.geojson", NAME)
        cls.plan = cls.planned("plan.gpkg", "--headlands", "2", "--ab", cls.meridian)
        cls.text = cls.card("card.pdf", cls.plan)

    @classmethod
    def card(cls, name, *plans):
        run(cls.tramline, "export", *plans, "-o", str(cls.folder / name), "--quiet")
        return run("pdftotext", "-layout", str(cls.folder / name), "-")

    def end(self, letter):
        """Longitude and latitude of A or B, which the card says twice."""
        (found,) = re.findall(letter + r": (\d+\.\d{7})° N, (\d+\.\d{7})° E, or (\d+)° (\d+\.\d{5})' N, (\d+)° (\d+\.\d{5})' E", self.text)
        lat, lon, lat_whole, lat_minutes, lon_whole, lon_minutes = map(float, found)
        self.assertAlmostEqual(lat_whole + lat_minutes / 60, lat, delta=1.4e-7)
        self.assertAlmostEqual(lon_whole + lon_minutes / 60, lon, delta=1.4e-7)
        self.assertLess(max(lat_minutes, lon_minutes), 60)
        return lon, lat

    def test_a_and_b_are_the_ends_of_a_track(self):
        (lon_a, lat_a), (lon_b, lat_b) = self.end("A"), self.end("B")
        north = sorted((lat - 52) * LAT_DEGREE_M for lat in (lat_a, lat_b))
        self.assertAlmostEqual(north[0], 20, delta=0.02)
        self.assertAlmostEqual(north[1], 80, delta=0.02)
        east = (lon_a - 9) * LON_DEGREE_M
        self.assertAlmostEqual((east - 25) % 10, 0 if (east - 25) % 10 < 5 else 10, delta=0.02)
        self.assertAlmostEqual((lon_b - 9) * LON_DEGREE_M, east, delta=0.02)

    def test_the_heading_is_from_true_north(self):
        (lon_a, lat_a), (_, lat_b) = self.end("A"), self.end("B")
        (heading, length) = map(float, re.findall(r"heading (\d+\.\d{4})° from true north, (\d+\.\d) m long", self.text)[0])
        # Parallel to the meridian of the western edge, so east of it off the meridian there by the convergence.
        wanted = (0 if lat_b > lat_a else 180) + convergence_deg((lon_a - 9) * LON_DEGREE_M)
        self.assertAlmostEqual(math.remainder(heading - wanted, 360), 0, delta=1e-4)
        self.assertEqual(length, 60)

    def test_width_headland_and_hours(self):
        self.assertIn("Working width: 10 m.", self.text)
        # Rectangles of 190 m by 90 m and of 170 m by 70 m, whose corners are arcs of 6 m: 560 + 480 - 8·6·(2 - π/2) = 1019 m.
        self.assertIn("Headland: 2 passes, 1.02 km, after the tracks.", self.text)
        run(self.tramline, "export", self.plan, "-o", str(self.folder / "legs.geojson"), "--layer", "route", "--quiet")
        legs = [leg["properties"] for leg in json.loads((self.folder / "legs.geojson").read_text())["features"]]
        hours = sum(leg["length_m"] / (2.5 if leg["work"] else 1.5) for leg in legs) / 3600
        kilometres = sum(leg["length_m"] for leg in legs) / 1000
        self.assertEqual({leg["gear"] for leg in legs}, {"forward"})
        self.assertIn(f"Time: {hours:.2f} h for {kilometres:.2f} km of route, turns and ways included.", self.text)

    def order(self):
        (row,) = re.findall(r"Order of the tracks, counted from AB 1 to the right of A-B, to the left with a minus: ([^.]*)\.",
                            re.sub(r"\s+", " ", self.text))
        out = []
        for part in row.split(", "):
            first, _, last = part.partition(" to ")
            step = 1 if not last or int(last) >= int(first) else -1
            out += list(range(int(first), int(last or first) + step, step))
        return out

    def test_tracks_are_counted_to_the_right_in_driving_order(self):
        (lon_a, lat_a), (_, lat_b) = self.end("A"), self.end("B")
        # Tracks from 0 in the west; to the right of the line is east where it leads north.
        mine = round(((lon_a - 9) * LON_DEGREE_M - 25) / 10)
        side = 1 if lat_b > lat_a else -1
        order = self.order()
        self.assertEqual(sorted(order), sorted(side * (i - mine) for i in range(TRACKS)))
        run(self.tramline, "export", self.plan, "-o", str(self.folder / "tracks.geojson"), "--layer", "tracks", "--quiet")
        driven = json.loads((self.folder / "tracks.geojson").read_text())["features"]
        driven.sort(key=lambda track: track["properties"]["order"])
        from_west = [round(((track["geometry"]["coordinates"][0][0] - 9) * LON_DEGREE_M - 25) / 10) for track in driven]
        self.assertEqual(order, [side * (i - mine) for i in from_west])

    def test_the_map_has_a_title_north_and_the_ends_of_the_line(self):
        head = self.text[:self.text.index("Working width")]
        self.assertTrue(head.startswith(NAME))
        for wanted in ("A AB 1", "B AB 1"):
            self.assertIn(wanted, head)
        self.assertRegex(head, r"\bN\n")

    def test_a_page_for_each_field(self):
        write_field(self.folder / "field.geojson", "Οικόπεδο 7", east_m=300)
        other = self.planned("other.gpkg", "--headlands", "2", "--route", "none")
        pages = self.card("cards.pdf", self.plan, other).split("\f")
        self.assertEqual([page.split("\n")[0].strip() for page in pages if page.strip()], [NAME, "Οικόπεδο 7"])
        self.assertIn("turns come on top, no route is planned.", pages[1])
        self.assertRegex(pages[1], r"Headland: 2 passes, 1\.02 km\.")

    def test_of_a_curve_the_ends_are_given(self):
        write_field(self.folder / "field.geojson", "bend")
        places = " ".join("{:.9f},{:.9f}".format(*place(x, y)) for x, y in ((0, 40), (100, 55), (200, 40)))
        (self.folder / "guide.kml").write_text(
            '<kml xmlns="http://www.opengis.net/kml/2.2"><Placemark><LineString><coordinates>' + places +
            "</coordinates></LineString></Placemark></kml>")
        text = self.card("curve.pdf", self.planned("curve.gpkg", "--headlands", "2", "--guide", str(self.folder / "guide.kml"), "--route", "none"))
        self.assertIn("Curve 1", text)
        self.assertIn("a curve: these are its ends only; a display needs its points from a file", text)
        self.assertNotIn("heading", text)


if __name__ == "__main__":
    run_tests()
