#!/usr/bin/python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws scale.csv, bandwidth.csv and memory.csv: time, threads, bandwidth and memory by points."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "figures"))
import figure_style as style  # noqa: E402
from results_file import Results, numbers  # noqa: E402

CALM = ("drift", "calm")
LINES = ["-", "--", ":", "-."]  # by threads
MARKERS = ["o", "v", "s", "D", "^"]  # by motions
BYTES = [("cgal", "CGAL alone"), ("rough", "after frames"), ("build_peak", "peak of construction"),
         ("rebuild_peak", "peak of a rebuild")]
CAPTION = (
    "By the number of points, one color for each motion. First: median time of a frame, rebuild or "
    "construction, solid with the first number of threads, dashed with the second. Second: how many "
    "times faster the other numbers of threads are than the first; the horizontal line is no "
    "faster. Third: the part of a calm frame's time in which copying with as many threads would "
    "have moved what the frame has to move at least, if it proves edges by references alone; above "
    "1 is possible where all fits into the caches. Fourth: memory in bytes a point, without the "
    "caller's points.")


def draw_motion(axes, results, place, motion, height):
    """A line for each number of threads; height(row) may be None where there is nothing to show."""
    for line, threads in zip(LINES, results.values("threads")):
        rows = [row for row in results.select(motion=motion, threads=threads)
                if height(row) is not None]
        if rows:
            axes.plot(numbers(rows, "points"), [height(row) for row in rows], line,
                      color=style.COLORS[place], marker=MARKERS[place % len(MARKERS)],
                      markersize=3, label=f"{motion}, {threads}")


def draw_motions(axes, results, motions, height, ylabel):
    for place, motion in enumerate(results.values("motion")):
        if motion in motions:
            draw_motion(axes, results, place, motion, height)
    axes.set_xscale("log")
    axes.set_xlabel("points")
    axes.set_ylabel(ylabel)


def speedup_of(results):
    first = results.values("threads")[0]

    def speedup(row):
        if row["threads"] == first:
            return None
        before = results.select(motion=row["motion"], points=row["points"], threads=first)[0]
        return float(before["total"]) / float(row["total"])

    return speedup


def share_of(bandwidths):
    def share(row):
        machine = bandwidths.select(threads=row["threads"])[0]
        return float(machine["skipping"]) / float(row["total"]) / float(machine["copy"])

    return share


def draw_memory(axes, memory):
    rows = memory.select(threads=memory.values("threads")[-1])
    for place, (column, label) in enumerate(BYTES):
        axes.plot(numbers(rows, "points"), numbers(rows, column),
                  color=style.COLORS[place], marker=MARKERS[place], markersize=3, label=label)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("points")
    axes.set_ylabel("bytes a point")
    axes.legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.45, 1))


def main():
    folder = pathlib.Path(sys.argv[1])
    if not (folder / "scale.csv").exists():
        return  # with --serial there are no curves
    results = Results(folder / "scale.csv")
    motions = results.values("motion")
    figure, panels = style.new_figure(4)
    draw_motions(panels[0], results, motions, lambda row: float(row["total"]), "ns a point")
    style.plain_logarithmic(panels[0].yaxis)
    panels[0].legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.45, 1))
    draw_motions(panels[1], results, motions, speedup_of(results), "times faster")
    panels[1].axhline(1, color="gray", linewidth=0.8)
    panels[1].set_ylim(bottom=0)
    draw_motions(panels[2], results, CALM, share_of(Results(folder / "bandwidth.csv")),
                 "share of the bandwidth")
    panels[2].set_ylim(bottom=0)
    draw_memory(panels[3], Results(folder / "memory.csv"))
    style.save(figure, folder / "scale", CAPTION, results.remark("command"))
    print(f"Figure: {folder / 'scale.svg'}", file=sys.stderr)


if __name__ == "__main__":
    main()
