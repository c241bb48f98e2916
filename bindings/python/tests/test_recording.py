# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of recorded motion, and tables by the column names of several programs."""

import gzip
import pathlib

import numpy as np
import pytest
from scipy.spatial import Delaunay

from dynamic_delaunay import PeriodicPopulation, Population, Population3D, errors, read_recording, track


def dump_of(step, rows, *, bounds="pp pp pp\n0 10\n0 8\n-0.5 0.5", columns="id type x y z", before=""):
    lines = "".join(f"{row}\n" for row in rows)
    return (f"{before}ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS {bounds}\n"
            f"ITEM: ATOMS {columns}\n{lines}")


def read(tmp_path, name, text, **choice):
    path = tmp_path / name
    path.write_text(text)
    return read_recording(path, **choice)


def test_reads_numbers_times_ids_points_and_cells(tmp_path):
    text = dump_of(100, ["9007199254740993 1 1 2 0", "9007199254740992 1 3 4 0"]) + dump_of(250, ["7 1 5 6 0"])
    first, second = read(tmp_path, "motion.lammpstrj", text)
    assert (first.number, second.number) == (100, 250)
    assert first.ids.dtype == np.int64 and first.ids.tolist() == [2**53, 2**53 + 1]  # as doubles they would be one
    assert first.points.tolist() == [[3, 4], [1, 2]] and first.cell.tolist() == [[10, 0], [0, 8]]
    for array in (first.ids, first.points, first.cell):
        assert not array.flags.writeable
    assert second.ids.tolist() == [7] and isinstance(second.number, int) and isinstance(second.time, float)


def test_reads_what_lammps_may_write(tmp_path):
    no_atoms = dump_of(0, [])
    scaled = dump_of(1, ["3 0.5 0.25"], columns="id xs ys", before="ITEM: UNITS\nlj\nITEM: TIME\n0.005\n")
    frames = read(tmp_path, "motion.dump", no_atoms + scaled + "\n\n")
    assert [len(frame.ids) for frame in frames] == [0, 1]
    assert frames[0].points.shape == (0, 2) and frames[1].points.tolist() == [[5, 2]]
    populations = [(frame.number, len(frame.triangulation)) for frame in track(frames)]
    assert populations == [(0, 0), (1, 1)]


def test_cells_may_be_tilted_slabs_or_none(tmp_path):
    tilted = "xy xz yz pp pp pp\n0 11 1\n0 8 0\n-0.5 0.5 0"
    for bounds, cell, kind in (
        (tilted, [[10, 0], [1, 8]], PeriodicPopulation),
        ("pp ff pp\n0 10\n0 8\n-0.5 0.5", [[10, 0]], PeriodicPopulation),
        ("ff pp pp\n0 10\n0 8\n-0.5 0.5", [[0, 8]], PeriodicPopulation),
        ("ff ff pp\n0 10\n0 8\n-0.5 0.5", None, Population),
    ):
        (frame,) = read(tmp_path, "motion.lammpstrj", dump_of(5, ["1 1 0.5 4 0", "2 1 9.5 4 0"], bounds=bounds))
        assert (frame.cell is None) if cell is None else (frame.cell.tolist() == cell)
        (followed,) = track([frame])
        assert type(followed.triangulation) is kind and followed.number == 5
        if cell is not None:
            assert followed.triangulation.cell.tolist() == cell


def test_a_cell_that_changes_is_followed_and_may_be_replaced(tmp_path):
    text = dump_of(0, ["1 1 1 1 0"]) + dump_of(1, ["1 1 1 1 0"], bounds="pp pp pp\n0 20\n0 9\n-1 1")
    frames = read(tmp_path, "motion.lammpstrj", text)
    assert [frame.triangulation.cell.diagonal().tolist() for frame in track(frames)] == [[10, 8], [20, 9]]
    assert [frame.triangulation.cell.diagonal().tolist() for frame in track(frames, (30, 30))] == [[30, 30]] * 2


def test_ids_that_are_text_stay_text(tmp_path):
    text = "frame,id,x,y\n120,ann,0,1\n120,Jürgen,2,3\n125,Jürgen,4,5\n125,7,6,7\n"
    frames = read(tmp_path, "crowd.csv", text)
    assert [frame.number for frame in frames] == [120, 125]
    assert [frame.ids.tolist() for frame in frames] == [["ann", "Jürgen"], ["Jürgen", "7"]]
    assert frames[1].points.tolist() == [[4, 5], [6, 7]] and frames[0].cell is None
    rows = {}
    for frame in track(frames):
        assert frame.triangulation.ids.dtype == np.int64 and frame.ids.dtype.kind == "U"
        for id, point in zip(frame.ids, frame.triangulation.points):
            rows[frame.number, str(id)] = point.tolist()
    assert rows == {(120, "ann"): [0, 1], (120, "Jürgen"): [2, 3], (125, "Jürgen"): [4, 5], (125, "7"): [6, 7]}


def test_frames_unpack_as_pairs_of_ids_and_points_for_a_population(tmp_path):
    population = Population()
    for number, _, ids, points, _ in read(tmp_path, "tracks.csv", "frame,id,x,y\n1,5,0,0\n2,5,1,0\n2,6,1,1\n"):
        population.update(ids, points)
        assert len(population) == number


def test_reads_other_formats_and_gzip(tmp_path):
    xyz = '2\nLattice="5 0 0 0 5 0 0 0 5" Properties=species:S:1:pos:R:3:id:I:1\nO 1 2 0 4\nO 3 4 0 2\n'
    (frame,) = read(tmp_path, "motion.xyz", xyz)
    assert frame.ids.tolist() == [2, 4] and frame.cell.tolist() == [[5, 0], [0, 5]]
    zipped = tmp_path / "tracks.csv.gz"
    zipped.write_bytes(gzip.compress(b"frame,id,x,y\n3,1,0.5,0.25\n"))
    for path in (zipped, str(zipped), str(zipped).encode()):
        (frame,) = read_recording(path)
        assert frame.number == 3 and frame.points.tolist() == [[0.5, 0.25]]


def test_columns_may_be_named(tmp_path):
    path = tmp_path / "odd.csv"
    path.write_text("when,label,across,up\n3,a,1,2\n")
    (frame,) = read_recording(path, "frame=when,id=label,x=across,y=up")
    assert frame.number == 3 and frame.ids.tolist() == ["a"]
    with pytest.raises(errors.RecordingError, match="missing"):
        read_recording(path)
    with pytest.raises(errors.InputValueError):
        read_recording(path, "frame,nonsense")
    with pytest.raises(errors.InputTypeError, match="must be text"):
        read_recording(path, ["frame", "id", "x", "y"])


def test_what_cannot_be_read_is_an_error_with_its_line(tmp_path):
    with pytest.raises(errors.RecordingError, match="line 3: x of id 2 is 'nan'") as refused:
        read(tmp_path, "bad.csv", "frame,id,x,y\n1,1,0,0\n1,2,nan,0\n")
    assert refused.value.line == 3 and isinstance(refused.value, ValueError)
    with pytest.raises(errors.RecordingError):
        read(tmp_path, "empty.csv", "")
    with pytest.raises(errors.RecordingError):
        read_recording(tmp_path)
    with pytest.raises(FileNotFoundError):
        read_recording(tmp_path / "none.csv")
    with pytest.raises(errors.InputTypeError, match="the path is None"):
        read_recording(None)


OPEN = "ff ss fm\n0 10\n0 8\n-1 9"
IN_SPACE = {
    "table.csv": "frame,id,x,y,z\n3,7,1,2,0.5\n3,9,4,5,0\n4,9,1,1,1\n",
    "trackpy.csv": ",y,x,z,mass,size,frame,particle\n0,2,1,0.5,9,1,3.0,7.0\n1,5,4,0,9,1,3.0,9.0\n2,1,1,1,9,1,4.0,9.0\n",
    "trackmate.csv": "LABEL,ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME\n"
                     "Label,Spot ID,Track ID,X,Y,Z,T,F\n"
                     "Label,Spot ID,Track ID,X,Y,Z,T,F\n,,,(micron),(micron),(micron),(sec),\n"
                     "a,55,7,1,2,0.5,0,3\nb,56,9,4,5,0,0,3\nc,57,9,1,1,1,1,4\n",
    "ase.extxyz": '2\nProperties=species:S:1:pos:R:3:id:I:1 Frame=3 pbc="F F F"\nH 1 2 0.5 7\nO 4 5 0 9\n'
                  '1\nProperties=species:S:1:pos:R:3:id:I:1 Frame=4 pbc="F F F"\nO 1 1 1 9\n',
    "lammps.dump": dump_of(3, ["9 1 4 5 0", "7 1 1 2 0.5"], bounds=OPEN) + dump_of(4, ["9 1 1 1 1"], bounds=OPEN),
    "scaled.dump": dump_of(3, ["9 1 .4 .625 .1", "7 1 .1 .25 .15"], bounds=OPEN, columns="id type xs ys zs")
                   + dump_of(4, ["9 1 .1 .125 .2"], bounds=OPEN, columns="id type xs ys zs"),
}


@pytest.mark.parametrize("name", IN_SPACE)
def test_reads_recordings_in_space(tmp_path, name):
    text = IN_SPACE[name]
    first, second = frames = read(tmp_path, name, text)
    assert [frame.number for frame in frames] == [3, 4] and first.cell is second.cell is None
    assert first.ids.tolist() == [7, 9] and second.ids.tolist() == [9]
    assert np.allclose(first.points, [(1, 2, 0.5), (4, 5, 0)], rtol=0, atol=1e-15)
    assert np.allclose(second.points, [(1, 1, 1)], rtol=0, atol=1e-15)
    assert first.points.dtype == np.float64 and not first.points.flags.writeable
    for followed, frame in zip(track(frames), frames):
        assert type(followed.triangulation) is Population3D
        assert followed.number == frame.number and np.array_equal(followed.ids, frame.ids)
        assert np.array_equal(followed.triangulation.points, frame.points)
    flat = read(tmp_path, name, text, dimension=2)
    assert [frame.points.tolist() for frame in flat] == [frame.points[:, :2].tolist() for frame in frames]
    assert all(type(followed.triangulation) is Population for followed in track(flat))
    spatial = read(tmp_path, name, text, dimension=np.int64(3))
    assert all(np.array_equal(a.points, b.points) for a, b in zip(spatial, frames))


def test_is_in_space_if_third_coordinates_differ(tmp_path):
    table = "frame,id,x,y,z\n0,1,1,2,7\n0,2,3,4,7\n1,1,1,2,{}\n"
    for z, columns in (("7", 2), ("7.5", 3), ("nan", 2), ("high", 2), ("", 2)):
        assert read(tmp_path, "table.csv", table.format(z))[0].points.shape == (2, columns)
    assert read(tmp_path, "table.csv", table.format(7), dimension=3)[0].points[:, 2].tolist() == [7, 7]
    xyz = "2\n\nX 1 2\nX 3 4\n"
    assert read(tmp_path, "motion.xyz", xyz)[0].points.shape == (2, 2)
    assert read(tmp_path, "motion.xyz", xyz, dimension=3)[0].points.tolist() == [[1, 2, 0], [3, 4, 0]]


def test_refuses_what_cannot_be_in_space(tmp_path):
    for name, z in (("7", ""), ("7", "nan"), ("7", "high"), ("ann", "inf")):
        text = f"frame,id,x,y,z\n5,4,0,0,1\n5,5,0,0,2\n6,{name},1,2,{z}\n"
        shown = "'ann'" if name == "ann" else name
        wrong = f"is in space, and z of id {shown} in frame 6 is no finite number; dimension=2 takes x and y alone$"
        with pytest.raises(errors.RecordingError, match=wrong):
            read(tmp_path, "table.csv", text)
        assert len(read(tmp_path, "table.csv", text, dimension=2)) == 2
    xyz = '2\npbc="F F T"\nX 1 2 3\nX 1 2 4\n'
    wrong = "in space, and has the frame 0, whose box is periodic along its third side, whose length is 0; dimension=2"
    with pytest.raises(errors.RecordingError, match=wrong) as refused:
        read(tmp_path, "motion.xyz", xyz)
    assert isinstance(refused.value, ValueError) and refused.value.line == 0
    for bounds in ("pp ff ff", "ff pp ff", "ff ff pp"):
        dump = dump_of(5, ["1 1 1 2 3", "2 1 1 2 4"], bounds=f"{bounds}\n0 10\n0 8\n0 8")
        (wire,) = read(tmp_path, "motion.dump", dump)
        assert wire.cell.tolist() == [[(10, 8, 8)[i] if name == "pp" else 0 for i, name in enumerate(bounds.split())]]
        (flat,) = read(tmp_path, "motion.dump", dump, dimension=2)
        assert (flat.cell is not None) == ("pp" in bounds[:5]) and flat.points.tolist() == [[1, 2], [1, 2]]
    for wrong, kind in ((4, errors.InputValueError), (0, errors.InputValueError), ("2", errors.InputTypeError),
                        (2.0, errors.InputTypeError)):
        with pytest.raises(kind, match="the dimension is .*: it must be"):
            read(tmp_path, "table.csv", IN_SPACE["table.csv"], dimension=wrong)


def test_follows_frames_in_space_of_any_size(tmp_path):
    random = np.random.default_rng(1)
    dump, frames = "", [random.random((n, 3)) for n in (0, 1, 3, 60, 2, 0, 30)]
    for step, points in enumerate(frames):
        dump += dump_of(step, [f"{i + step} 1 {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(points.tolist())],
                        bounds=OPEN)
    followed = track(read(tmp_path, "motion.lammpstrj", dump))
    for frame, points in zip(followed, frames):
        crowd = frame.triangulation
        assert crowd.is_certified and crowd.is_valid() and np.array_equal(crowd.points[np.argsort(crowd.ids)], points)
        if len(points) > 4:
            assert {frozenset(s) for s in crowd.simplices.tolist()} \
                == {frozenset(s) for s in Delaunay(crowd.points).simplices.tolist()}
    assert next(followed, None) is None
    only_empty = track(read(tmp_path, "motion.lammpstrj", dump_of(0, [], bounds=OPEN), dimension=3))
    assert [type(frame.triangulation) for frame in only_empty] == [Population3D]


TITLES = [
    ("frame", "id", "x", "y"),
    ("frame", "particle", "x", "y"),  # trackpy
    ("FRAME", "TRACK_ID", "POSITION_X", "POSITION_Y"),  # TrackMate
    ("Frame", "ID", "X/m", "Y/m"),  # JuPedSim
    ("FR", "PersID", "x", "y"),  # PeTrack
]


@pytest.mark.parametrize("titles", TITLES)
def test_tables_have_the_names_that_files_have(tmp_path, titles):
    pandas = pytest.importorskip("pandas")
    rows = [(4, 11, 0.5, 1.5), (4, 12, 2.5, 3.5), (9, 12, 2.75, 3.75)]
    table = pandas.DataFrame(rows, columns=titles)
    table["mass"] = 1.0
    for shuffled in (table, table[table.columns[::-1]]):
        frames = [(f.number, f.ids.tolist(), f.triangulation.points.tolist()) for f in track(shuffled)]
        assert frames == [(4, [11, 12], [[0.5, 1.5], [2.5, 3.5]]), (9, [12], [[2.75, 3.75]])]
    table.to_csv(tmp_path / "table.csv", index=False)
    read = [(f.number, f.ids.tolist(), f.points.tolist()) for f in read_recording(tmp_path / "table.csv")]
    assert read == frames


def test_tables_are_in_space_if_third_coordinates_differ():
    pandas = pytest.importorskip("pandas")
    rows = [(0, 3, 1.0, 2.0, 0.5), (0, 4, 3.0, 4.0, 0.0), (1, 4, 5.0, 6.0, 1.0)]
    table = pandas.DataFrame(rows, columns=["frame", "particle", "x", "y", "z"])
    frames = [(f.number, f.ids.tolist(), f.triangulation.points.tolist()) for f in track(table.iloc[[2, 0, 1]], threads=1)]
    assert frames == [(0, [3, 4], [[1, 2, 0.5], [3, 4, 0]]), (1, [4], [[5, 6, 1]])]
    for flat in (table.drop(columns="z"), table.assign(z=7), table.assign(z="high"), table.assign(z=np.nan)):
        assert [type(frame.triangulation) for frame in track(flat)] == [Population, Population]
    unknown = table.astype({"z": object})
    unknown.loc[2, "z"] = "high"
    with pytest.raises(errors.NonFiniteCoordinateError, match="^frame 1, id 4: point 0 has the coordinates"):
        list(track(unknown))
    with pytest.raises(errors.PeriodicCellError, match=r"^frame 0: a cell of points in space has the shape \(2,\)"):
        list(track(table, (9, 9)))
    assert [len(frame.ids) for frame in track(table, (9, 9, 9))] == [2, 1]


def test_tables_of_trackmate_have_spots_with_ids_of_their_own():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"LABEL": ["s1", "s2"], "ID": [900, 901], "TRACK_ID": [3, 4], "POSITION_X": [0.0, 1.0],
                              "POSITION_Y": [2.0, 3.0], "POSITION_T": [0.5, 0.5], "FRAME": [1, 1]})
    (frame,) = track(table)
    assert frame.ids.tolist() == [3, 4] and frame.number == 1
    units = pandas.concat([pandas.DataFrame([["Frame"] * 7], columns=table.columns), table])
    with pytest.raises(errors.InputValueError, match=r"no numbers: .* skiprows=\[1, 2, 3\]"):
        list(track(units))


def test_tables_that_cannot_be_told_say_what_is_known():
    pandas = pytest.importorskip("pandas")
    for titles in (["frame", "y"], ["a", "b"], ['quoted "x"', "frame\tid"]):
        with pytest.raises(errors.RecordingError, match="the table: .*missing"):
            list(track(pandas.DataFrame([range(len(titles))], columns=titles)))
    table = pandas.DataFrame({"frame": [1, np.nan], "id": [1, 2], "x": [0.0, 1.0], "y": [0.0, 1.0]})
    with pytest.raises(errors.InputValueError, match="row 1 of the table has no frame"):
        list(track(table))


def test_example_for_lammps_reads_every_box(tmp_path):
    import test_examples

    path = pathlib.Path(tmp_path / "motion.lammpstrj")
    path.write_text(dump_of(7, [], bounds="ff ff pp\n0 10\n0 8\n-0.5 0.5") +
                    dump_of(8, ["1 1 0 0 0", "2 1 1 0 0"], bounds="ff ff pp\n0 10\n0 8\n-0.5 0.5") + "\n")
    lines = test_examples.output_of("lammps_neighbors", path).splitlines()
    assert lines[0].startswith("step 7: 0 atoms") and lines[1].startswith("step 8: 2 atoms")
    assert lines[2:] == ["1 2", "2 1"]
