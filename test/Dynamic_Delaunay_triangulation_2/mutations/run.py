#!/usr/bin/env python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the guards of guards.toml, one after the other, and says which test notices.

A guard that no test misses is not tested, or not needed. Each broken header is put in front of the right one; a test
that fails, crashes or does not end has noticed. An edit that does not compile is a mistake in guards.toml. Compilers
take most of the time. Clang, which is taken where it is there, compiles the headers of others once: test_checkpoint
then takes 19 seconds, 29 without that, and 52 with g++.
"""

import argparse
import atexit
import functools
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PACKAGE = "Dynamic_Delaunay_triangulation_2"
INTERNAL = ROOT / "include" / "CGAL" / PACKAGE / "internal"
OPTIONS = ("-std=c++17 -O0 -frounding-math -D_GLIBCXX_ASSERTIONS -DNOMINMAX -DCGAL_USE_GMPXX=1 "
           "-DCGAL_LINKED_WITH_TBB").split()
COMPILER = os.environ.get("CXX") or ("clang++" if shutil.which("clang++") else "g++")
FOREIGN_HEADERS = ("gtest/gtest.h CGAL/Exact_predicates_inexact_constructions_kernel.h "
                   "CGAL/Exact_predicates_exact_constructions_kernel.h CGAL/Delaunay_triangulation_2.h "
                   "CGAL/Triangulation_vertex_base_with_info_2.h tbb/parallel_for.h random map set regex fstream sstream")
RUNNER_SOURCES = ["Csv_writer", "Method_choice", "Number_text", "Output_file", "Progress", "Table", "Text_input"]
MUTATIONS_OF_CORPUS = 300
PATIENCE = 600  # seconds that a test may run


def header_of(guard):
    return (INTERNAL / guard["file"]).resolve()


def place_of(guard, text):
    """A match of what the guard edits, however lines are broken there; None unless there is one alone."""
    old = guard["old"]
    words = r"\s+".join(re.escape(word) for word in old.split())
    pattern = re.escape(old[: len(old) - len(old.lstrip())]) + words
    found = list(re.finditer(pattern, text))
    return found[0] if len(found) == 1 else None


def mutated(guard):
    """The text of the broken header."""
    text = header_of(guard).read_text()
    place = place_of(guard, text)
    if place is None:
        sys.exit(f'{guard["name"]}: what it edits has to be in {guard["file"]} once, and is not')
    return text[: place.start()] + guard["new"] + text[place.end() :]


def is_robustness(test):
    return test.partition(":")[0] == "robustness"


def source_of(test):
    """Of a program, or of some tests in it: `test_filters:Predicates*`, `robustness:--family jumps --trial 7`."""
    test = test.partition(":")[0]
    if is_robustness(test):
        return ROOT / "benchmark" / PACKAGE / "robustness.cpp"
    if test.startswith("fuzz_"):
        return ROOT / "test" / PACKAGE / "fuzz" / f"{test}.cpp"
    if test.startswith("distributed_"):
        return ROOT / "test" / PACKAGE / "mpi" / f"{test}.cpp"
    return ROOT / "test" / PACKAGE / f"{test}.cpp"


def written_for(test, program):
    """What to compile: for a theme of several ranks a program in which threads are the ranks."""
    if not test.startswith("distributed_"):
        return source_of(test)
    source = program.with_suffix(".cpp")
    source.write_text(f'#include "{source_of(test)}"\n'
                      "int main()\n{\n  threads_as_ranks::run_ranks(4, [] {\n    start(0, nullptr);\n"
                      "    themes().begin()->second();\n  });\n}\n")
    return source


def arguments_of(test):
    if test.startswith("distributed_"):
        return []
    if is_robustness(test):
        return test.partition(":")[2].split() or ["--operations", "20000", "--threads", "1"]
    if test.startswith("fuzz_"):
        return [str(MUTATIONS_OF_CORPUS), str(source_of(test).parent / "corpus" / test.removeprefix("fuzz_"))]
    return ["--gtest_fail_fast", f'--gtest_filter={test.partition(":")[2] or "*"}']


def command_of(test, overlay, program):
    folders = [overlay, ROOT / "include", ROOT, ROOT / "test" / PACKAGE, ROOT / "benchmark" / PACKAGE]
    libraries = ["-lgmpxx", "-lgmp", "-lmpfr", "-ltbb", "-lpthread", "-lz"]
    if is_robustness(test):
        options = ["-DNDEBUG", '-DRESULTS_DIR="."']
        libraries = runner_objects() + libraries
    elif test.startswith(("fuzz_", "distributed_")):
        folders.insert(0, ROOT / "test" / PACKAGE / "fuzz" / "threads_as_ranks")
        options = []
        libraries = runner_objects() + libraries
    else:
        options = []
        libraries = ["-lgtest_main", "-lgtest"] + libraries
    return ([COMPILER] + OPTIONS + options + [f"-I{folder}" for folder in folders] + foreign_headers(tuple(options))
            + [str(written_for(test, program)), "-o", str(program)] + libraries)


@functools.lru_cache
def foreign_headers(options):
    """What makes Clang take the headers of CGAL, GoogleTest and others as it has compiled them once."""
    if "clang" not in COMPILER:
        return []
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder)
    source, compiled = pathlib.Path(folder, "foreign.h"), f"{folder}/foreign.pch"
    source.write_text("".join(f"#include <{header}>\n" for header in FOREIGN_HEADERS.split()))
    subprocess.run([COMPILER] + OPTIONS + list(options) + ["-fpch-instantiate-templates", "-x", "c++-header", str(source),
                    "-o", compiled], check=True)
    return ["-include-pch", compiled]


@functools.lru_cache
def runner_objects():
    """What robustness links of the scenario runner, compiled once: what a guard breaks, robustness.cpp has first."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder)
    objects = []
    for source in RUNNER_SOURCES:
        objects.append(f"{folder}/{source}.o")
        subprocess.run([COMPILER] + OPTIONS + ["-DNDEBUG", f"-I{ROOT}", f'-I{ROOT / "include"}', "-c",
                        str(ROOT / "scenario_runner" / f"{source}.cpp"), "-o", objects[-1]], check=True)
    return objects


def first_failure(output):
    """The name of the first test that failed, if it is one of GoogleTest's."""
    for line in output.splitlines():
        if line.startswith("[  FAILED  ]"):
            return line.split("]", 1)[1].split(",")[0].split("(")[0].strip()
    return ""


def verdict(test, overlay, folder):
    """What the test says of the headers in `overlay` and the others; nothing if it passes."""
    program = folder / "program"
    compiled = subprocess.run(command_of(test, overlay, program), capture_output=True, text=True)
    if compiled.returncode != 0:
        return "does not compile: " + (compiled.stderr.strip().splitlines() or ["?"])[0]
    try:
        run = subprocess.run([str(program)] + arguments_of(test), capture_output=True, text=True, cwd=folder,
                             timeout=PATIENCE, errors="replace")
    except subprocess.TimeoutExpired:
        return "does not end"
    if "Running 0 tests" in run.stdout:
        sys.exit(f"{test} has no such test")
    if run.returncode == 0:
        return ""
    return first_failure(run.stdout) or (f"ends with signal {-run.returncode}" if run.returncode < 0 else "fails")


def attack(guard):
    """Which test has killed the mutant, and by what; two empty strings if it survived."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        overlay = folder / "include"
        broken = overlay / header_of(guard).relative_to(ROOT / "include")
        broken.parent.mkdir(parents=True)
        broken.write_text(mutated(guard))
        for test in guard["tests"]:
            noticed = verdict(test, overlay, folder)
            if noticed.startswith("does not compile"):
                sys.exit(f'{guard["name"]}, {test}: {noticed}')
            if noticed:
                return test, noticed
    return "", ""


def unbroken_failures(tests):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        return [f"{test}: {noticed}" for test in tests if (noticed := verdict(test, folder / "include", folder))]


def row(guard, test, noticed):
    return f'| {guard["name"]} | `{guard["file"]}` | ' + (f"`{test}`: {noticed} |" if test else "**survives** |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="TEXT", help="only guards with this in their names")
    parser.add_argument("--check", action="store_true", help="only whether every edit fits")
    parser.add_argument("--unbroken", action="store_true", help="first see that all tests pass as they are")
    parser.add_argument("--jobs", type=int, default=1, help="how many at once")
    options = parser.parse_args()
    guards = tomllib.loads((HERE / "guards.toml").read_text())["guard"]
    guards = [g for g in guards if not options.names or any(text in g["name"] for text in options.names)]
    if not guards:
        sys.exit("no guard has such a name")
    for guard in guards:
        mutated(guard)
        for test in guard["tests"]:
            if not source_of(test).exists():
                sys.exit(f'{guard["name"]}: there is no {test}')
    if options.check:
        print(f"{len(guards)} edits fit")
        return
    programs = {t if is_robustness(t) else t.partition(":")[0] for guard in guards for t in guard["tests"]}
    if options.unbroken and (failures := unbroken_failures(sorted(programs))):
        sys.exit("without a mutation: " + "; ".join(failures))
    survivors = 0
    print("| guard | header | killed by |\n|---|---|---|", flush=True)
    with ThreadPoolExecutor(options.jobs) as pool:
        for guard, (test, noticed) in zip(guards, pool.map(attack, guards)):
            survivors += not test
            print(row(guard, test, noticed), flush=True)
    print(f"\n{len(guards)} guards, {survivors} without a test\n"
          + shlex.join(["test/" + PACKAGE + "/mutations/run.py"] + sys.argv[1:]))
    sys.exit(survivors > 0)


if __name__ == "__main__":
    main()
