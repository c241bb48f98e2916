# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Edges that come and go, in the plane and in space."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ._core import Group
from .errors import InputTypeError, NotRecordedError


class Recording(Protocol):
    """What triangulations have for them."""

    def _arrays(self, group: Group) -> tuple[NDArray[Any], ...]: ...


def checked_changes(changes: Any) -> bool:
    if not isinstance(changes, (bool, np.bool_)):
        raise InputTypeError(f"changes is {changes!r}: it must be True or False")
    return bool(changes)


def recorded(triangulation: Recording) -> tuple[NDArray[Any], ...]:
    if not getattr(triangulation, "_settings", {"changes": True})["changes"]:
        kind = type(triangulation).__name__
        raise NotRecordedError(f"changed edges are recorded only with changes=True, as by {kind}(..., changes=True)")
    return triangulation._arrays(Group.CHANGES)


class ChangedEdgeShifts:
    """Of edges in periodic space; the shifts are those of the second ends."""

    @property
    def created_edge_shifts(self: Recording) -> NDArray[np.int32]:
        """int32 (k, d): the shifts of ``created_edges``, in the plane with two numbers, in space with three."""
        return recorded(self)[2]

    @property
    def removed_edge_shifts(self: Recording) -> NDArray[np.int32]:
        """int32 (k, d): the shifts of ``removed_edges``, as they would be called now, in the plane with two numbers, in
        space with three."""
        return recorded(self)[3]


class ChangedEdges:
    """Of points with the ids 0, 1, 2, ..."""

    @property
    def created_edges(self: Recording) -> NDArray[np.int32]:
        """int32 (k, 2): edges of now that were not there before the last call. Needs ``changes=True``."""
        return recorded(self)[0]

    @property
    def removed_edges(self: Recording) -> NDArray[np.int32]:
        """int32 (k, 2): edges before the last call that are not there now. Needs ``changes=True``."""
        return recorded(self)[1]


class ChangedEdgesByIds:
    """Of points with ids of the user."""

    @property
    def created_edges(self: Recording) -> NDArray[np.int64]:
        """int64 (k, 2): edges of now, by the ids of both ends, that were not there before the last call. Needs
        ``changes=True``."""
        return recorded(self)[0]

    @property
    def removed_edges(self: Recording) -> NDArray[np.int64]:
        """int64 (k, 2): edges before the last call, by the ids of both ends, that are not there now; the points may
        have left. Needs ``changes=True``."""
        return recorded(self)[1]
