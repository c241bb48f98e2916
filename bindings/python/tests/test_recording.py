# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of recorded motion, and tables by the column names of several programs."""

import gzip
import pathlib

import numpy as np
import pytest

from dynamic_delaunay import PeriodicPopulation, Population, errors, read_recording, track


def dump_of(step, rows, *, bounds="pp pp pp\n0 10\n0 8\n-0.5 0.5", columns="id type x y z", before=""):
    lines = "".join(f"{row}\n" for row in rows)
    return (f"{before}ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS {bounds}\n"
            f"ITEM: ATOMS {columns}\n{lines}")


def read(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text)
    return read_recording(path)


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
