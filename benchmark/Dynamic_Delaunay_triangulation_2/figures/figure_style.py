# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""How figures of benchmark results look, and where their numbers come from.

A figure is as wide as a phone: panels stand below each other, letters stay readable there. Each is
written as SVG, with a caption below it that ends in the command that made its numbers.
"""

import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

WIDTH = 4.8  # inches; 100 pixels an inch on most screens
PANEL_HEIGHT = 2.7
CAPTION_LETTERS = 78  # in a line
CAPTION_SIZE = 7.5

# Told apart by color-blind people, too (Okabe and Ito 2008).
COLORS = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c8c8c",
           "#7a4f9a", "#a0522d", "#5f7f2f", "#b00040"]

plt.rcParams.update({
    "font.size": 9.5,
    "axes.titlesize": 10,
    "legend.fontsize": 8,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "lines.linewidth": 1.3,
    "svg.fonttype": "none",  # letters stay letters
    "svg.hashsalt": "Dynamic_Delaunay_triangulation_2",  # equal numbers give equal files
})


def new_figure(panels, panel_height=PANEL_HEIGHT, **options):
    """A figure and its list of panels, one below the other."""
    figure, axes = plt.subplots(panels, 1, figsize=(WIDTH, panels * panel_height), squeeze=False,
                                layout="constrained", **options)
    return figure, list(axes[:, 0])


def plain_logarithmic(axis):
    """A logarithmic axis whose ticks are plain numbers, 1, 2, 5 and 10 in a decade."""
    {"x": axis.axes.set_xscale, "y": axis.axes.set_yscale}[axis.axis_name]("log")
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def save(figure, path, caption, command):
    """Writes path.svg, the caption and the command below the panels."""
    lines = textwrap.wrap(caption, CAPTION_LETTERS)
    lines += textwrap.wrap("Command: " + command, CAPTION_LETTERS)
    width, height = figure.get_size_inches()
    below = (len(lines) + 1) * CAPTION_SIZE * 1.25 / 72
    figure.set_size_inches(width, height + below)
    figure.get_layout_engine().set(rect=(0, below / (height + below), 1, height / (height + below)))
    figure.text(0.02, 0.5 * CAPTION_SIZE / 72 / (height + below), "\n".join(lines),
                fontsize=CAPTION_SIZE, va="bottom", linespacing=1.25)
    figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    plt.close(figure)
