# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whole trajectories, frame by frame."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._core import UpdateReport
from ._triangulations import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population
from .errors import InputValueError

Followed = Union[DynamicDelaunay, PeriodicDelaunay, Population, PeriodicPopulation]


class Frame(NamedTuple):
    """One frame of a trajectory. The triangulation is the same object in all of them: keep copies of its arrays, which
    stay as they were, not the triangulation."""

    number: Any
    """of the frame, from 0, or what the table says"""
    triangulation: Followed
    report: UpdateReport
    """what the update did"""


def track(trajectory: Any, cell: Any = None, *, progress: bool = False, **settings: Any) -> Iterator[Frame]:
    """Follow a trajectory: ``for frame in track(trajectory): frame.triangulation.areas``.

    Parameters
    ----------
    trajectory
        An array (frames, n, 2), or anything that iterates over arrays (n, 2), or over pairs (ids, points) if points
        come and go; or a pandas table with the columns frame, id, x and y, in any order of rows.
    cell
        Of a periodic space; see PeriodicDelaunay.
    progress : bool
        Whether tqdm shows how far it is, if it is installed.
    settings
        classifier, repair and so on, as of DynamicDelaunay or Population.
    """
    frames: Iterable[Any] = _frames_of_table(trajectory) if hasattr(trajectory, "columns") else _frames(trajectory)
    if progress:
        frames = _with_progress(frames, trajectory)
    followed: Optional[Followed] = None
    for number, ids, points in frames:
        if followed is None:
            followed = _follow(ids is not None, points, cell, settings)
        if isinstance(followed, (Population, PeriodicPopulation)):
            report = followed.update(ids, points)
        elif number == 0:
            report = followed.last_report
        else:
            report = followed.update(points)
        yield Frame(number, followed, report)


def _follow(has_ids: bool, points: Any, cell: Any, settings: dict[str, Any]) -> Followed:
    if has_ids and cell is not None:
        return PeriodicPopulation(cell=cell, **settings)
    if has_ids:
        return Population(**settings)
    if cell is not None:
        return PeriodicDelaunay(points, cell, **settings)
    return DynamicDelaunay(points, **settings)


def _frames(trajectory: Iterable[Any]) -> Iterator[tuple[Any, Any, Any]]:
    for number, frame in enumerate(trajectory):
        if isinstance(frame, tuple):
            yield number, frame[0], frame[1]
        else:
            yield number, None, frame


def _frames_of_table(table: Any) -> Iterator[tuple[Any, NDArray[np.int64], NDArray[np.float64]]]:
    missing = {"frame", "id", "x", "y"}.difference(table.columns)
    if missing:
        raise InputValueError(f"the table has no column {', '.join(sorted(missing))}: it must have frame, id, x and y")
    numbers = table["frame"].to_numpy()
    order = np.argsort(numbers, kind="stable")
    ids = table["id"]
    is_integer = ids.dtype.kind == "i"  # pandas has integers of its own, of which NumPy would make objects
    ids = (ids.to_numpy(dtype=np.int64) if is_integer else ids.to_numpy())[order]
    points = table[["x", "y"]].to_numpy(dtype=np.float64)[order]
    numbers, begins = np.unique(numbers[order], return_index=True)
    for number, begin, end in zip(numbers, begins, [*begins[1:], len(ids)]):
        yield number, ids[begin:end], points[begin:end]


def _with_progress(frames: Iterable[Any], trajectory: Any) -> Iterable[Any]:
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        return frames
    if hasattr(trajectory, "columns"):
        total = trajectory["frame"].nunique()
    else:
        total = len(trajectory) if hasattr(trajectory, "__len__") else None
    shown: Iterable[Any] = tqdm(frames, total=total)
    return shown
