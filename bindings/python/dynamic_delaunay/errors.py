# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What is raised for bad input and wrong use, before anything changes. Messages say what is allowed.

Whatever an attribute may raise is an ``AttributeError`` as well. So ``hasattr()`` has an answer, and what lists all
attributes, such as a notebook, passes over those that an object cannot have now."""


class DynamicDelaunayError(Exception):
    """The base of all of them."""


class InputTypeError(DynamicDelaunayError, TypeError):
    """An argument, or what a classifier returned, has a type that cannot be used."""


class InputValueError(DynamicDelaunayError, ValueError):
    """An argument has another shape than it must have, or is none of the values that are allowed."""


class InputIndexError(DynamicDelaunayError, IndexError):
    """There is no such row; or a classifier has named a vertex or an edge that does not exist."""


class UseError(DynamicDelaunayError, RuntimeError, AttributeError):
    """An object is used when it cannot be: before ``__init__()``, or by its own classifier; or it has no such part."""


class NonFiniteCoordinateError(DynamicDelaunayError, ValueError):
    """A coordinate is NaN or infinite. ``id`` of the point, ``x``, ``y``, in space ``z``. Where ids are given: its
    place."""

    id: int
    x: float
    y: float
    z: float


class CoordinateRangeError(DynamicDelaunayError, ValueError):
    """A coordinate is too large. ``id`` of the point, ``x``, ``y``, in space ``z``, ``limit``. Where ids are given: its
    place."""

    id: int
    x: float
    y: float
    z: float
    limit: float


class PointCountError(DynamicDelaunayError, ValueError):
    """A frame has too few or too many points. ``expected``; ``given``, where one more means that many or more."""

    expected: int
    given: int


class PointLimitError(DynamicDelaunayError, ValueError):
    """There would be more points than a triangulation holds. ``number`` of them, ``limit``."""

    number: int
    limit: int


class UnknownIdError(DynamicDelaunayError, LookupError):
    """No point has this ``id``."""

    id: int


class RepeatedIdError(DynamicDelaunayError, ValueError):
    """An ``id`` is given more than once, or belongs to a point already."""

    id: int


class UncertifiedTriangulationError(DynamicDelaunayError, RuntimeError, AttributeError):
    """What is asked for needs an exact triangulation: call ``mend()`` after a heuristic update, or in
    space after one for which memory did not suffice."""


class NotRecordedError(InputValueError, AttributeError):
    """Changed edges are asked for, which are recorded only with ``changes=True``."""


class ParameterError(DynamicDelaunayError, ValueError):
    """A parameter is out of range. ``value``."""

    value: float


class DomainError(DynamicDelaunayError, ValueError):
    """The corners of a domain are not those of a simple polygon with holes; or space is periodic, and has none.
    ``corner``, its place, where those of holes follow those of the outer boundary."""

    corner: int


class PeriodicCellError(DynamicDelaunayError, ValueError):
    """A periodic cell has parallel vectors, numbers that are not finite, or is too thin."""


class PeriodicRangeError(DynamicDelaunayError, ValueError):
    """A point is 2**20 cells or more from the origin. ``id`` of the point. Where ids are given: its place."""

    id: int


class RecordingError(DynamicDelaunayError, ValueError):
    """A file of recorded motion, or a table, cannot be read as it should. ``line``, or 0 if the error concerns no
    line."""

    line: int


class CheckpointError(DynamicDelaunayError, ValueError):
    """A checkpoint is damaged, has something after its end, or cannot be written. ``line``, or 0 if the error concerns
    no line."""

    line: int
