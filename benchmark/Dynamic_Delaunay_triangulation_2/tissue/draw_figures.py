#!/usr/bin/python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws tissue.csv and motion.csv: where the cells of a tissue begin to flow."""

import pathlib
import sys
from statistics import fmean

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "figures"))
import figure_style as style  # noqa: E402
from results_file import Results, numbers  # noqa: E402

FLUID = 1e-3
EXPECTED = 3.81
LEAST = 1e-5  # what is drawn at the bottom
CAPTION = (
    "The self-propelled Voronoi model of Bi, Yang, Marchetti and Manning (2016). Above: mean "
    "squared displacement over time for each p0, without the drift of all cells, means over the "
    "seeds. Middle: the diffusivity of cells over that of a cell that crawls alone, a dot for each "
    "seed, a line through the means; values below the axis are drawn at its bottom. What is above "
    "the horizontal line counts as a fluid here; the vertical one is p0 = 3.81, where the source "
    "has the transition of slow cells. Below: the rate of T1 events, new neighbors per cell and "
    "unit of time.")


def draw_motion(axes, results):
    shapes = results.values("p0")
    for place, shape in enumerate(shapes):
        times = list(dict.fromkeys(row["time"] for row in results.select(p0=shape)))
        heights = [fmean(numbers(results.select(p0=shape, time=time), "mean_square"))
                   for time in times]
        axes.plot([float(time) for time in times], heights, color=shade(place, len(shapes)),
                  label=shape)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time")
    axes.set_ylabel("mean squared displacement")
    axes.legend(ncols=4, frameon=False, loc="lower center", bbox_to_anchor=(0.45, 1))


def shade(place, number):
    """From dark to light, but not so light that it is not seen."""
    return style.plt.get_cmap("viridis")(0.92 * place / max(1, number - 1))


def draw_runs(axes, results, column, least):
    shapes = results.values("p0")
    rows = results.rows
    heights = [max(value, least) for value in numbers(rows, column)]
    axes.plot(numbers(rows, "p0"), heights, "o", color=style.COLORS[2], markersize=3, alpha=0.6)
    means = [max(fmean(numbers(results.select(p0=shape), column)), least) for shape in shapes]
    axes.plot([float(shape) for shape in shapes], means, color=style.COLORS[2])
    axes.axvline(EXPECTED, color="gray", linestyle="--", linewidth=0.8)
    axes.set_yscale("log")
    axes.set_xlabel("preferred perimeter p0")


def main():
    folder = pathlib.Path(sys.argv[1])
    runs = Results(folder / "tissue.csv")
    figure, panels = style.new_figure(3)
    draw_motion(panels[0], Results(folder / "motion.csv"))
    draw_runs(panels[1], runs, "effective_diffusivity", LEAST)
    panels[1].axhline(FLUID, color="gray", linestyle="--", linewidth=0.8)
    panels[1].set_ylabel("effective diffusivity")
    draw_runs(panels[2], runs, "exchange_rate", LEAST)
    panels[2].set_ylabel("T1 rate")
    style.save(figure, folder / "tissue", CAPTION, runs.remark("command"))
    print(f"Figure: {folder / 'tissue.svg'}", file=sys.stderr)


if __name__ == "__main__":
    main()
