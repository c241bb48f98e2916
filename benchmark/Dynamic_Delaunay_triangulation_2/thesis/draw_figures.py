#!/usr/bin/python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the results of `./dev bench thesis`: draw_figures.py DIRECTORY [--to DIRECTORY]

Each figure of the thesis has its counterpart, named by its number; what the thesis lacks has a
name. Results that are not there, since only some experiments were run, leave their figures out.
"""

import argparse
import sys
from pathlib import Path
from statistics import median

from matplotlib.colors import LogNorm, Normalize

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "figures"))
from figure_style import COLORS, new_figure, plain_logarithmic, save  # noqa: E402
from names import EXACT, METHODS, SCENARIOS  # noqa: E402
from results_file import Results, numbers  # noqa: E402

SCENARIO_COLORS = dict(zip(SCENARIOS, COLORS[1:]))
OVER_TIME_FIGURES = {
    "fig_5_5_point_distance": ["point_distance:0.7"],
    "fig_5_7_random": ["random:0.0025", "random:0.1"],
    "fig_5_10_circumcircle": ["circumcircle/splice"],
    "over_time_exact": ["circumcircle"],
    "over_time_safe_region": ["safe_region"],
    "over_time_inflation_aware": ["inflation_aware:0.7"],
    "over_time_voronoi_circumcenter": ["voronoi_circumcenter"],
    "over_time_voronoi_circumcenter_estimated": ["voronoi_circumcenter_estimated"],
    "over_time_voronoi_edge_length": ["voronoi_edge_length:1"],
    "over_time_nearly_delaunay": ["nearly_delaunay:0.05"],
    "over_time_refined": ["refined:point_distance:0.9+voronoi_circumcenter"],
}


def fill(axes, x, rows, low, high, color, **options):
    """A band from one column to another."""
    axes.fill_between(x, numbers(rows, low), numbers(rows, high), color=color, linewidth=0,
                      **options)


def band(axes, x, rows, name, color, **options):
    """A line with its quartiles."""
    axes.plot(x, numbers(rows, name), color=color, **options)
    fill(axes, x, rows, name + "_q1", name + "_q3", color, alpha=0.2)


def mean_and_extremes(axes, x, rows, name, color, opacity=0.2, **options):
    """A line with a band from the smallest to the largest."""
    axes.plot(x, numbers(rows, name), color=color, **options)
    fill(axes, x, rows, name + "_min", name + "_max", color, alpha=opacity)


def parameter_of(method):
    return float(method.rpartition(":")[2])


def trials_of(summary):
    return max(int(row["trials"]) for row in summary.rows)


def packing_of(scenario):
    """What people call it, and the end of the names of its figures."""
    return ("hexagonal", "_hexagonal") if scenario.endswith("hexagonal") else ("square", "")


class Drawing:
    """The figures of one directory of results."""

    def __init__(self, source, target):
        self.source = source
        self.target = target

    def has(self, name):
        return (self.source / f"{name}.csv").exists()

    def read(self, name):
        return Results(self.source / f"{name}.csv")

    def save(self, figure, name, caption, results):
        save(figure, self.target / name, caption, results.remark("command"))

    # Figures 5.5, 5.7 and 5.10, and the same for all other classifiers.
    def over_time(self):
        results = self.read("over_time")
        trials = trials_of(self.read("over_time_summary"))
        for name, methods in OVER_TIME_FIGURES.items():
            figure, panels = new_figure(5, panel_height=1.75)
            self.draw_validity_over_time(panels[0], results, methods)
            for axes, scenario in zip(panels[1:], SCENARIOS):
                self.draw_speedup_over_time(axes, results, scenario, methods)
            panels[-1].set_xlabel("frame")
            beside = "" if methods == [EXACT] else " The exact default, whose validity is 1, in black."
            labels = " and ".join(METHODS[method] for method in methods)
            self.save(figure, name,
                      f"Classifier: {labels}. Validity (mean of {trials} trials, band: smallest to "
                      "largest) and speedup over the fastest static triangulation (median of all "
                      f"trials, band: quartiles) over time, square packing.{beside}", results)

    @staticmethod
    def draw_validity_over_time(axes, results, methods):
        for scenario, color in SCENARIO_COLORS.items():
            for method, dashes in zip(methods, ["-", ":"]):
                rows = results.select(scenario=scenario, method=method)
                last = float(rows[-1]["frame"])
                x = [frame / last for frame in numbers(rows, "frame")]
                label = SCENARIOS[scenario] if dashes == "-" else None
                mean_and_extremes(axes, x, rows, "validity", color, opacity=0.15,
                                  linestyle=dashes, label=label)
        if len(methods) > 1:
            axes.set_title(" (lines), ".join(METHODS[method] for method in methods) + " (dots)")
        else:
            axes.set_title(METHODS[methods[0]])
        axes.set_ylabel("validity")
        axes.set_ylim(min(0.9, axes.get_ylim()[0]), 1.01)
        axes.set_xlabel("share of the scenario's frames")
        axes.legend(ncol=2, loc="lower right")

    @staticmethod
    def draw_speedup_over_time(axes, results, scenario, methods):
        for method, color in zip([EXACT] + [one for one in methods if one != EXACT],
                                  [COLORS[0], COLORS[1], COLORS[2]]):
            rows = results.select(scenario=scenario, method=method)
            band(axes, numbers(rows, "frame"), rows, "over_fastest", color, label=METHODS[method])
        axes.axhline(1, color=COLORS[7], linewidth=0.8)
        plain_logarithmic(axes.yaxis)
        axes.set_title(SCENARIOS[scenario])
        axes.set_ylabel("speedup")
        axes.legend(loc="best", fontsize=7)

    # Figures 5.6, 5.8 and 5.9: surfaces over parameter and frame.
    def surface(self, name, experiment, what, scenario, methods, symbol):
        results, summary = self.read(experiment), self.read(experiment + "_summary")
        figure, panels = new_figure(3, panel_height=2.6)
        parameters = [parameter_of(method) for method in methods]
        frames = numbers(results.select(scenario=scenario, method=methods[0]), "frame")
        for axes, column, title in [(panels[0], "over_fastest", "speedup over the fastest static"),
                                    (panels[1], "validity", "validity")]:
            values = [numbers(results.select(scenario=scenario, method=method), column)
                      for method in methods]
            axes.grid(False)
            norm = LogNorm(0.5, 50) if column == "over_fastest" else Normalize(0.8, 1)
            mesh = axes.pcolormesh(frames, parameters, values, shading="nearest", cmap="viridis",
                                   norm=norm, rasterized=True)
            bar = figure.colorbar(mesh, ax=axes, extend="both" if column == "over_fastest" else "min")
            if column == "over_fastest":
                plain_logarithmic(bar.ax.yaxis)
            axes.set_title(title)
            axes.set_ylabel(symbol)
            axes.set_xlabel("frame")
        self.draw_by_parameter(panels[2], summary, scenario, methods, parameters)
        panels[2].set_xlabel(symbol)
        trials = trials_of(summary)
        self.save(figure, name,
                  f"{what} Above: medians and means of {trials} trials. Below, over whole runs: "
                  "validity (mean, band: smallest to largest) and speedup over the fastest static "
                  "(median, band: quartiles; dotted: of the times of all frames together).", results)

    @staticmethod
    def draw_by_parameter(axes, summary, scenario, methods, parameters):
        rows = [summary.select(scenario=scenario, method=method)[0] for method in methods]
        mean_and_extremes(axes, parameters, rows, "validity", COLORS[2], label="validity")
        axes.set_ylabel("validity", color=COLORS[2])
        right = axes.twinx()
        band(right, parameters, rows, "over_fastest", COLORS[1])
        right.plot(parameters, [float(row["fastest"]) / float(row["dynamic_mean"]) for row in rows],
                   ":", color=COLORS[1])
        right.axhline(1, color=COLORS[7], linewidth=0.8)
        right.set_ylabel("speedup", color=COLORS[1])
        plain_logarithmic(right.yaxis)
        right.grid(False)

    def point_distance(self):
        results = self.read("point_distance")
        for scenario in results.values("scenario"):
            methods = [method for method in results.values("method") if method != EXACT]
            packing, suffix = packing_of(scenario)
            self.surface("fig_5_6_point_distance" + suffix, "point_distance",
                         f"Point distance classifier on the dam break, {packing} packing, by its "
                         "parameter x.", scenario, methods, "parameter x")

    def random(self):
        results = self.read("random")
        small = [method for method in results.values("method") if parameter_of(method) <= 0.005]
        large = [method for method in results.values("method")
                 if parameter_of(method) in (0, 0.005) or parameter_of(method) > 0.005]
        for name, methods, text in [("fig_5_8_random", large, ""),
                                    ("fig_5_9_random_small", small, ", up to 0.005")]:
            self.surface(name, "random",
                         f"Random classifier on the dam break, by its probability{text}.",
                         "dam_break", methods, "probability p")

    # Figure 5.11.
    def most_points(self):
        results = self.read("most_points")
        scenarios = results.values("scenario")
        methods = results.values("method")
        trials = max(int(row["trial"]) for row in results.rows)
        figure, panels = new_figure(len(scenarios), panel_height=2.9)
        for axes, scenario in zip(panels, scenarios):
            for place, method in enumerate(reversed(methods)):
                found = sorted(numbers(results.select(scenario=scenario, method=method), "points"))
                color = COLORS[2] if method.startswith("static") else \
                    COLORS[1] if method in (EXACT, "safe_region", "circumcircle/splice") else COLORS[7]
                axes.barh(place, median(found), color=color, alpha=0.8)
                axes.plot(found, [place] * len(found), "|", color=COLORS[0], markersize=6)
            axes.set_yticks(range(len(methods)), [METHODS[name] for name in reversed(methods)],
                            fontsize=7.5)
            axes.set_xscale("log")
            axes.set_xlim(left=1e4)
            axes.grid(False, axis="y")
            axes.set_title(SCENARIOS[scenario])
        panels[-1].set_xlabel("points")
        self.save(figure, "fig_5_11_most_points",
                  "The largest number of points with which three of four frames took up to 40 ms, "
                  f"found by search; bars: median of {trials} trials, ticks: each trial. Red: exact "
                  "classifiers, gray: heuristics, blue: static triangulation.", results)

    # Figure 6.1.
    def time_step(self):
        results = self.read("time_step_summary")
        figure, panels = new_figure(1 + len(results.values("scenario")), panel_height=2.0)
        for axes, scenario in zip(panels[1:], results.values("scenario")):
            for method, color in [(EXACT, COLORS[0]), ("point_distance:0.7", COLORS[1])]:
                rows = results.select(scenario=scenario, method=method)
                steps = numbers(rows, "time_step")
                band(axes, steps, rows, "over_fastest", color, label=METHODS[method], marker=".")
            plain_logarithmic(axes.xaxis)
            plain_logarithmic(axes.yaxis)
            axes.set_title(SCENARIOS[scenario])
            axes.set_ylabel("speedup")
            axes.legend(loc="best")
            mean_and_extremes(panels[0], steps, rows, "validity", SCENARIO_COLORS[scenario],
                              opacity=0.15, marker=".", label=SCENARIOS[scenario])
        panels[0].set_title("point distance 0.7")
        panels[0].set_ylabel("validity")
        plain_logarithmic(panels[0].xaxis)
        panels[0].legend(loc="best", ncol=2)
        panels[-1].set_xlabel("time step, sqrt(mass / stiffness)")
        self.save(figure, "fig_6_1_time_step",
                  "Time steps up to the largest stable one, the same simulated time each. Validity: "
                  f"mean of {trials_of(results)} trials, band: smallest to largest. Speedup over the "
                  "fastest static: median, band: quartiles.", results)

    # The simulation as judge (6.2.3).
    def judge(self):
        results = self.read("point_distance_physics")
        trials = trials_of(self.read("point_distance_summary"))
        units = {"kinetic": "kinetic energy", "energy": "energy", "center_x": "center, x",
                 "center_y": "center, y", "front": "front, x"}
        for scenario in results.values("scenario"):
            figure, panels = new_figure(len(units), panel_height=1.9)
            rows = results.select(scenario=scenario, method=EXACT)
            for axes, (column, label) in zip(panels, units.items()):
                fill(axes, numbers(rows, "frame"), rows, column + "_min", column + "_max",
                     COLORS[7], alpha=0.5, label="exact")
                for x, color in [(0.2, COLORS[1]), (0.4, COLORS[5]), (0.6, COLORS[3]),
                                  (0.8, COLORS[2])]:
                    one = results.select(scenario=scenario, method=f"point_distance:{x}")
                    axes.plot(numbers(one, "frame"), numbers(one, column), color=color,
                              label=f"x = {x}")
                axes.set_ylabel(label)
            plain_logarithmic(panels[0].yaxis)
            panels[0].legend(ncol=2, loc="best")
            packing, suffix = packing_of(scenario)
            panels[0].set_title(f"dam break, {packing} packing")
            panels[-1].set_xlabel("frame")
            self.save(figure, "judge" + suffix,
                      "Simulations driven by the point distance classifier (means of "
                      f"{trials} trials) and by the exact triangulation (gray: smallest to largest "
                      f"of {trials} trials). Energies and lengths in units of particle mass, "
                      "stiffness and diameter.", results)

    # Classification quality.
    def classification(self):
        results = self.read("classification")
        methods = results.values("method")
        figure, panels = new_figure(2, panel_height=3.1)
        for axes, column in zip(panels, ["recall", "precision"]):
            for (scenario, label), shift in zip(SCENARIOS.items(), [0.27, 0.09, -0.09, -0.27]):
                for place, method in enumerate(reversed(methods)):
                    row = results.select(scenario=scenario, method=method)[0]
                    if row[column] == "":
                        continue
                    axes.plot([float(row[column + "_min"]), float(row[column + "_max"])],
                              [place + shift] * 2, color=SCENARIO_COLORS[scenario], linewidth=1)
                    axes.plot(float(row[column]), place + shift, "o", markersize=3.5,
                              color=SCENARIO_COLORS[scenario],
                              label=label if place == 0 else None)
            axes.set_yticks(range(len(methods)), [METHODS[name] for name in reversed(methods)],
                            fontsize=7.5)
            axes.set_title(column)
            axes.set_xlim(-0.02, 1.02)
        panels[0].legend(loc="best", fontsize=7)
        row = results.rows[0]
        self.save(figure, "classification",
                  "Classified vertices against those that need mending by exact predicates: recall "
                  f"and precision over {row['frames']} frames; dots: mean of {row['trials']} trials, "
                  "lines: smallest to largest. No dot: no vertex was classified.", results)

    # What the thesis lacks: cost against the number of points and the motion.
    def points(self):
        results = self.read("points_summary")
        cases = [("brownian", "0.001", "Brownian, steps of 0.001 spacings"),
                 ("brownian", "0.01", "Brownian, 0.01"), ("dam_break", "0.3", "dam break, its start")]
        figure, panels = new_figure(len(cases))
        for axes, (scenario, step, title) in zip(panels, cases):
            self.draw_costs(axes, results, "points", scenario=scenario, time_step=step)
            axes.set_title(title)
        panels[-1].set_xlabel("points")
        self.save(figure, "cost_by_points",
                  f"Cost by the number of points: medians of {trials_of(results)} trials, bands: "
                  "quartiles.", results)

    def motion(self):
        results = self.read("motion_summary")
        figure, panels = new_figure(2, panel_height=3.0)
        self.draw_costs(panels[0], results, "time_step", scenario="brownian")
        panels[0].set_title("Brownian motion, 10,000 points")
        rows = results.select(method="point_distance:0.7")
        steps = numbers(rows, "time_step")
        mean_and_extremes(panels[1], steps, rows, "validity", COLORS[1], label="point distance 0.7")
        rows = results.select(method=EXACT)
        panels[1].plot(steps, numbers(rows, "validity"), color=COLORS[0], label=METHODS[EXACT])
        panels[1].set_xscale("log")
        panels[1].set_ylabel("validity")
        panels[1].legend(loc="best")
        panels[1].set_xlabel("step, spacings a frame (standard deviation along each axis)")
        self.save(figure, "cost_by_motion",
                  f"Cost and validity by the motion of a frame: medians of {trials_of(results)} "
                  "trials with bands of quartiles; validity: mean, smallest to largest.", results)

    @staticmethod
    def draw_costs(axes, results, x_column, **wanted):
        methods = [method for method in results.values("method")
                   if results.select(method=method, **wanted)]
        colors = [COLORS[0], COLORS[1], COLORS[5]]
        for method, color in zip(methods, colors):
            rows = results.select(method=method, **wanted)
            band(axes, numbers(rows, x_column), rows, "dynamic", color, label=METHODS[method],
                 marker=".")
        rows = results.select(method=EXACT, **wanted)
        for column, color, label in [("insert", COLORS[2], "CGAL's insertion"),
                                      ("fastest", COLORS[6], "fastest static")]:
            axes.plot(numbers(rows, x_column), numbers(rows, column), "--", color=color, label=label)
        axes.set_xscale("log")
        plain_logarithmic(axes.yaxis)
        axes.set_ylabel("ns a point")
        axes.legend(loc="best", fontsize=7)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path)
    parser.add_argument("--to", type=Path)
    arguments = parser.parse_args()
    drawing = Drawing(arguments.source, arguments.to or arguments.source)
    drawing.target.mkdir(parents=True, exist_ok=True)
    for results, draw in [("over_time", drawing.over_time),
                          ("point_distance", drawing.point_distance),
                          ("point_distance", drawing.judge), ("random", drawing.random),
                          ("time_step_summary", drawing.time_step),
                          ("classification", drawing.classification),
                          ("points_summary", drawing.points), ("motion_summary", drawing.motion),
                          ("most_points", drawing.most_points)]:
        if drawing.has(results):
            draw()


if __name__ == "__main__":
    main()
