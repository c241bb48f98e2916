# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Looks for what CGAL's own checks of a branch would send back.

    cgal_rules.py REPOSITORY

Headers have a guard that is named after their path, and then the package's licence header; what they define begins with
CGAL_, and whether CGAL uses a library is asked after one of its headers alone. min and max stand in parentheses, as they
are macros of Windows; other macros of Windows and Qt are no names in headers. Only scripts can be executed. Texts are UTF-8
without tabs, spaces at the ends of lines, or carriage returns. The folders of programs have the projects that CGAL's
testsuite looks for, and package_info all files of a package.
"""

import os
import pathlib
import re
import sys

PACKAGE = "Dynamic_Delaunay_triangulation_2"
FOLDERS = ["benchmark", "bindings", "cmake", "doc", "examples", "include", "package_info", "packaging",
           "scenario_runner", "test"]
TOP_FILES = ["CHANGELOG.md", "CMakeLists.txt", "MANIFEST.in", "README.md", "dev", "pyproject.toml", "setup.py"]
LICENCE = f"CGAL/license/{PACKAGE}.h"
LICENCE_TEXT = "GPL (v3 or later)"
PACKAGE_INFO = ["copyright", "dependencies", "description.txt", "license.txt", "long_description.txt", "maintainer"]
PROJECTS = {"test": "Tests", "examples": "Examples"}
CODE = {".h", ".cpp"}
DRAWN = {".png", ".svg"}
AS_FOUND = ("fuzz/corpus", "/dialects/")  # input as other programs write it, or libFuzzer
COMMENT_OR_TEXT = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", re.S)
MACRO_OF_OTHERS = re.compile(r"\b(?:emit|far|foreach|forever|hyper|interface|near|signals|slots|small)\b")


def files_of(root):
    yield from (root / name for name in TOP_FILES if (root / name).is_file())
    for folder in FOLDERS:
        yield from (path for path in sorted((root / folder).rglob("*")) if path.is_file())


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def in_code(text, pattern):
    for number, line in enumerate(COMMENT_OR_TEXT.sub(blank, text).split("\n"), 1):
        if re.search(pattern, line):
            yield number


def broken_in_text(path, text):
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        if "\t" in line or "\r" in line:
            yield f"{path}:{number}: a tab or a carriage return"
        if line.endswith(" "):
            yield f"{path}:{number}: spaces at the end of the line"
    if lines[-1]:
        yield f"{path}: the last line does not end"


def broken_in_code(path, text):
    for number in in_code(text, r"\b(?:min|max)\s*\("):
        yield f"{path}:{number}: min or max without parentheses, as in (std::min)(x, y)"


def broken_in_header(path, text):
    name = path.as_posix().removeprefix("include/")
    guard = re.sub(r"\W", "_", name).upper()
    begin = re.search(rf"^#ifndef {guard}\n#define {guard}\n\n", text, re.M)
    if not begin:
        yield f"{path}: no guard {guard}"
    elif name != LICENCE and not text.startswith(f"#include <{LICENCE}>\n", begin.end()):
        yield f"{path}: the guard is not followed by {LICENCE}"
    for macro in re.findall(r"^\s*#\s*define\s+(\w+)", text, re.M):
        if not macro.startswith("CGAL_"):
            yield f"{path}: the macro {macro} does not begin with CGAL_"
    for number in in_code(text, MACRO_OF_OTHERS):
        yield f"{path}:{number}: a name that is a macro of Windows or Qt"
    if "CGAL_USE_" in text.partition("#include <CGAL/")[0]:
        yield f"{path}: a CGAL_USE_ macro before CGAL's headers"


def broken_in_file(root, path):
    name = path.relative_to(root)
    if path.suffix in DRAWN:
        return
    data = path.read_bytes()
    if os.access(path, os.X_OK) and not data.startswith(b"#!"):
        yield f"{name}: can be executed, and is no script"
    if any(folder in name.as_posix() for folder in AS_FOUND):
        return
    try:
        text = data.decode()
    except UnicodeDecodeError:
        yield f"{name}: is not UTF-8"
        return
    yield from broken_in_text(name, text)
    if path.suffix in CODE and name.parts[0] != "doc":
        yield from broken_in_code(name, text)
    if name.parts[0] == "include":
        yield from broken_in_header(name, text)


def broken_in_package(root):
    for folder, suffix in PROJECTS.items():
        path = pathlib.Path(folder, PACKAGE, "CMakeLists.txt")
        if f"project({PACKAGE}_{suffix})" not in (root / path).read_text():
            yield f"{path}: no project({PACKAGE}_{suffix})"
    info = root / "package_info" / PACKAGE
    texts = {name: (info / name).read_text() if (info / name).is_file() else "" for name in PACKAGE_INFO}
    for name in PACKAGE_INFO:
        if not texts[name].strip():
            yield f"package_info: {name} is missing or empty"
    if texts["license.txt"].strip() != LICENCE_TEXT:
        yield f"package_info: license.txt does not say {LICENCE_TEXT}"
    dependencies = texts["dependencies"].split()
    if dependencies != sorted(set(dependencies)) or PACKAGE not in dependencies:
        yield "package_info: dependencies are not sorted, or without the package itself"


def main():
    root = pathlib.Path(sys.argv[1])
    broken = [rule for path in files_of(root) for rule in broken_in_file(root, path)]
    broken += broken_in_package(root)
    for rule in broken:
        print(rule)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
