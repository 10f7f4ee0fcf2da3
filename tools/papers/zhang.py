"""The tables and figures of Zhang et al. 2023."""

from papers import routes
from papers.tables import Figure, Table, beside

PLAIN = ["--crs", "none", "--log-crs", "none", "--width", str(routes.WIDTH_M), "--repeat", "strict"]
RECTANGLES = ["--field", "examples/papers/pentagon.geojson", *PLAIN, "--quads", "segment", "--switch", "step"]
IRREGULAR = ["evaluate", "examples/papers/irregular.csv", "--field", "examples/papers/irregular.geojson", *PLAIN]
MESHES = ("0.05", "0.02")
# Printed: coverage, repeated, rate; each as in theory and by experiment.
TABLE_1 = {"A3A2": ["1162.76", "1162.84", "70.66", "71.07", "6.08", "6.11"],
           "A3A4": ["1297.74", "1298.43", "130.42", "131.31", "10.05", "10.11"],
           "A1A2": ["1115.54", "1115.67", "58.37", "58.15", "5.23", "5.21"]}
# Printed, by number of points: rings and most meshes of coverage, of leakage.
TABLE_2 = {100: ["1", "888", "2", "4882"], 200: ["1", "2562", "2", "6542"], 300: ["2", "4340", "3", "9892"],
           400: ["3", "5603", "4", "12418"], 500: ["4", "6788", "5", "14788"], 600: ["4", "9041", "6", "19088"],
           645: ["4", "9945", "6", "20896"]}
# Printed, ms: coverage at 0.05 m, leakage at 0.05 m, coverage at 0.02 m.
MILLISECONDS = {100: (783, 1087, 975), 200: (1560, 5940, 2274), 300: (2386, 16982, 4188), 400: (3274, 32556, 7198),
                500: (4267, 51843, 12166), 600: (6004, 76816, 18445), 645: (6663, 90297, 21021)}
ENDS = {"strip": "strip", "centre": "centre line"}
LEGS = {"none": "none", "direct": "direct", "square": "perpendicular", "along": "along the edge, or perpendicular"}


def mesh(side):
    return ["--engine", "mesh", "--mesh", side]


def per_mille(found, true):
    return f"{1000 * (found / true - 1):+.2f}" if true else "0" if found == 0 else "–"


def pentagon_table(program):
    rows = []
    for route in routes.ROUTES:
        drive = ["evaluate", f"examples/papers/{route.name}.csv", *RECTANGLES]
        exact = program.json(*drive)
        cells = [route.edge, ENDS[route.ends], LEGS[route.legs]]
        for key, true in (("covered_m2", route.covered_m2), ("repeated_m2", route.repeated_m2), ("missed_m2", route.missed_m2)):
            cells += [f"{true:.3f}", f"{exact[key]:.2f}"]
        cells.append(f"{100 * exact['repeated_rate']:.2f}")
        for side in MESHES:
            found = program.json(*drive, *mesh(side))
            cells += [per_mille(found["covered_m2"], route.covered_m2), per_mille(found["repeated_m2"], route.repeated_m2),
                      f"{found['missed_m2'] - route.missed_m2:+.2f}"]
        rows.append(cells)
    errors = [f"{side} m: {what}" for side in MESHES for what in ("coverage ‰", "repeated ‰", "leakage m²")]
    return Table("zhang-table-1", "Zhang table 1: routes over the pentagon",
                 ["first row along", "row ends", "legs", "coverage m²", "exact engine", "repeated m²", "exact engine", "leakage m²",
                  "exact engine", "rate %", *errors], rows,
                 "Rows are 4 m wide; the values before those of the exact engine are by polygon booleans; errors of the "
                 "mesh engine follow. The "
                 "paper's own errors at 0.05 m are up to 0.53 ‰ of coverage and 6.8 ‰ of repeated land: the same order.")


def printed_table(_program):
    rows = []
    for edge, (covered, covered_found, repeated, repeated_found, rate, rate_found) in TABLE_1.items():
        nearest = min((r for r in routes.ROUTES if r.edge == edge), key=lambda r: abs(r.covered_m2 - float(covered))
                      + abs(r.repeated_m2 - float(repeated)))
        rows.append([edge, covered, covered_found, per_mille(float(covered_found), float(covered)), repeated, repeated_found,
                     per_mille(float(repeated_found), float(repeated)), rate, rate_found,
                     f"{100 * float(repeated) / float(covered):.2f}",
                     f"{ENDS[nearest.ends]}, {LEGS[nearest.legs]}: {nearest.covered_m2:.2f}, {nearest.repeated_m2:.2f}"])
    return Table("zhang-table-1-printed", "Zhang table 1 as printed",
                 ["direction", "coverage m²", "experiment", "‰", "repeated m²", "experiment", "‰", "rate %", "experiment",
                  "repeated / coverage, %", "nearest of the routes above"], rows,
                 "The routes are those of another paper and not described. No route tried gives all three rows: A3A4 "
                 "would need a path of 357 m, and "
                 "eight rows with their legs have 334 m at most. The repeated land of A1A2 is that of the last route "
                 "above; it leaves 12.5 m² "
                 "out, where the paper has no leakage.")


def slices(program, side):
    found = program.json(*IRREGULAR, *mesh(side), "--slice", 100)["slices"]
    if [one["fixes"] for one in found] != list(TABLE_2):
        raise ValueError(f"slices end at {[one['fixes'] for one in found]}")
    return found


def table_2(program):
    rows = []
    for one, (points, printed) in zip(slices(program, "0.05"), TABLE_2.items()):
        covered, leaked, _ = MILLISECONDS[points]
        program.times.append([f"Zhang table 2: {points} points, coverage and leakage", f"{one['seconds']:.4f}",
                              f"{(covered + leaked) / 1000:.3f}"])
        meshes = one["meshes"]
        rows.append([str(points), *beside(one["covered_rings"], printed[0], "{}"), *beside(meshes["covered"]["most"], printed[1], "{}"),
                     *beside(one["missed_regions"], printed[2], "{}"), *beside(meshes["missed"]["most"], printed[3], "{}")])
    return Table("zhang-table-2", "Zhang table 2: an irregular route, 0.05 m",
                 ["points", "rings of coverage", "printed", "most meshes", "printed", "leakage regions", "printed",
                  "most meshes", "printed"], rows,
                 "Another route of the same kind, and a smaller field: fewer meshes. In the end coverage has one outer "
                 "boundary and three holes, as "
                 "printed. The times are in `times.md`.")


def table_3(program):
    exact = program.json(*IRREGULAR)
    rows = [["exact", *(f"{exact[key]:.2f}" for key in AREAS), "", "", ""]]
    for side in MESHES:
        found = slices(program, side)
        for one, points in zip(found, TABLE_2):
            program.times.append([f"Zhang table 3: {points} points, {side} m (here all areas)", f"{one['seconds']:.4f}",
                                  f"{MILLISECONDS[points][0 if side == '0.05' else 2] / 1000:.3f}"])
        rows.append([f"{side} m", *(f"{found[-1][key]:.2f}" for key in AREAS),
                     *(per_mille(found[-1][key], exact[key]) for key in AREAS)])
    coarse, fine = rows[1], rows[2]
    rows.append(["0.05 against 0.02 m", "", "", "", *(per_mille(float(coarse[i]), float(fine[i])) for i in (1, 2, 3))])
    rows.append(["the same as printed", "", "", "", "0.3", "5.9", "6.8"])
    return Table("zhang-table-3", "Zhang table 3 and the errors of Zhang §3.2: mesh scales on the irregular route",
                 ["mesh", "coverage m²", "repeated m²", "leakage m²", "coverage ‰", "repeated ‰", "leakage ‰"], rows,
                 "Errors are against the exact engine, of which the paper has none. Table 3 itself prints times, which "
                 "are in `times.md`.")


AREAS = ("covered_m2", "repeated_m2", "missed_m2")
TABLES = {"zhang-table-1": pentagon_table, "zhang-table-1-printed": printed_table, "zhang-table-2": table_2, "zhang-table-3": table_3}


def figures(program):
    last = routes.ROUTES[-1]
    return [Figure("zhang-table-1", "The pentagon of Zhang §3.1, driven from A1 to A2: row ends at the centre line, "
                                    "legs along the edge or perpendicular.",
                   lambda file: program.picture(file, "evaluate", f"examples/papers/{last.name}.csv", *RECTANGLES)),
            Figure("zhang-figure-18", "As Zhang figure 18: coverage and leakage of an irregular route, mesh engine, 0.05 m.",
                   lambda file: program.picture(file, *IRREGULAR, *mesh("0.05")))]


TITLE = "Zhang et al. 2023, repeated"
INTRODUCTION = """
*Agronomy* 13:1631. The pentagon of §3.1 is printed, its routes are not: eleven that are fully described stand for them. The
irregular route of §3.2 is not printed either; one of the same kind is drawn: 645 points, 4 m wide, beginning at 180°. Drives and
fields are in `examples/papers`; land worked twice counts as repeated whoever worked it (`--repeat strict`).
"""
ENDING = """
## Not repeated

- Figures 1 to 16 explain the platform and the algorithm; figure 17 is a screen: see [page.md](../page.md) for ours.
- The theoretical areas of table 1: see there.
"""
