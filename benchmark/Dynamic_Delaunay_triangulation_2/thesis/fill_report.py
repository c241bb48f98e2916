#!/usr/bin/python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fills the tables of a report from results: fill_report.py REPORT DIRECTORY [--check]

What stands between `<!-- table: NAME -->` and `<!-- end -->` is made anew from the CSV files in
DIRECTORY/thesis and DIRECTORY/peers.
With --check nothing is written, and a table that would change is an error.
"""

import argparse
import re
import sys
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "figures"))
from judgement import verdict  # noqa: E402
from names import EXACT, METHODS, SCENARIOS  # noqa: E402
from results_file import Results, numbers  # noqa: E402

HEXAGONAL = {name + "_hexagonal": label for name, label in SCENARIOS.items()}


def short(value):
    """Three digits, as many as a timing has; large numbers without a power of ten."""
    number = float(value)
    if number >= 1000:
        return f"{number:,.0f}"
    return f"{number:.0f}" if number >= 100 else f"{number:.3g}"


def validity(row):
    return f"{floor(row['validity'])} ({floor(row['validity_min'])})"


def floor(text):
    """Three decimals, cut off: what is not quite 1 does not look like 1."""
    return f"{int(float(text) * 1000 + 1e-9) / 1000:.3f}"


def speedup(row):
    """The median of single frames, and of all frames' times together."""
    return f"{short(row['over_fastest'])} ({short(of_all_frames(row))})"


def of_all_frames(row):
    return float(row["fastest"]) / float(row["dynamic_mean"])


def parameter_of(method):
    return method.rpartition(":")[2]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


class Tables:
    """Each method is a table, named as in the report with a `_` for each `-`."""

    def __init__(self, directory):
        self.directory = directory

    def read(self, name):
        return Results(self.directory / "thesis" / f"{name}.csv")

    def by_method(self, scenarios, cell):
        summary = self.read("over_time_summary")
        return table(["classifier"] + list(scenarios.values()),
                     [[METHODS[method]] + [cell(summary.select(scenario=name, method=method)[0])
                                           for name in scenarios]
                      for method in summary.values("method")])

    def validity(self):
        return self.by_method(SCENARIOS, validity)

    def validity_hexagonal(self):
        return self.by_method(HEXAGONAL, validity)

    def speedup(self):
        return self.by_method(SCENARIOS, speedup)

    def speedup_hexagonal(self):
        return self.by_method(HEXAGONAL, speedup)

    def speedup_over_insert(self):
        return self.by_method(SCENARIOS, lambda row: short(row["over_insert"]))

    def verdicts(self):
        physics = self.read("over_time_physics")
        names = {**SCENARIOS, **{name: label + ", hexagonal" for name, label in HEXAGONAL.items()}}
        return table(["classifier"] + list(names.values()),
                     [[METHODS[method]] + [verdict(physics, name, method)[0] for name in names]
                      for method in physics.values("method") if method != EXACT])

    def by_parameter(self, scenario):
        summary = self.read("point_distance_summary")
        physics = self.read("point_distance_physics")
        rows = []
        for row in summary.select(scenario=scenario):
            method = row["method"]
            judged, share = verdict(physics, scenario, method)
            rows.append([METHODS[EXACT] if method == EXACT else parameter_of(method), validity(row),
                         speedup(row), short(row["classified"]),
                         "" if method == EXACT else judged,
                         "" if method == EXACT else f"{100 * share:.0f} %"])
        return table(["x", "validity", "speedup", "classified", "simulation", "outside"], rows)

    def point_distance(self):
        return self.by_parameter("dam_break")

    def point_distance_hexagonal(self):
        return self.by_parameter("dam_break_hexagonal")

    def random(self):
        return table(["p", "validity", "speedup", "classified", "rebuilt"],
                     [[parameter_of(row["method"]), validity(row), speedup(row),
                       short(row["classified"]), f"{100 * float(row['rebuilt']):.3g} %"]
                      for row in self.read("random_summary").rows])

    def most_points(self):
        results = self.read("most_points")

        def cell(scenario, method):
            found = sorted(numbers(results.select(scenario=scenario, method=method), "points"))
            return f"{short(median(found))} ({short(found[0])} to {short(found[-1])})"

        return table(["classifier"] + list(SCENARIOS.values()),
                     [[METHODS[method]] + [cell(name, method) for name in SCENARIOS]
                      for method in results.values("method")])

    def time_step(self):
        results = self.read("time_step_summary")
        rows = []
        for row in results.select(method=EXACT):
            other = results.select(method="point_distance:0.7", scenario=row["scenario"],
                                   time_step=row["time_step"])[0]
            rows.append([SCENARIOS[row["scenario"]], row["time_step"], speedup(row), speedup(other),
                         validity(other)])
        return table(["scenario", "step", "exact", "point distance 0.7", "its validity"], rows)

    def classification(self):
        results = self.read("classification")

        def cell(row):
            if row["precision"] == "":
                return f"{floor(row['recall'])}, no vertex"
            return f"{floor(row['recall'])}, {floor(row['FDR'])}"

        return table(["classifier"] + list(SCENARIOS.values()),
                     [[METHODS[method]] + [cell(results.select(scenario=name, method=method)[0])
                                           for name in SCENARIOS]
                      for method in results.values("method")])

    def points(self):
        results = self.read("points_summary")
        rows = []
        for row in results.select(method=EXACT):
            other = results.select(method="point_distance:0.7", scenario=row["scenario"],
                                   points=row["points"], time_step=row["time_step"])[0]
            name = SCENARIOS.get(row["scenario"], f"Brownian, {row['time_step']}")
            rows.append([name, short(row["points"]), short(row["dynamic"]), short(other["dynamic"]),
                         short(row["insert"]), short(row["fastest"]), short(row["over_insert"]),
                         short(row["over_fastest"])])
        return table(["motion", "points", "exact", "point distance 0.7", "insertion", "fastest",
                      "exact over insertion", "over fastest"], rows)

    def motion(self):
        results = self.read("motion_summary")
        rows = []
        for row in results.select(method=EXACT):
            other, hybrid = (results.select(method=method, time_step=row["time_step"])[0]
                             for method in ("point_distance:0.7", "circumcircle/hybrid"))
            rows.append([row["time_step"], short(row["dynamic"]), short(hybrid["dynamic"]),
                         short(other["dynamic"]), validity(other), short(row["insert"]),
                         short(row["fastest"]), short(row["over_fastest"])])
        return table(["step, spacings", "exact", "exact, hybrid policy", "point distance 0.7",
                      "its validity", "insertion", "fastest", "exact over fastest"], rows)

    def peers(self):
        results = Results(self.directory / "peers" / "peers.csv")
        ours = results.values("peer")[0]
        others = results.values("peer")[1:]

        def cell(row):
            text = short(row["times_ours"])
            return f"**{text}**" if row["result"] == "loss" else text

        rows = []
        for points in results.values("points"):
            for motion in results.values("motion"):
                own = results.select(motion=motion, points=points, peer=ours)
                if own:
                    cells = [results.select(motion=motion, points=points, peer=peer)
                             for peer in others]
                    rows.append([motion.replace("_", " "), short(points),
                                 short(own[0]["ns_per_point"])] +
                                [cell(found[0]) if found else "" for found in cells])
        return table(["motion", "points", "exact, ns a point"] + others, rows)


def filled(text, tables):
    def fill(match):
        made = getattr(tables, match.group(1).replace("-", "_"))()
        return f"<!-- table: {match.group(1)} -->\n\n{made}\n\n<!-- end -->"

    return re.sub(r"<!-- table: ([a-z-]+) -->.*?<!-- end -->", fill, text, flags=re.DOTALL)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=Path)
    parser.add_argument("directory", type=Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    text = arguments.report.read_text(encoding="utf-8")
    new_text = filled(text, Tables(arguments.directory))
    if not arguments.check:
        arguments.report.write_text(new_text, encoding="utf-8")
    elif new_text != text:
        sys.exit(f"{arguments.report}: its tables are not those of {arguments.directory}; "
                 "fill_report.py without --check fills them")


if __name__ == "__main__":
    main()
