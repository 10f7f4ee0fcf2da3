#!/usr/bin/env python3
"""Every option that takes a value says its default in --help, options are grouped, and lines fit a terminal.

The program is given in TRAMLINE.
"""

import os
import re
import subprocess
import unittest

PROGRAM = os.environ.get("TRAMLINE", "tramline")
COLUMNS = 108  # footers are wrapped by hand, a little wider than the options


def help_of(*command):
    done = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout


def commands():
    listed = help_of().split("\nCommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\S+) ", listed, re.MULTILINE)


def entries(text):
    """(heading, name, value, description) of each option."""
    out = []
    heading = None
    for line in text.splitlines():
        if re.match(r"^\S.*:$", line):
            heading = line[:-1]
            continue
        option = re.match(r"^  (?:-\w, )?(--[\w-]+)(?: (\S+))?(?:  +(.*))?$", line)
        if option and heading != "Examples":
            out.append([heading, option[1], option[2], option[3] or ""])
        elif re.match(r"^ {20,}\S", line) and out:
            out[-1][3] += " " + line.strip()
    return out


class Help(unittest.TestCase):
    def test_every_value_has_a_default_or_is_required(self):
        seen = 0
        for command in commands():
            for _, name, value, description in entries(help_of(command)):
                if value is None or value.startswith("["):
                    continue
                seen += 1
                with self.subTest(command=command, option=name):
                    self.assertRegex(description, r"Default: .+\.$|Required\.$")
        self.assertGreater(seen, 150)

    def test_options_are_grouped(self):
        for command in commands():
            groups = {}
            for heading, name, _, _ in entries(help_of(command)):
                groups.setdefault(heading, []).append(name)
            with self.subTest(command=command):
                self.assertNotIn("Other options", groups)
                self.assertLessEqual(max(map(len, groups.values())), 12)

    def test_descriptions_are_sentences(self):
        for command in commands():
            for _, name, _, description in entries(help_of(command)):
                with self.subTest(command=command, option=name):
                    self.assertRegex(description, r"^[A-Z'a-z].*\.$")

    def test_lines_fit_a_terminal(self):
        for command in [[]] + [[name] for name in commands()]:
            for line in help_of(*command).splitlines():
                with self.subTest(command=command, line=line):
                    self.assertLessEqual(len(line), COLUMNS)


if __name__ == "__main__":
    unittest.main()
