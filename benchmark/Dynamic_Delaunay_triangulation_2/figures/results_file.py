# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads the CSV files that benchmarks write."""

import csv


class Results:
    """A CSV file of results: its rows as dictionaries of texts, and what it says of its origin."""

    def __init__(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            lines = file.read().splitlines()
        self.remarks = [line[2:] for line in lines if line.startswith("# ")]
        self.rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def remark(self, name):
        """What stands behind `name: ` in one of the remarks."""
        for remark in self.remarks:
            if remark.startswith(name + ": "):
                return remark[len(name) + 2:]
        raise KeyError(f"no remark '{name}'")

    def values(self, column):
        """The different texts of a column, in the order in which they come."""
        return list(dict.fromkeys(row[column] for row in self.rows))

    def select(self, **wanted):
        """The rows that have all these texts."""
        return [row for row in self.rows if all(row[name] == text for name, text in wanted.items())]


def numbers(rows, column):
    """A column of rows as numbers."""
    return [float(row[column]) for row in rows]
