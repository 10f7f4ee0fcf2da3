"""Reads and writes case files: plain text in sections, each with its name on a header line.

  # Lines before the first header are for whoever reads the case: blank, or a comment.
  === command
  plan $COMMON/one-field.geojson --width 6
  === exit
  0

Everything after a header, up to the next one, is the content of its section, line by line as it stands. Two
rules let any content pass. A line of it that begins with ===, or with backslashes and then ===, is written
with one backslash more in front. And content that does not end with a line feed is followed by the line

  === without a line feed

Which sections there are, run_golden.py says; here is the order in which they are written: what a person
decides and what is short come first.
"""

import re

SECTIONS = ("command", "setup.sh", "exit", "files", "expect", "stderr", "expect-stdout", "exact", "stdout")
HEADER = "=== "
UNENDED = "=== without a line feed"


class BadCase(Exception):
    """The case itself is at fault, not the program."""


def written_content(content):
    """The lines that hold the content in a case file."""
    escaped = re.sub(r"^(\\*===)", r"\\\1", content, flags=re.MULTILINE)
    return escaped if escaped.endswith("\n") or not escaped else f"{escaped}\n{UNENDED}\n"


def read_content(text):
    """The content that these lines of a case file hold."""
    if text.endswith(f"\n{UNENDED}\n"):
        text = text[:-len(f"\n{UNENDED}\n")]
    if re.search("^===", text, flags=re.MULTILINE):
        raise BadCase(f"'{UNENDED}' has to follow a line, and to end its section")
    return re.sub(r"^\\(\\*===)", r"\1", text, flags=re.MULTILINE)


class CaseFile:
    """One case: a comment, and the contents of its sections by name."""

    def __init__(self, comment, sections):
        self.comment = comment
        self.sections = sections

    @classmethod
    def parsed(cls, text):
        if text and not text.endswith("\n"):
            raise BadCase("the file does not end with a line feed")
        # What stands before the first header, then header and content by turns.
        comment, *found = re.split(rf"^(?!{UNENDED}$)(===.*)\n", text, flags=re.MULTILINE)
        for line in comment.splitlines():
            if line.strip() and not line.startswith("#"):
                raise BadCase(f"before the first section only comments may stand, not: {line}")
        sections = {}
        for header, content in zip(found[::2], found[1::2]):
            name = header[len(HEADER):]
            if not header.startswith(HEADER) or name not in SECTIONS:
                raise BadCase(f"there is no section '{header}'; known are {', '.join(SECTIONS)}")
            if name in sections:
                raise BadCase(f"'{header}' stands there twice")
            sections[name] = read_content(content)
        if sections.get("exact"):
            raise BadCase("'=== exact' says all by itself; nothing may stand in it")
        if "command" not in sections:
            raise BadCase("there is no section '=== command'")
        return cls(comment, sections)

    @classmethod
    def read(cls, path):
        # As bytes: reading as text would make line feeds of carriage returns.
        return cls.parsed(path.read_bytes().decode("utf-8"))

    def written(self):
        """The text of the case file; parsed() gives the same case back."""
        parts = [self.comment]
        for name in SECTIONS:
            if name in self.sections:
                parts.append(f"{HEADER}{name}\n{written_content(self.sections[name])}")
        return "".join(parts)

    def write(self, path):
        path.write_bytes(self.written().encode("utf-8"))

    def lines(self, name):
        """What a section lists: its lines without blank ones and comments."""
        content = self.sections.get(name, "")
        return [line for line in content.split("\n") if line.strip() and not line.startswith("#")]

    def exit_code(self):
        """The exit code the case asks for, None if it leaves that open."""
        if "exit" not in self.sections:
            return None
        try:
            return int(self.sections["exit"])
        except ValueError:
            raise BadCase(f"=== exit: not a number: {self.sections['exit'].strip()}") from None
