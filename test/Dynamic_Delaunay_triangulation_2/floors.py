# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks that headers include only those of their own room and of rooms on lower floors.

    floors.py REPOSITORY

The table of rooms in doc/architecture.md says on which floor each room is, and in which folders its headers lie. Each
header has to be in a room. The headers of the plane reach nothing of periodic space, what knows no dimension has no
`_2` in its name, no folder has more than fourteen headers, and only some rooms know the writer of a state.
"""

import pathlib
import re
import sys

PACKAGE = "CGAL/Dynamic_Delaunay_triangulation_2/"
MOST_HEADERS = 14
WITHOUT_DIMENSION, PERIODIC, OF_THE_PLANE = "base", "periodic", "CGAL/Dynamic_Delaunay_triangulation_2.h"
WRITERS, WRITER = {"topology", "space", "periodic"}, r"\bState::Writer\b|\bSpace::Writer\b"


class Room:
    def __init__(self, row):
        floor, self.name, where = (cell.strip() for cell in row.strip("|").split("|")[:3])
        self.floor = int(floor)
        self.paths = [path if path.startswith("CGAL/") else PACKAGE + path for path in re.findall(r"`([^`]+)`", where)]

    def may_include(self, other):
        return other is self or other.floor < self.floor


def rooms_of(architecture):
    """The rows of the table that begins with these columns."""
    lines = architecture.splitlines()
    begin = next((i for i, line in enumerate(lines) if line.startswith("| floor | room | where |")), len(lines))
    for line in lines[begin + 2 :]:
        if not line.startswith("|"):
            break
        yield Room(line)


def room_of(header, rooms):
    """The room that names the header, or else the closest folder around it."""
    named = [(len(path), number) for number, room in enumerate(rooms) for path in room.paths
             if header == path or header.startswith(path + "/")]
    return rooms[max(named)[1]] if named else None


def includes_of(include):
    headers = {path.relative_to(include).as_posix(): path for path in sorted(include.rglob("*.h"))}
    return {name: [other for other in re.findall(r"^\s*#\s*include <([^>]+)>", path.read_text(), re.M)
                   if other in headers] for name, path in headers.items()}


def reached_from(header, includes):
    reached, waiting = set(), [header]
    while waiting:
        for other in includes[waiting.pop()]:
            if other not in reached:
                reached.add(other)
                waiting.append(other)
    return reached


def broken_arrows(includes, room_of_header):
    for header, others in includes.items():
        room = room_of_header[header]
        if room is None:
            yield f"{header}: in no room of doc/architecture.md"
            continue
        for other in others:
            above = room_of_header[other]
            if above is not None and not room.may_include(above):
                yield f"{header}: includes {other}, but {room.name} is not above {above.name}"
    for other in sorted(reached_from(OF_THE_PLANE, includes)):
        if room_of_header[other] is not None and room_of_header[other].name == PERIODIC:
            yield f"{OF_THE_PLANE}: reaches {other}, which is for periodic space"


def broken_writers(include, room_of_header):
    for header, room in room_of_header.items():
        if room is not None and room.name not in WRITERS and re.search(WRITER, (include / header).read_text()):
            yield f"{header}: takes the writer of a state, which the room {room.name} must not"


def broken_places(include, rooms):
    for room in rooms:
        for path in room.paths:
            if not (include / path).exists():
                yield f"doc/architecture.md: the room {room.name} names {path}, which is not there"
            if room.name == WITHOUT_DIMENSION and path.startswith(PACKAGE + "internal/"):
                for header in sorted((include / path).glob("*_2.h")):
                    yield f"{header.relative_to(include)}: is in {room.name}, and has a dimension in its name"
    for folder in sorted(path for path in include.rglob("*") if path.is_dir()):
        number = len(list(folder.glob("*.h")))
        if number > MOST_HEADERS:
            yield f"{folder.relative_to(include)}: {number} headers, at most {MOST_HEADERS} are allowed"


def main():
    root = pathlib.Path(sys.argv[1])
    include = root / "include"
    rooms = list(rooms_of((root / "doc" / "architecture.md").read_text()))
    if len(rooms) < 2:
        sys.exit("doc/architecture.md: no table of rooms")
    includes = includes_of(include)
    room_of_header = {header: room_of(header, rooms) for header in includes}
    broken = [*broken_arrows(includes, room_of_header), *broken_writers(include, room_of_header),
              *broken_places(include, rooms)]
    sys.exit("\n".join(broken) if broken else 0)


if __name__ == "__main__":
    main()
