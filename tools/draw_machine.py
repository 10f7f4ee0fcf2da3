#!/usr/bin/env python3
"""Draws docs/images/machine.svg: the lengths of a machine file, seen from above, for a mounted and a towed implement.

The same bytes each time it runs.
"""

import pathlib

SCALE = 46  # px/m
INK, FAINT, MACHINE, TOOL, DIMENSION = "#26323a", "#7b868c", "#dfe6ea", "#f6d9a0", "#1f4e8c"


class Drawing:
    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def box(self, x0, y0, x1, y1, fill):
        self.parts.append(
            f'<rect x="{min(x0, x1):.1f}" y="{min(y0, y1):.1f}" width="{abs(x1 - x0):.1f}" height="{abs(y1 - y0):.1f}"'
            f' fill="{fill}" stroke="{INK}" stroke-width="1.2"/>')

    def line(self, x0, y0, x1, y1, colour=INK, width=1.2, dashes=""):
        more = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.parts.append(f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke="{colour}" stroke-width="{width}"{more}/>')

    def text(self, x, y, words, colour=INK, anchor="middle", weight="normal", size=14):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-weight="{weight}"'
                          f' font-size="{size}">{words}</text>')

    def dot(self, x, y, colour=INK):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>')

    def arrow_end(self, x, y, dx, dy):
        self.parts.append(f'<path d="M{x:.1f} {y:.1f}l{-8 * dx + 3 * dy:.1f} {-8 * dy + 3 * dx:.1f}l{-6 * dy:.1f} {-6 * dx:.1f}z"'
                          f' fill="{DIMENSION}"/>')

    def across(self, x0, x1, y, words, from_y0=None, from_y1=None, label="above"):
        """A dimension along the page's x."""
        for x, start in ((x0, from_y0), (x1, from_y1)):
            if start is not None:
                self.line(x, start, x, y, FAINT, 0.8, "3 3")
        self.line(x0, y, x1, y, DIMENSION)
        if abs(x1 - x0) > 18:
            self.arrow_end(min(x0, x1), y, -1, 0)
            self.arrow_end(max(x0, x1), y, 1, 0)
        self.text((x0 + x1) / 2, y - 6 if label == "above" else y + 17, words, DIMENSION)

    def upright(self, x, y0, y1, words, from_x=None):
        """A dimension along the page's y."""
        if from_x is not None:
            for y in (y0, y1):
                self.line(from_x, y, x, y, FAINT, 0.8, "3 3")
        self.line(x, y0, x, y1, DIMENSION)
        self.arrow_end(x, min(y0, y1), 0, -1)
        self.arrow_end(x, max(y0, y1), 0, 1)
        middle = (y0 + y1) / 2
        self.parts.append(f'<text transform="translate({x - 7:.1f} {middle:.1f}) rotate(-90)" fill="{DIMENSION}"'
                          f' text-anchor="middle" font-size="14">{words}</text>')

    def svg(self):
        width, height = self.size
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
                ' font-family="DejaVu Sans, sans-serif" fill="none">\n'
                f'<rect width="{width}" height="{height}" fill="#ffffff"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


def vehicle(d, axle_x, y, ahead_m, width_m, behind_m):
    """A tractor that drives to the right."""
    half = width_m / 2 * SCALE
    d.box(axle_x - behind_m * SCALE, y - 0.45 * half, axle_x + ahead_m * SCALE, y + 0.45 * half, MACHINE)
    for side in (-1, 1):
        d.box(axle_x - 0.75 * SCALE, y + side * half, axle_x + 0.75 * SCALE, y + side * (half - 18), MACHINE)
        front = axle_x + (ahead_m - 1.1) * SCALE
        d.box(front - 0.5 * SCALE, y + side * (half - 6), front + 0.5 * SCALE, y + side * (half - 20), MACHINE)
    d.line(axle_x, y - half - 14, axle_x, y + half + 14, INK, 1, "7 4")
    d.dot(axle_x, y)


def mounted(d, y):
    axle = 330
    ahead, width, offset, overhang, working = 3.6, 2.5, 1.9, 0.8, 6
    half, work_half = width / 2 * SCALE, working / 2 * SCALE
    at = axle - offset * SCALE
    d.box(at, y - work_half, at - overhang * SCALE, y + work_half, TOOL)
    d.line(at, y - work_half, at, y + work_half, INK, 3)
    d.line(at, y, axle - 0.8 * SCALE, y, INK, 5)
    vehicle(d, axle, y, ahead, width, 0.8)
    below = y + work_half
    d.across(at, axle, below + 68, "implement_offset_m", y + work_half, y + half + 14, "below")
    d.across(axle, axle + ahead * SCALE, below + 34, "front_overhang_m", None, y + 0.45 * half, "below")
    d.across(at - overhang * SCALE, at, y - work_half - 14, "rear_overhang_m", y - work_half, y - work_half)
    d.upright(axle + ahead * SCALE + 50, y - half, y + half, "vehicle_width_m", axle + 0.75 * SCALE)
    d.upright(at - overhang * SCALE - 40, y - work_half, y + work_half, "width_m", at - overhang * SCALE)
    d.text(axle, y - half - 22, "rear axle")
    d.text(at + 10, y - work_half + 18, "the line where it works", INK, "start")
    d.text(56, y - work_half - 50, 'implement = "mounted": it turns with the vehicle', INK, "start", "bold", 16)


def towed(d, y):
    axle = 560
    ahead, width, offset, drawbar, overhang, working = 3.6, 2.5, 1.2, 5, 1, 6
    half, work_half = width / 2 * SCALE, working / 2 * SCALE
    hitch = axle - offset * SCALE
    at = hitch - drawbar * SCALE
    d.box(at, y - work_half, at - overhang * SCALE, y + work_half, TOOL)
    d.line(at, y - work_half, at, y + work_half, INK, 3)
    d.line(hitch, y, at, y, INK, 5)
    for side in (-1, 1):
        d.box(at - 0.5 * SCALE, y + side * half, at + 0.5 * SCALE, y + side * (half - 14), MACHINE)
    vehicle(d, axle, y, ahead, width, 0.8)
    d.line(axle - 0.8 * SCALE, y, hitch, y, INK, 5)
    d.dot(hitch, y, DIMENSION)
    below = y + work_half
    d.across(at, hitch, below + 34, "drawbar_m", y + work_half, y, "below")
    d.across(hitch, axle, below + 68, "implement_offset_m", None, y + half + 14, "below")
    d.across(axle, axle + ahead * SCALE, below + 34, "front_overhang_m", None, y + 0.45 * half, "below")
    d.across(at - overhang * SCALE, at, y - work_half - 14, "rear_overhang_m", y - work_half, y - work_half)
    d.upright(at - overhang * SCALE - 40, y - work_half, y + work_half, "width_m", at - overhang * SCALE)
    d.text(axle, y - half - 22, "rear axle")
    d.text(hitch, y - 14, "hitch")
    d.text(at + 10, y - work_half + 18, "the implement's axle, where it works", INK, "start")
    d.text(56, y - work_half - 50, 'implement = "towed": it follows on a drawbar', INK, "start", "bold", 16)


def main():
    d = Drawing(800, 920)
    mounted(d, 220)
    towed(d, 670)
    out = pathlib.Path(__file__).resolve().parent.parent / "docs" / "images" / "machine.svg"
    out.write_text(d.svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
