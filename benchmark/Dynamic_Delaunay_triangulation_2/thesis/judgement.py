# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The simulation as judge (thesis, 6.2.3): does a run that a heuristic drives go as an exact one?

Both are means or ranges over trials that differ in their jitter, to which a simulation is sensitive;
so a heuristic run may be anywhere where an exact one has been.
"""

from names import EXACT
from results_file import numbers

QUANTITIES = ["kinetic", "energy", "center_x", "center_y", "front"]

# Slack around the range of the exact runs: a hundredth of the energy at the start, a tenth of a
# particle's diameter. More than so many frames outside of it are a drift.
ENERGY_SLACK = 0.01
LENGTH_SLACK = 0.1
ALLOWED_SHARE = 0.1

# Volatile is what has more than so many times the kinetic energy of any exact run in the last tenth
# of the frames, or gains so much of its first energy.
VOLATILE = 2.0
GAIN = 0.05


def share_outside(rows, exact, column, slack):
    """The share of the frames in which the mean is outside of the exact runs' range."""
    outside = [not low - slack <= value <= high + slack
               for value, low, high in zip(numbers(rows, column), numbers(exact, column + "_min"),
                                           numbers(exact, column + "_max"))]
    return sum(outside) / len(outside)


def slack_of(column, first_energy):
    return ENERGY_SLACK * first_energy if column in ("kinetic", "energy") else LENGTH_SLACK


def is_volatile(rows, exact):
    last = max(1, len(rows) // 10)
    first_energy = float(exact[0]["energy_max"])
    slack = ENERGY_SLACK * first_energy
    kinetic = sum(numbers(rows[-last:], "kinetic")) / last
    gain = max(numbers(rows, "energy")) - max(numbers(exact, "energy_max"))
    return (kinetic > VOLATILE * max(numbers(exact[-last:], "kinetic_max")) + slack
            or gain > GAIN * first_energy)


def verdict(physics, scenario, method):
    """divergent, drifting or convergent, and the largest share of frames outside of the exact range."""
    rows = physics.select(scenario=scenario, method=method)
    exact = physics.select(scenario=scenario, method=EXACT)
    first_energy = float(exact[0]["energy_max"])
    share = max(share_outside(rows, exact, column, slack_of(column, first_energy))
                for column in QUANTITIES)
    if is_volatile(rows, exact):
        return "divergent", share
    return ("drifting" if share > ALLOWED_SHARE else "convergent"), share
