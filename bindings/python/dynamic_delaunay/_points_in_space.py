# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What points in open and in periodic space have in common."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any, Optional, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import as_integer, as_list, as_rows
from ._changes import ChangedEdges, ChangedEdgesByIds, checked_changes
from ._checkpoints import Checkpoints
from ._core import UpdateReport3D
from ._places import Places
from ._rows import Rows

Self = TypeVar("Self", bound="PointsInSpace")


class Changeable(Protocol):
    """What the classes of C++ have for them."""

    def _insert(self, points: ArrayLike, ids: Optional[ArrayLike]) -> NDArray[np.int64]: ...

    def _remove(self, ids: ArrayLike) -> UpdateReport3D: ...

    def _move(self, ids: ArrayLike, points: ArrayLike) -> UpdateReport3D: ...


class PointsInSpace(Checkpoints, Places, Rows):
    """Triangulations that are copied and pickled."""

    _settings: dict[str, Any]
    _coordinates = 3

    if TYPE_CHECKING:  # the classes of C++ have these

        def _start_as_copy(self, other: Any) -> None: ...

        def _checkpoint(self) -> bytes: ...

        def _restore(self, checkpoint: bytes) -> None: ...

    def _init_empty(self, settings: dict[str, Any]) -> None:
        """Starts without points; in periodic space with any cell, as a checkpoint has its own."""
        raise NotImplementedError

    def __copy__(self: Self) -> Self:
        twin = self._twin()
        vars(twin).update(vars(self))
        return twin

    def __deepcopy__(self: Self, memo: dict[int, Any]) -> Self:
        twin = memo[id(self)] = self._twin()
        vars(twin).update(copy.deepcopy(vars(self), memo))
        return twin

    def _twin(self: Self) -> Self:
        twin = type(self).__new__(type(self))
        twin._start_as_copy(self)
        return twin

    def __reduce__(self) -> tuple[Any, ...]:
        checkpoint = self.checkpoint()  # UseError if there are no settings, as __init__() was not called
        others = {name: value for name, value in vars(self).items() if name != "_settings"}
        return _restored, (type(self), self._settings, checkpoint), others or None


def _restored(kind: type[Self], settings: dict[str, Any], checkpoint: bytes) -> Self:
    triangulation = kind.__new__(kind)
    triangulation._init_empty(settings)
    triangulation.restore(checkpoint)
    return triangulation


def checked_settings(settings: dict[str, Any]) -> dict[str, Any]:
    threads = as_integer("threads", settings["threads"], 2**31)
    return dict(threads=threads, changes=checked_changes(settings["changes"]))


class ByNumbers3D(ChangedEdges):
    """Points with the ids 0, 1, 2, ..."""

    def insert(self: Changeable, points: ArrayLike) -> NDArray[np.int64]:
        """Add points, float (m, 3), or one, (3,); return their ids, int64 (m,)."""
        return self._insert(as_rows(points, 3), None)

    def remove(self: Changeable, ids: ArrayLike) -> UpdateReport3D:
        """Remove points by their ids, int (m,), or one."""
        return self._remove(as_list(ids))

    def move(self: Changeable, ids: ArrayLike, points: ArrayLike) -> UpdateReport3D:
        """Move some points, int (m,), or one, to positions, float (m, 3) or (3,). All others stay."""
        return self._move(as_list(ids), as_rows(points, 3))


class ByIds3D(ChangedEdgesByIds):
    """Points that come and go, by any integers of 64 bits as ids."""

    _has_user_ids = True

    def insert(self: Changeable, ids: ArrayLike, points: ArrayLike) -> None:
        """Add points, float (m, 3), or one, (3,), by new ids, int (m,), or one."""
        self._insert(as_rows(points, 3), as_list(ids))

    def remove(self: Changeable, ids: ArrayLike) -> UpdateReport3D:
        """Remove points by their ids, int (m,), or one."""
        return self._remove(as_list(ids))

    def move(self: Changeable, ids: ArrayLike, points: ArrayLike) -> UpdateReport3D:
        """Move some points, int (m,), or one, to positions, float (m, 3) or (3,). All others stay."""
        return self._move(as_list(ids), as_rows(points, 3))
