# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of recorded motion, read as ``./dev run`` reads them."""

from __future__ import annotations

import os
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import as_index
from .errors import InputTypeError, InputValueError


class RecordedFrame(NamedTuple):
    """One frame of a recording, which ``track()`` and ``update()`` of a population take."""

    number: int
    """of the frame or the time step, as in the file"""
    time: float
    """as in the file; the number if there is no time"""
    ids: NDArray[Any]
    """int64 (n,), ascending; or text (n,), if an id in the file is no integer, in the order of first appearance"""
    points: NDArray[np.float64]
    """float64 (n, 2): x and y of each point; (n, 3) of a recording in space: x, y and z"""
    cell: Optional[NDArray[np.float64]]
    """float64 (2, 2): the vectors of the periodic cell; (1, 2) of a slab; (3, 3) of a recording in space, (2, 3) of a
    slab there, or (1, 3) of a wire; None where space is open"""


def read_recording(
    path: Union[str, bytes, os.PathLike[str], os.PathLike[bytes]],
    columns: Optional[str] = None,
    dimension: Optional[int] = None,
) -> list[RecordedFrame]:
    """All frames of a file: a table of frame, id, x and y, and z if it is there, with the names that pandas, trackpy,
    TrackMate, PeTrack, PedPy and others have for these columns; a text dump of LAMMPS; or XYZ, extended or not. Also
    compressed by gzip.

    Parameters
    ----------
    path
        Of the file; ``-`` stands for standard input.
    columns : str, optional
        What the columns of a table are, where their names do not tell: their order, ``"frame,id,-,x,y"``, or their
        names, ``"frame=t,id=label"``.
    dimension : int, optional
        2 for x and y alone, 3 for x, y and z; without it, 3 if z of some points differ.

    RecordingError if the file cannot be read as it should, with the line, or if it is in space and its box is periodic
    along only one of its sides; ``FileNotFoundError`` if there is none.
    """
    if columns is not None and not isinstance(columns, str):
        raise InputTypeError(f"the columns are {columns!r}: they must be text, such as 'frame,id,x,y'")
    wanted = None if dimension is None else as_index("the dimension", dimension)
    if wanted not in (None, 2, 3):
        raise InputValueError(f"the dimension is {wanted}: it must be 2, 3 or None")
    try:
        name = os.fsencode(path)
    except TypeError as error:
        raise InputTypeError(f"the path is {path!r}: {error}") from None
    if name != b"-":
        os.stat(name)
    return [RecordedFrame(*frame) for frame in _core._read_recording(name, columns or "", wanted)]
