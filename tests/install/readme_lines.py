"""Runs the Python of a page of Markdown, block by block. Usage: readme_lines.py PAGE"""

import pathlib
import re
import sys

found = re.findall(r"```python\n(.*?)```", pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"), re.DOTALL)
if not found:
    sys.exit(f"{sys.argv[1]} shows no Python")
for code in found:
    exec(compile(code, sys.argv[1], "exec"), {"__name__": "__main__"})
