"""Tables as CSV and Markdown."""

import csv
import io
from dataclasses import dataclass


@dataclass
class Table:
    """What a paper prints beside what tramline finds: `columns` are names, `rows` texts, `why` says what differs."""
    name: str
    title: str
    columns: list
    rows: list
    why: str

    def csv(self):
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(distinct(self.columns))
        writer.writerows(self.rows)
        return text.getvalue()

    def markdown(self):
        return "\n".join([f"### {self.title}", "", f"[{self.name}.csv](tables/{self.name}.csv)", "",
                          *grid(self.columns, self.rows), "", self.why, ""])


def distinct(columns):
    """"printed" and the like say what they stand beside, as no two columns of a CSV may have one name."""
    out = []
    for i, name in enumerate(columns):
        out.append(f"{out[-1]}, {name}" if columns.count(name) > 1 and i else name)
    return out


def grid(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


@dataclass
class Figure:
    """A picture, drawn by `draw(file)`."""
    name: str
    caption: str
    draw: object

    def markdown(self):
        return f"![{self.caption}](pictures/{self.name}.png)\n\n{self.caption}\n"


def beside(ours, printed, form="{:.2f}"):
    """Two columns: ours, then what the paper prints (a text, as printed)."""
    return [form.format(ours), printed]


def page(title, introduction, tables, figures, ending):
    parts = [f"# {title}", "", introduction.strip(), "", "## Tables", "", *(table.markdown() for table in tables),
             "## Figures", "", *(figure.markdown() for figure in figures), ending.strip(), ""]
    return "\n".join(parts)
