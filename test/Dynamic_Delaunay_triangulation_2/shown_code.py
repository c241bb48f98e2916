# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether all C++ code that documentation shows is that of examples, which the tests compile and run.

    shown_code.py ROOT

Each C++ block of a Markdown file has to be there in an example, line for line, whatever its indentation. Pages and
headers have no code of their own: they include that of examples.
"""

import pathlib
import re
import sys
import textwrap

EXAMPLES = "examples/Dynamic_Delaunay_triangulation_2"
MARK = re.compile(r"\s*//! \[.*\]$")  # of a part that pages show


def lines_of(text):
    return [line.rstrip() for line in textwrap.dedent(text).strip("\n").split("\n")]


def occurs_in(block, example):
    wanted = lines_of(block)
    lines = [line for line in example.split("\n") if not MARK.match(line)]
    windows = range(len(lines) - len(wanted) + 1)
    return any(lines_of("\n".join(lines[i : i + len(wanted)])) == wanted for i in windows)


def examples(root):
    paths = sorted([*(root / EXAMPLES).glob("*.cpp"), *(root / EXAMPLES / "ranks").glob("*.cpp")])
    return {path.name: path.read_text() for path in paths}


def findings(root):
    programs = examples(root)
    for path in [root / "README.md", *sorted((root / "doc").rglob("*.md"))]:
        text = path.read_text()
        for match in re.finditer(r"^```(?:cpp|c\+\+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
            if not any(occurs_in(match[1], program) for program in programs.values()):
                yield path, text[: match.start()].count("\n") + 1, "this code is in no example"
    pages = [*(root / "doc").rglob("*.txt"), *(root / "doc").rglob("*.h"), *(root / "include").rglob("*.h")]
    for path in sorted(pages):
        for number, line in enumerate(path.read_text().split("\n"), 1):
            if re.search(r"[\\@]code\b|```|~~~", line):
                yield path, number, "code that no test compiles"
            for name in re.findall(r"\\(?:snippet|include|cgalExample)\{?\s*\S*/(\w+\.cpp)", line):
                if name not in programs:
                    yield path, number, f"{name} is no example that the tests run"


def main():
    found = list(findings(pathlib.Path(sys.argv[1])))
    for path, number, message in found:
        print(f"{path}:{number}: {message}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
