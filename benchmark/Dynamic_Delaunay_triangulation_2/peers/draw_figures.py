#!/usr/bin/python3
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws peers.csv: what every peer needs a point, by motion and number of points."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "figures"))
import figure_style as style  # noqa: E402
from results_file import Results, numbers  # noqa: E402

OURS = "this package exact"
MARKERS = "oshD^vXP"
CAPTION = (
    "Time to triangulate one frame: medians over the frames, bars from the lower to the upper "
    "quartile, on a logarithmic axis; lower is faster. All on the same frames, in turn. Numbers after "
    "'Brownian' are steps in mean spacings; teleport is a fresh random cloud in every frame. A red "
    "ring marks whoever is faster than this package's exact update; a gray one, quartiles that "
    "overlap with its own. The heuristic one is not exact.")


def label(motion):
    return motion.replace("brownian_", "Brownian ").replace("_", " ")


def draw_peer(axes, results, points, place, peer):
    """One row of markers; they stand next to each other where motions are the same."""
    peers = results.values("peer")
    motions = results.values("motion")
    rows = results.select(points=points, peer=peer)
    offset = 0.09 * (place - (len(peers) - 1) / 2)
    xs = [motions.index(row["motion"]) + offset for row in rows]
    medians, lows, highs = (numbers(rows, name) for name in ("ns_per_point", "q1", "q3"))
    spread = [[m - low for m, low in zip(medians, lows)],
              [high - m for m, high in zip(medians, highs)]]
    color = style.COLORS[place]
    axes.errorbar(xs, medians, yerr=spread, fmt=MARKERS[place], color=color, markersize=4,
                  elinewidth=1, label=peer, zorder=3)
    for result, ring in (("loss", "#e00000"), ("even", "#909090")):
        chosen = [(x, y) for x, y, row in zip(xs, medians, rows) if row["result"] == result]
        axes.plot([x for x, _ in chosen], [y for _, y in chosen], "o", color="none",
                  markeredgecolor=ring, markersize=9, markeredgewidth=1.3, zorder=4)


def draw_level(axes, results, points):
    """Our own time as a bar, so that one sees at a glance who is below."""
    motions = results.values("motion")
    for row in results.select(points=points, peer=OURS):
        place = motions.index(row["motion"])
        axes.hlines(float(row["ns_per_point"]), place - 0.45, place + 0.45, color="black",
                    linewidth=0.8, alpha=0.5)


def draw_panel(axes, results, points):
    motions = results.values("motion")
    draw_level(axes, results, points)
    for place, peer in enumerate(results.values("peer")):
        draw_peer(axes, results, points, place, peer)
    axes.set_yscale("log")
    axes.set_ylabel("ns a point")
    axes.set_title(f"{int(points):,} points")
    axes.set_xticks(range(len(motions)), [label(motion) for motion in motions], rotation=30,
                    ha="right", rotation_mode="anchor")
    axes.set_xlim(-0.5, len(motions) - 0.5)
    axes.grid(axis="x", visible=False)
    for place in range(1, len(motions)):
        axes.axvline(place - 0.5, color="gray", linewidth=0.4, alpha=0.5)


def main():
    folder = pathlib.Path(sys.argv[1])
    results = Results(folder / "peers.csv")
    sizes = results.values("points")
    figure, panels = style.new_figure(len(sizes), 3.4, sharey=True)
    for axes, points in zip(panels, sizes):
        draw_panel(axes, results, points)
    panels[0].legend(loc="lower center", bbox_to_anchor=(0.45, 1.1), ncols=2, frameon=False)
    style.save(figure, folder / "peers", CAPTION, results.remark("command"))
    print(f"Figure: {folder / 'peers.svg'}", file=sys.stderr)


if __name__ == "__main__":
    main()
