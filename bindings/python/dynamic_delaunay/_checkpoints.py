# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checkpoints, of triangulations in the plane and in space."""

from __future__ import annotations

import os
from typing import Any, Optional, Protocol, Union

from .errors import InputTypeError


class Restorable(Protocol):
    """What the classes of C++ have for them."""

    def _checkpoint(self) -> bytes: ...

    def _restore(self, checkpoint: bytes) -> None: ...


class Checkpoints:
    """Triangulations that can be saved and loaded."""

    def checkpoint(self: Restorable) -> bytes:
        """The triangulation with all its numbers, as text. A run goes on from it as if it had not been interrupted."""
        return self._checkpoint()

    def restore(self: Restorable, checkpoint: Optional[bytes] = None) -> None:
        """Replace everything by a checkpoint of the same kind. CheckpointError if it is damaged, or if
        anything follows; nothing changes."""
        _check_loads(self, "restore", checkpoint)
        assert checkpoint is not None
        try:
            text = bytes(memoryview(checkpoint))
        except TypeError as error:
            raise InputTypeError(f"a checkpoint is no {type(checkpoint).__name__}: {error}") from None
        self._restore(text)

    def save(self: Restorable, path: Union[str, os.PathLike[str]]) -> None:
        """Write a checkpoint to a file."""
        with open(path, "wb") as file:
            file.write(self._checkpoint())

    def load(self: Restorable, path: Union[str, os.PathLike[str], None] = None) -> None:
        """Replace everything by the checkpoint in a file: ``dt = DynamicDelaunay(); dt.load(path)``."""
        _check_loads(self, "load", path)
        assert path is not None
        with open(path, "rb") as file:
            self._restore(file.read())


def _check_loads(triangulation: Any, call: str, given: Any) -> None:
    if given is None or not isinstance(triangulation, Checkpoints):
        raise InputTypeError(
            f"{call}() is called by a triangulation, of which it replaces everything, with one argument: "
            f"dt = DynamicDelaunay(), or another kind, and then dt.{call}(...)"
        )
