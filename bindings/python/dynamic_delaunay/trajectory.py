# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whole trajectories, frame by frame."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple, Optional, Union, cast

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import are_in_space
from ._core import UpdateReport
from ._triangulations import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population
from .errors import (
    CoordinateRangeError,
    DynamicDelaunayError,
    InputTypeError,
    InputValueError,
    NonFiniteCoordinateError,
    PeriodicRangeError,
)
from .periodic_space import PeriodicDelaunay3D, PeriodicPopulation3D
from .recording import RecordedFrame
from .space import DynamicDelaunay3D, Population3D

Followed = Union[DynamicDelaunay, PeriodicDelaunay, Population, PeriodicPopulation]


class _FrameFields(NamedTuple):
    number: Any
    """of the frame, from 0, or what the table or the recording says"""
    triangulation: Followed
    """or, of points in space, a DynamicDelaunay3D, Population3D, PeriodicDelaunay3D or PeriodicPopulation3D"""
    report: UpdateReport
    """what the update did; in space an UpdateReport3D"""


class Frame(_FrameFields):
    """One frame of a trajectory: its number, the triangulation, and the report of its update. The triangulation is the
    same object in all of them: keep copies of its arrays, which stay as they were, not the triangulation."""

    _names: Optional[_Names] = None

    @property
    def ids(self) -> NDArray[Any]:
        """(rows,): the ids of all rows as the trajectory has them, int64 or text. Where they are text, those of the
        triangulation are numbers."""
        ids = self.triangulation.ids
        return ids if self._names is None else self._names.of(ids)


class _Read(NamedTuple):
    """A frame of the user."""

    number: Any
    ids: Any
    points: Any
    cell: Any


class _Names:
    """Numbers 0, 1, 2, ... for ids that are text, in the order in which they appear."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}
        self._texts: list[str] = []

    def numbers(self, ids: NDArray[Any]) -> NDArray[np.int64]:
        for text in map(str, ids):
            if text not in self._numbers:
                self._numbers[text] = len(self._texts)
                self._texts.append(text)
        return np.array([self._numbers[str(text)] for text in ids], dtype=np.int64)

    def of(self, numbers: NDArray[np.int64]) -> NDArray[Any]:
        return np.array([self._texts[number] for number in numbers], dtype=str)


def track(trajectory: Any, cell: Any = None, *, progress: bool = False, **settings: Any) -> Iterator[Frame]:
    """Follow a trajectory: ``for frame in track(trajectory): frame.triangulation.areas``.

    Parameters
    ----------
    trajectory
        An array (frames, n, 2), or anything that iterates over arrays (n, 2), or over pairs (ids, points) if points
        come and go; what ``read_recording()`` returns; or a pandas table with the columns frame, id, x and y, in any
        order of rows, by these names or by those of trackpy, TrackMate, PedPy and others. Ids are integers or text.
        Points in space are arrays (n, 3), or in a table those of a column z that differ there.
    cell
        Of a periodic space; see PeriodicDelaunay. Without it a recording has its own cells.
    progress : bool
        Whether tqdm shows how far it is, if it is installed.
    settings
        classifier, repair and so on, as of DynamicDelaunay or Population; for points in space changes and threads.

    What is wrong with a frame is an error of the package, whose message begins with the frame.
    """
    if hasattr(trajectory, "columns"):
        trajectory = list(_frames_of_table(trajectory))
    frames = _with_progress(trajectory) if progress else trajectory
    followed: Optional[Followed] = None
    names: Optional[_Names] = None
    for number, frame in enumerate(frames):
        read = _read(number, frame)
        try:
            if followed is None:
                names = _Names() if _are_texts(read.ids) else None
                followed = _follow(read, cell, settings)
            report = _update(followed, _with_numbers(read, names), cell, is_first=number == 0)
        except DynamicDelaunayError as error:
            error.args = (f"frame {read.number}{_whose(error, read)}: {error}",)
            raise
        followed_frame = Frame(read.number, followed, report)
        followed_frame._names = names
        yield followed_frame


def _are_texts(ids: Any) -> bool:
    array = np.asarray([] if ids is None else ids)
    return array.dtype.kind in "US" or (
        array.dtype.kind == "O" and array.size > 0 and all(isinstance(id, str) for id in array.flat)
    )


def _with_numbers(read: _Read, names: Optional[_Names]) -> _Read:
    """The frame with numbers instead of text."""
    if _are_texts(read.ids) != (names is not None) and np.size(read.ids):
        kinds = ("text", "numbers") if names is None else ("numbers", "text")
        raise InputTypeError(f"the ids are {kinds[0]}, and those of the first frame {kinds[1]}")
    return read if names is None else read._replace(ids=names.numbers(np.asarray(read.ids)))


def _follow(read: _Read, cell: Any, settings: dict[str, Any]) -> Followed:
    """Without points, but for those whose number does not change."""
    cell = read.cell if cell is None else cell
    if are_in_space(read.points):
        return cast(Followed, _follow_in_space(read, cell, settings))  # a shape is no part of a type
    if read.ids is not None:
        return Population(**settings) if cell is None else PeriodicPopulation(cell=cell, **settings)
    return DynamicDelaunay(**settings) if cell is None else PeriodicDelaunay(cell=cell, **settings)


def _follow_in_space(read: _Read, cell: Any, settings: dict[str, Any]) -> object:
    if read.ids is not None:
        return Population3D(**settings) if cell is None else PeriodicPopulation3D(cell=cell, **settings)
    return DynamicDelaunay3D(**settings) if cell is None else PeriodicDelaunay3D(cell=cell, **settings)


def _update(followed: Followed, read: _Read, cell: Any, is_first: bool) -> UpdateReport:
    if isinstance(followed, (Population, Population3D)):
        return followed.update(read.ids, read.points)
    if isinstance(followed, (PeriodicPopulation, PeriodicPopulation3D)):
        return followed.update(read.ids, read.points, read.cell if cell is None else None)
    if is_first:
        followed.insert(read.points)
        return followed.last_report
    return followed.update(read.points)


def _whose(error: DynamicDelaunayError, read: _Read) -> str:
    """Errors about positions have places in the frame, where there are ids."""
    if read.ids is None or not isinstance(error, (NonFiniteCoordinateError, CoordinateRangeError, PeriodicRangeError)):
        return ""
    return f", id {np.asarray(read.ids)[error.id]}"


def _read(number: int, frame: Any) -> _Read:
    if isinstance(frame, _Read):
        return frame
    if isinstance(frame, RecordedFrame):
        return _Read(frame.number, frame.ids, frame.points, frame.cell)
    if isinstance(frame, tuple):
        return _Read(number, frame[0], frame[1], None)
    return _Read(number, None, frame, None)


def _column(table: Any, title: Any) -> NDArray[Any]:
    """Pandas has integers of its own, of which NumPy would make objects."""
    column = table[title]
    array: NDArray[Any] = column.to_numpy(dtype=np.int64) if column.dtype.kind == "i" else column.to_numpy()
    return array


def _height(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return np.nan  # which in the plane does not matter


def _with_heights(points: NDArray[np.float64], heights: Any) -> NDArray[np.float64]:
    """The points in space if some of their third coordinates differ, as ``read_recording()`` has it."""
    heights = np.array([_height(value) for value in heights])
    finite = heights[np.isfinite(heights)]
    return np.column_stack([points, heights]) if (finite != finite[:1]).any() else points


def _frames_of_table(table: Any) -> Iterator[_Read]:
    titles = list(table.columns)
    frame, time, id, x, y, z = _core._table_columns([str(title) for title in titles])
    numbers = _column(table, titles[time if frame < 0 else frame])
    try:
        points = table[[titles[x], titles[y]]].to_numpy(dtype=np.float64)
        are_missing = np.isnan(np.asarray(numbers, dtype=np.float64))
    except (TypeError, ValueError) as error:
        raise InputValueError(
            f"the table has frames or positions that are no numbers: {error}. Further header lines, as TrackMate "
            "writes them, are left out by pandas.read_csv(path, skiprows=[1, 2, 3]), or by read_recording(path)"
        ) from None
    if are_missing.any():
        raise InputValueError(f"row {np.argmax(are_missing)} of the table has no frame")
    order = np.argsort(numbers, kind="stable")
    if z >= 0:
        points = _with_heights(points, table[titles[z]])
    ids, points = _column(table, titles[id])[order], points[order]
    numbers, begins = np.unique(numbers[order], return_index=True)
    for number, begin, end in zip(numbers, begins, [*begins[1:], len(ids)]):
        yield _Read(number, ids[begin:end], points[begin:end], None)


def _with_progress(trajectory: Iterable[Any]) -> Iterable[Any]:
    try:
        tqdm: Any = importlib.import_module("tqdm.auto")  # with and without stubs
    except ImportError:
        return trajectory
    shown: Iterable[Any] = tqdm.tqdm(trajectory)  # which asks for the length
    return shown
