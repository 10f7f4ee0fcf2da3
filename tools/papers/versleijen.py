"""The tables and figures of Versleijen 2019, on fields like his."""

from findings import SCENARIOS
from papers.tables import Figure, Table, beside

PLAIN = ["--crs", "none", "--like", "versleijen"]
WAYS_ROUND = ["examples/ways-round.geojson", "--avoid", "paper", "--strategy", "sweep", "--width", "3"]
ANY_WIDTH = ["--avoid-threshold", "100"]  # the obstacles of these figures are wider than the swath
MINIMISED = {"1": "overlap", "2": "uncovered", "3": "turns"}
SETTLED = ["--merge", "15", "--decomposition", "205"]  # Versleijen table 5


def field(name):
    return [f"examples/papers/{name}.geojson", *PLAIN]


# Printed: area m², obstacles; candidate directions, seconds; overlap %, uncovered %, turns, subfields in scenarios 1 to 3.
TEST_FIELDS = {
    "1739": ["78970", "2", "69", "84.34", ["0.32", "1.13", "189", "2"], ["0.35", "0.56", "192", "3"], ["0.53", "0.97", "111", "1"]],
    "5458": ["44543", "1", "40", "28.16", ["0.53", "0.72", "112", "1"], ["0.61", "0.65", "113", "2"], ["0.64", "0.92", "88", "3"]],
    "1087": ["50210", "1", "38", "24.15", ["0.53", "0.70", "143", "3"], ["0.82", "0.59", "129", "3"], ["0.55", "0.72", "112", "4"]]}
SCENARIO_TABLES = {"1739": 6, "5458": 7, "1087": 8}
MERGE = {0: ["0.55", "0.72", "112"], 15: ["0.55", "0.72", "112"], 30: ["0.55", "0.67", "112"], 60: ["0.61", "0.64", "113"]}
DECOMPOSITION = {180: ["0.55", "0.72", "112", "40"], 195: ["0.86", "0.86", "112", "15"], 210: ["0.86", "0.86", "112", "15"],
                 240: ["0.86", "0.86", "112", "15"]}
# The options of the field; then overlap m², uncovered m², turns, cost: of the other's lines (cost in scenarios 1 to 3), and of
# the thesis' program in scenarios 1 to 3 with the change in per cent.
COMPARED = {
    12: ("oksanen", ["--width", "2.5", "--radius", "6", *SETTLED], ["145.4", "359.6", "95"], ["14534960", "35957858", "9500410"],
         [["141.0", "193.4", "139", "14095632", "-3.02"], ["208.0", "154.4", "118", "15444710", "-57.05"],
          ["157.4", "226.0", "95", "9500288", "-0.001"]]),
    13: ("liu", ["--width", "10", "--radius", "3"], ["2127.5", "1728.4", "39"], ["212749639", "172840438", "3903817"],
         [["725.1", "876.7", "42", "72506610", "-65.91"], ["725.1", "876.7", "42", "87669953", "-49.28"],
          ["855.0", "850.2", "38", "3801667", "-2.62"]]),
    14: ("linne", ["--width", "3", "--radius", "6", *SETTLED], ["1214.4", "1190.6", "118"], ["121441723", "119065493", "11802287"],
         [["611.1", "927", "252", "61106349", "-49.68"], ["726.0", "639.8", "124", "63981896", "-46.26"],
          ["726.0", "639.8", "124", "12401242", "5.07"]])}
FIGURES = ["overlap %", "printed", "uncovered %", "printed", "turns", "printed"]


def figures_of(plan, printed):
    return [*beside(plan["overlap_pct"], printed[0]), *beside(plan["uncovered_pct"], printed[1]),
            *beside(plan["turns"], printed[2], "{}")]


def table_1(program):
    rows = []
    for name, (area, obstacles, *_) in TEST_FIELDS.items():
        plan = program.json("plan", *field(f"field-{name}"), "--weights", SCENARIOS["3"])
        rows.append([name, *beside(plan["area_m2"], area, "{:.0f}"), *beside(plan["obstacles"], obstacles, "{}")])
    return Table("versleijen-table-1", "Versleijen table 1: test fields",
                 ["field", "area m²", "printed", "obstacles", "printed"], rows,
                 "Drawn to these areas; boundaries are rounded to millimetres.")


def scenario_table(name):
    def make(program):
        rows = []
        for scenario, weights in SCENARIOS.items():
            plan = program.json("plan", *field(f"field-{name}"), "--weights", weights)
            printed = TEST_FIELDS[name][3 + int(scenario)]
            rows.append([f"{scenario}: {MINIMISED[scenario]}", *figures_of(plan, printed),
                         *beside(plan["subfields"], printed[3], "{}")])
        number = SCENARIO_TABLES[name]
        return Table(f"versleijen-table-{number}", f"Versleijen table {number}: scenarios on a field like {name}",
                     ["scenario, least", *FIGURES, "subfields", "printed"], rows, WHY_SCENARIOS)
    return make


WHY_SCENARIOS = ("Another outline, so other figures. What repeats: the factor of a scenario is least in that scenario, "
                 "scenarios 1 and 2 take "
                 "more turns than 3, all percentages are below about 1.")


def table_9(program):
    rows = []
    for name, (_, obstacles, directions, seconds, *_) in TEST_FIELDS.items():
        plan = program.timed(f"Versleijen table 9, field like {name}", seconds, "plan", *field(f"field-{name}"), "--weights",
                             SCENARIOS["3"], "--threads", 1)
        rows.append([name, *beside(plan["obstacles"], obstacles, "{}"), *beside(plan["directions_tried"], directions, "{}")])
    return Table("versleijen-table-9", "Versleijen table 9: directions tried",
                 ["field", "obstacles", "printed", "directions", "printed"],
                 rows, "One direction for each different edge of field and obstacles. The times are in `times.md`.")


def table_10(program):
    rows = []
    for name, source in (("like 1087", field("field-1087")), ("roadside", ["examples/roadside.geojson", *PLAIN[2:]])):
        for merge, printed in MERGE.items():
            plan = program.json("plan", *source, "--weights", SCENARIOS["3"], "--merge", merge)
            cells = figures_of(plan, printed if name == "like 1087" else [""] * 3)
            rows.append([name, str(merge), *cells, str(plan["subfields"])])
    return Table("versleijen-table-10", "Versleijen table 10: merge thresholds on a field like 1087 and on `roadside`, "
                                        "scenario 3",
                 ["field", "merge °", *FIGURES, "subfields"], rows,
                 "The thesis finds that small thresholds change nothing, and that 60° costs a turn. The field like 1087 "
                 "is one subfield at "
                 "any threshold; `roadside` shows what the thesis saw.")


def table_11(program):
    rows = []
    for threshold, printed in DECOMPOSITION.items():
        plan = program.measured(threshold, *field("field-1087"), "--weights", SCENARIOS["3"], "--decomposition", threshold)
        rows.append([str(threshold), *figures_of(plan, printed), *beside(plan["corners"], printed[3], "{}")])
    return Table("versleijen-table-11", "Versleijen table 11: decomposition thresholds on a field like 1087, scenario 3",
                 ["decomposition °", *FIGURES, "corners above", "printed"], rows,
                 "Most corners are a little above 180°, as in the thesis. The thesis calls the first column the merge "
                 "threshold, and plans 205°, "
                 "230° and 255° in its table 4: errors in print.")


def compared_table(number):
    def make(program):
        name, options, other, costs, printed_plans = COMPARED[number]
        rows = []
        for (scenario, weights), cost, printed in zip(SCENARIOS.items(), costs, printed_plans):
            of_lines = [f"examples/papers/{name}-lines.geojson", "--field", *field(name), *options[:4], "--weights", weights]
            lines, plan = program.json("price", *of_lines), program.json("plan", *field(name), *options, "--weights", weights)
            for source, found, paper in (("other's lines", lines, [*other, cost]), ("sweep", plan, printed)):
                change = f"{100 * (plan['cost'] / lines['cost'] - 1):+.2f}" if found is plan else ""
                rows.append([scenario, source, *beside(found["overlap_m2"], paper[0], "{:.1f}"),
                             *beside(found["uncovered_m2"], paper[1], "{:.1f}"), *beside(found["turns"], paper[2], "{}"),
                             *beside(found["cost"], paper[3], "{:.0f}"), change, paper[4] if found is plan else ""])
        title = {"oksanen": "Oksanen's", "liu": "Liu's", "linne": "that near Linne"}[name]
        return Table(f"versleijen-table-{number}", f"Versleijen table {number}: a field like {title}",
                     ["scenario", "plan", "overlap m²", "printed", "uncovered m²", "printed", "turns", "printed", "cost",
                      "printed", "change %", "printed"], rows, WHY_COMPARED[name])
    return make


WHY_COMPARED = {
    "oksanen": "Two directions are drawn as the other's plan, four subfields in the thesis. Least overlap and least "
               "uncovered are won by the "
               "search, turns are nearly equal, as printed.",
    "liu": "The other's lines lie along no edge, as in the thesis, which the search would never try; ours are cut at "
           "obstacles, Liu's "
           "go round some. His two large uncovered areas (404.7 and 510.3 m²) are not drawn again, and ours "
           "save no turn in scenario 3: both plans have 35.",
    "linne": "The other's lines are arcs, spaced unevenly by up to 0.15 m, so that their areas are of the printed size. "
             "What repeats: the search, "
             "which has straight tracks only, overlaps and leaves less, and loses scenario 3 to curved tracks."}

TABLES = {"versleijen-table-1": table_1, "versleijen-table-6": scenario_table("1739"), "versleijen-table-7": scenario_table("5458"),
          "versleijen-table-8": scenario_table("1087"), "versleijen-table-9": table_9, "versleijen-table-10": table_10,
          "versleijen-table-11": table_11, **{f"versleijen-table-{number}": compared_table(number) for number in COMPARED}}


def radius_table(program):
    rows = []
    for radius in (3, 6, 9, 12):
        plan = program.json("plan", *WAYS_ROUND, "--where", "id = 'mast'", "--radius", radius, *ANY_WIDTH)
        rows.append([str(radius), f"{plan['overlap_m2']:.1f}", f"{plan['uncovered_m2']:.1f}", str(plan["detours"])])
    return Table("versleijen-figure-37", "Versleijen figure 37 in numbers: turning radius",
                 ["radius m", "overlap m²", "uncovered m²", "detours"], rows,
                 "The thesis shows a picture only and says that overlap grows with the radius: so it does.")


def room_table(program):
    rows = []
    for what, room in (("half the width", ["--avoid-room", "5"]), ("as far as it has to", [])):
        plan = program.json("plan", *field("liu"), *COMPARED[13][1], "--weights", SCENARIOS["3"], *room)
        rows.append([what, str(plan["detours"]), str(plan["turns"]), f"{plan['overlap_m2']:.1f}", f"{plan['uncovered_m2']:.1f}"])
    return Table("versleijen-figure-50", "Versleijen figure 50 in numbers: room for detours on a field like Liu's, scenario 3",
                 ["a detour may leave its track by", "detours", "turns", "overlap m²", "uncovered m²"], rows,
                 "The program of the thesis cut tracks that would have had to go farther than half the width; the "
                 "thesis expects fewer turns "
                 "and more overlap without that error (its section 4.3).")


TABLES.update({"versleijen-figure-37": radius_table, "versleijen-figure-50": room_table})


def picture(name, caption, program, *arguments):
    return Figure(name, caption, lambda file: program.picture(file, *arguments))


def figures(program):
    out = []
    for (name, scenario), number in {("1739", "1"): 24, ("1739", "3"): 27, ("5458", "1"): 28, ("5458", "3"): 30, ("1087", "1"): 31,
                                     ("1087", "3"): 33}.items():
        out.append(picture(f"versleijen-figure-{number}", f"As Versleijen figure {number}: a field like {name}, least "
                                                          f"{MINIMISED[scenario]}.",
                           program, "plan", *field(f"field-{name}"), "--weights", SCENARIOS[scenario]))
    out.append(Figure("versleijen-figure-25", "As Versleijen figure 25: a pylon in a field like 1739, least overlap.",
                      lambda file: program.close_up(file, 1, *field("field-1739"), "--weights", SCENARIOS["1"])))
    for radius in (3, 6, 9, 12):
        out.append(Figure(f"versleijen-figure-37-{radius}m",
                          f"As Versleijen figures 18 and 37: the rule of the thesis round a mast, turning radius {radius} m.",
                          lambda file, r=radius: program.close_up(file, 1, *WAYS_ROUND, "--where", "id = 'mast'", "--radius",
                                                                  r, *ANY_WIDTH)))
    out.append(Figure("versleijen-figure-38", "As Versleijen figures 19 and 38: round a larger obstacle of any shape.",
                      lambda file: program.close_up(file, 1, *WAYS_ROUND, "--where", "id = 'copse'", "--radius", 6,
                                                    *ANY_WIDTH)))
    lines_figures, plan_figures = {"oksanen": 40, "liu": 44, "linne": 47}, {"oksanen": 43, "liu": 46, "linne": 49}
    for name, options, *_ in COMPARED.values():
        out.append(picture(f"versleijen-figure-{lines_figures[name]}",
                           f"As Versleijen figure {lines_figures[name]}: the other's lines on the field like "
                           f"{name.title()}'s.", program, "price",
                           f"examples/papers/{name}-lines.geojson", "--field", *field(name), *options[:4]))
        out.append(picture(f"versleijen-figure-{plan_figures[name]}",
                           f"As Versleijen figure {plan_figures[name]}: the same field, least turns.", program, "plan",
                           *field(name), *options, "--weights", SCENARIOS["3"]))
    out.append(picture("versleijen-figure-50", "As Versleijen figure 50: detours on the field like Liu's with room of "
                                               "half the width only.",
                       program, "plan", *field("liu"), *COMPARED[13][1], "--weights", SCENARIOS["3"], "--avoid-room", 5))
    return out


TITLE = "Versleijen 2019, repeated"
INTRODUCTION = """
*Path planning on agricultural fields with obstacles*, MSc thesis, Wageningen University. All plans are made with `--like versleijen`:
3 m wide, turning radius 6 m, thresholds of 0° and 180° where nothing else is said. The thesis prints neither the outlines of its
fields nor the lines it compares with: those here are drawn, of the printed area and number of obstacles and of a kind like that in
its figures (`examples/papers`). Compare how figures change from row to row, not the figures themselves.
"""
ENDING = """
## Not repeated

- Tables 2 to 5 are settings, and used here; table 3 is in [obstacles.md](../obstacles.md).
- Figures 1 to 17, 20 to 23 and 39 explain, or show fields that are not printed. Figures 26, 29, 32, 34, 41, 42, 45
  and 48 are further pictures of the plans in tables 6 to 14.
- Figures 35 and 36 are those of tables 10 and 11.
- On real fields: [findings.md](../findings.md), by `tools/findings.py`.
"""
