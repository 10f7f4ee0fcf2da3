"""Repeats the tables and figures of the three papers: writes examples/papers and docs/papers.

    PYTHONPATH=tools python3 -m papers [--tramline PATH] [--out FOLDER] [--tables NAME ...] [--real]

The files are the same from run to run, but for times.md, which is not kept. With --tables only these tables are written, as
CSV. With --real, tools/findings.py and tools/metric_map.py repeat tables on real fields, into out/papers.
"""

import argparse
import multiprocessing
import subprocess
import sys
from pathlib import Path

from papers import lookalikes, routes, versleijen, zhang, zhou
from papers.pictures import shrink
from papers.program import ROOT, Program
from papers.tables import grid, page

PAPERS = {"versleijen": versleijen, "zhou": zhou, "zhang": zhang}
TABLES = {name: make for paper in PAPERS.values() for name, make in paper.TABLES.items()}
REAL = ("findings", "metric_map")


def write_inputs(folder):
    folder.mkdir(parents=True, exist_ok=True)
    lookalikes.draw(folder)
    routes.draw(folder)


def write_tables(program, folder, names):
    """The tables, each written as CSV."""
    folder.mkdir(parents=True, exist_ok=True)
    made = []
    for name in names:
        made.append(TABLES[name](program))
        (folder / f"{name}.csv").write_text(made[-1].csv(), encoding="utf-8")
    return made


def write_page(program, out, name):
    paper = PAPERS[name]
    tables, drawn = write_tables(program, out / "tables", paper.TABLES), paper.figures(program)
    pictures = [out / "pictures" / f"{figure.name}.png" for figure in drawn]
    for figure, file in zip(drawn, pictures):
        file.parent.mkdir(exist_ok=True)
        figure.draw(file)
    text = page(paper.TITLE, paper.INTRODUCTION, tables, drawn, paper.ENDING)
    (out / f"{name}.md").write_text(text, encoding="utf-8")
    return pictures


def write_times(program, file):
    lines = grid(["what", "seconds on this machine", "seconds in the paper"], program.times)
    file.write_text("# Times\n\n" + "\n".join(lines) + "\n", encoding="utf-8")


def repeat_on_real_fields(program):
    folder = ROOT / "out/papers"
    folder.mkdir(parents=True, exist_ok=True)
    for tool in REAL:
        with open(folder / f"{tool}.md", "w", encoding="utf-8") as file:
            subprocess.run([sys.executable, ROOT / f"tools/{tool}.py", "--tramline", program.path], stdout=file, check=True)


def main():
    parser = argparse.ArgumentParser(prog="papers", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tramline", default=str(ROOT / "build/release/apps/tramline/tramline"))
    parser.add_argument("--out", type=Path, default=ROOT / "docs/papers")
    parser.add_argument("--tables", nargs="+", choices=TABLES, metavar="NAME", help=", ".join(TABLES))
    parser.add_argument("--real", action="store_true", help="also on the real fields of $TRAMLINE_DATA; takes long")
    options = parser.parse_args()
    program, out = Program(options.tramline), options.out.resolve()
    if options.tables:
        write_tables(program, out, options.tables)
        return
    write_inputs(ROOT / "examples/papers")
    pictures = [file for name in PAPERS for file in write_page(program, out, name)]
    with multiprocessing.Pool() as pool:
        pool.map(shrink, pictures)
    write_times(program, out / "times.md")
    if options.real:
        repeat_on_real_fields(program)


if __name__ == "__main__":
    main()
