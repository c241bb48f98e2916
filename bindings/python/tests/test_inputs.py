# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

import copy
import inspect
import pickle

import numpy as np
import pytest

from dynamic_delaunay import DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population, errors, track

POINTS = np.random.default_rng(1).random((60, 2))
IN_SPACE = np.column_stack([POINTS, POINTS[::-1, 0]])
OTHERS = np.random.default_rng(2).random((60, 2))


def unaligned(points):
    data = bytearray(1) + points.tobytes()
    return np.frombuffer(data, dtype=np.uint8)[1:].view(np.float64).reshape(points.shape)


def read_only(points):
    points = points.copy()
    points.flags.writeable = False
    return points


@pytest.mark.parametrize(
    "arranged",
    [
        np.asfortranarray,
        lambda points: np.repeat(points, 3, axis=0)[::3],
        lambda points: np.ascontiguousarray(points[::-1])[::-1],
        lambda points: np.ascontiguousarray(points[:, ::-1])[:, ::-1],
        lambda points: np.column_stack([points, points, points])[:, ::5][:, [0, 1]] * 0 + points,
        lambda points: np.column_stack([np.zeros(60), points[:, 0], np.zeros(60), points[:, 1]])[:, 1::2],
        unaligned,
        read_only,
        lambda points: points.astype(">f8"),
        lambda points: points.tolist(),
        lambda points: points.astype(np.longdouble),
        lambda points: points.view(type("Kind", (np.ndarray,), {})),
        lambda points: [tuple(point) for point in points],
    ],
)
def test_reads_numbers_wherever_they_are(arranged):
    points = arranged(POINTS)
    for triangulation in (DynamicDelaunay(points), Population(np.arange(60), points), PeriodicDelaunay(points, (2, 2))):
        assert np.array_equal(triangulation.points, POINTS)
    dt = DynamicDelaunay(POINTS * 2)
    dt.update(points)
    assert np.array_equal(dt.points, POINTS)


@pytest.mark.parametrize("type", [np.float32, np.float16, np.int32, np.uint8])
def test_converts_other_numbers(type):
    points = (POINTS * 100).astype(type)
    assert np.array_equal(DynamicDelaunay(points).points, points.astype(np.float64))


def test_reads_files_that_are_mapped_into_memory(tmp_path):
    points = np.memmap(tmp_path / "points", dtype=np.float64, mode="w+", shape=(60, 2))
    points[:] = POINTS
    dt = DynamicDelaunay(np.memmap(tmp_path / "points", dtype=np.float64, mode="r", shape=(60, 2)))
    dt.update(points)
    assert np.array_equal(dt.points, POINTS)


def test_reads_tables():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(POINTS, columns=["x", "y"])
    assert np.array_equal(Population(pandas.Series(range(60)), table).points, POINTS)


@pytest.mark.parametrize("factor", [1e300, 1e150, 1e-300])
def test_takes_huge_and_tiny_numbers(factor):
    dt = DynamicDelaunay(POINTS * factor)
    dt.update(OTHERS * factor)
    assert dt.is_valid() and np.array_equal(dt.points, OTHERS * factor)


def test_reads_a_frame_in_place_without_copying_it():
    points = np.random.default_rng(1).random((200_000, 4))[:, ::3]
    dt = DynamicDelaunay(points)
    dt.update(points)
    import tracemalloc

    tracemalloc.start()
    dt.update(points)
    assert tracemalloc.get_traced_memory()[1] < 10_000  # NumPy tells it of its arrays
    tracemalloc.stop()


@pytest.mark.parametrize("points", [np.zeros(3), np.zeros((3, 4)), np.zeros((2, 2, 2)), 1.0, np.zeros((5, 1))])
def test_refuses_other_shapes(points):
    for refuse in (DynamicDelaunay, DynamicDelaunay(POINTS).update, DynamicDelaunay().insert):
        with pytest.raises(ValueError, match=r"shape .*: it must be \(n, 2\)"):
            refuse(points)


@pytest.mark.parametrize(
    "points", ["points", [("a", "b")], np.zeros((3, 2), complex), np.ones((3, 2), bool), None, [{}]]
)
def test_refuses_what_is_no_number(points):
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(TypeError, match="points "):
        dt.update(points)
    assert np.array_equal(dt.points, POINTS)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_refuses_numbers_that_are_not_finite(bad):
    dt = DynamicDelaunay(POINTS)
    points = POINTS.copy()
    points[17, 1] = bad
    edges = dt.edges.copy()
    with pytest.raises(errors.NonFiniteCoordinateError, match="point 17 has the coordinates") as refused:
        dt.update(points)
    assert refused.value.id == 17 and refused.value.x == POINTS[17, 0]
    assert isinstance(refused.value, ValueError)
    assert np.array_equal(dt.points, POINTS) and np.array_equal(dt.edges, edges) and dt.is_certified


def test_refuses_frames_of_another_length():
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(errors.PointCountError) as refused:
        dt.update(POINTS[:50])
    assert (refused.value.expected, refused.value.given) == (60, 50)
    with pytest.raises(errors.PointCountError):
        dt.update(np.concatenate([POINTS, POINTS]))


@pytest.mark.parametrize("id", [60, 10**12, -1, -(2**63)])
def test_refuses_unknown_ids(id):
    dt = DynamicDelaunay(POINTS)
    for refuse in (dt.remove, lambda ids: dt.move(ids, (0, 0)), dt.voronoi_cell):
        with pytest.raises(errors.UnknownIdError, match="there is no point with id") as refused:
            refuse(id)
        if id >= 0:
            assert refused.value.id == id
    assert id not in dt and 10**30 not in dt


@pytest.mark.parametrize("ids", [[1.5], ["1"], [True], [None]])
def test_refuses_ids_that_are_no_integers(ids):
    with pytest.raises(TypeError, match="integers are needed"):
        DynamicDelaunay(POINTS).remove(ids)


@pytest.mark.parametrize(
    "setting, error, message",
    [
        ({"threads": -1}, ValueError, "threads is -1: it must be from 0"),
        ({"threads": "two"}, TypeError, "threads is 'two': it must be an integer"),
        ({"threads": 10**6}, ValueError, "the number of threads is 1000000, allowed are at most 1024"),
        ({"seed": 1.5}, TypeError, "seed is 1.5: it must be an integer"),
        ({"seed": 2**64}, ValueError, "seed is 18446744073709551616: it must be from 0"),
        ({"policy": None}, TypeError, "the policy is None: it must be a name"),
        ({"repair": 3}, TypeError, "the repair is 3: it must be a name or None"),
        ({"changes": "no"}, TypeError, "changes is 'no': it must be True or False"),
        ({"clasifier": "random"}, TypeError, "unexpected keyword argument 'clasifier'"),
    ],
)
@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay, Population, PeriodicPopulation])
def test_refuses_settings_that_make_no_sense(kind, setting, error, message):
    with pytest.raises(error, match=message):
        kind(**setting)


def test_takes_all_threads_of_the_machine():
    dt = DynamicDelaunay(POINTS, threads=0)
    assert dt.update(OTHERS).certified


@pytest.mark.parametrize("kind", [Population, PeriodicPopulation])
def test_takes_ids_and_points_together(kind):
    with pytest.raises(TypeError, match="there are no points"):
        kind([1, 2])
    with pytest.raises(TypeError, match="there are no ids"):
        kind(points=POINTS)


def test_says_what_is_no_id():
    dt = DynamicDelaunay(POINTS)
    for other in ("a", 1.0, None, 2**70, -1, 60):
        assert other not in dt
    assert np.int64(4) in dt
    with pytest.raises(errors.UnknownIdError, match="ids have 64 bits"):
        dt.voronoi_cell(2**70)
    with pytest.raises(TypeError, match="integer"):
        dt.voronoi_cell(1.5)
    population = Population([5, 7], [(0, 0), (1, 1)])
    with pytest.raises(errors.RepeatedIdError) as refused:
        population.move([7, 7], [(0, 0), (2, 2)])
    assert refused.value.id == 7


def test_refuses_what_is_no_box_or_checkpoint():
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(ValueError, match=r"it must be \(4,\), for xmin"):
        dt.clipped_cells((0, 0, 1))
    with pytest.raises(TypeError, match="bytes-like"):
        dt.restore("text")
    with pytest.raises(errors.CheckpointError, match="line 1"):
        dt.restore(PeriodicDelaunay(POINTS).checkpoint())
    assert np.array_equal(dt.points, POINTS)


@pytest.mark.parametrize(
    "wrong, kind",
    [
        (lambda dt: dt.update(np.zeros((3, 3))), ValueError),
        (lambda dt: dt.update("points"), TypeError),
        (lambda dt: dt.insert([[0, 1], [2]]), TypeError),
        (lambda dt: dt.remove([1.5]), TypeError),
        (lambda dt: dt.remove([[1], [2, 3]]), TypeError),
        (lambda dt: dt.move([[1]], (0, 0)), ValueError),
        (lambda dt: dt.find_simplex(np.zeros(3)), ValueError),
        (lambda dt: dt.clipped_cells((0, 0, 1)), ValueError),
        (lambda dt: dt.clipped_cells("box!"), ValueError),
        (lambda dt: dt.clipped_cells(({}, 0, 1, 1)), TypeError),
        (lambda dt: dt.bounded_cells("far"), ValueError),
        (lambda dt: dt.bounded_cells({}), TypeError),
        (lambda dt: dt.bounded_cells([[1], [2, 3]]), ValueError),
        (lambda dt: dt.bounded_cells(1, "room"), TypeError),
        (lambda dt: dt.voronoi_cell("1"), TypeError),
        (lambda dt: dt.neighbors_of(60), IndexError),
        (lambda dt: dt.neighbors_of(1.5), TypeError),
        (lambda dt: dt.created_edges, ValueError),
        (lambda dt: dt.restore("text"), TypeError),
        (lambda dt: dt.__init__(), RuntimeError),
        (lambda dt: DynamicDelaunay(classifier="best"), ValueError),
        (lambda dt: DynamicDelaunay(classifier=3), TypeError),
        (lambda dt: DynamicDelaunay(threads=10**6), ValueError),
        (lambda dt: PeriodicDelaunay(POINTS, cell="square"), ValueError),
        (lambda dt: PeriodicDelaunay(POINTS, cell=(1, None, {})), TypeError),
        (lambda dt: Population([1, 2], [(0, 0)]), ValueError),
        (lambda dt: Population([1, 2]), TypeError),
        (lambda dt: Population([1], [(0, 0)]).insert([1, 2], POINTS[:2]), ValueError),
        (lambda dt: list(track(pandas_without("id"))), ValueError),
    ],
)
def test_every_refusal_is_an_error_of_the_package_and_one_of_python(wrong, kind):
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(errors.DynamicDelaunayError) as refused:
        wrong(dt)
    assert isinstance(refused.value, kind) and type(refused.value).__module__ == "dynamic_delaunay.errors"
    assert np.array_equal(dt.points, POINTS)


def pandas_without(column):
    return pytest.importorskip("pandas").DataFrame(np.zeros((3, 4)), columns=["frame", "id", "x", "y"]).drop(columns=column)


def test_errors_about_positions_of_a_population_have_places_in_the_call():
    population = PeriodicPopulation([1, 2, 3], POINTS[:3], (1, 1))
    with pytest.raises(errors.PeriodicRangeError, match="point 0 ") as refused:
        population.update([3, 1], [(2e6, 0), (0, 0)])
    assert refused.value.id == 0
    with pytest.raises(errors.PeriodicRangeError) as refused:
        population.move([2, 3], [(0, 0), (2e6, 0)])
    assert refused.value.id == 1
    with pytest.raises(errors.NonFiniteCoordinateError) as refused:
        population.insert(4, (np.nan, 0))
    assert refused.value.id == 0
    assert np.array_equal(population.points, POINTS[:3])


@pytest.mark.parametrize(
    "triangulation",
    [DynamicDelaunay(POINTS), PeriodicDelaunay(POINTS), Population(range(60), POINTS),
     PeriodicPopulation(range(60), POINTS), DynamicDelaunay(IN_SPACE), Population(range(60), IN_SPACE)],
    ids=lambda triangulation: type(triangulation).__name__,
)
def test_refuses_what_follows_a_checkpoint(triangulation, tmp_path):
    points = triangulation.points
    checkpoint = triangulation.checkpoint()
    lines = checkpoint.count(b"\n")
    other = type(triangulation)()
    for more in (b"zz", b"\n", b"\0", checkpoint):
        with pytest.raises(errors.CheckpointError, match="more after the end") as refused:
            other.restore(checkpoint + more)
        assert refused.value.line == lines + 1 and len(other) == 0
    (tmp_path / "file").write_bytes(checkpoint + b" ")
    with pytest.raises(errors.CheckpointError, match="more after the end"):
        other.load(tmp_path / "file")
    other.restore(checkpoint)
    assert np.array_equal(other.points, points)


class Unprepared(DynamicDelaunay):
    def __init__(self):
        pass


def test_objects_are_initialized_once():
    for unprepared in (Unprepared(), DynamicDelaunay.__new__(DynamicDelaunay)):
        for use in (
            lambda: unprepared.edges,
            lambda: unprepared.update(POINTS),
            lambda: len(unprepared),
            lambda: unprepared.bounded_cells(1),
            lambda: pickle.dumps(unprepared),
            lambda: copy.copy(unprepared),
        ):
            with pytest.raises(errors.UseError, match="was not called"):
                use()
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(RuntimeError, match="initialized once"):
        dt.__init__(OTHERS)
    assert np.array_equal(dt.points, POINTS)


def test_refuses_masked_points():
    with pytest.raises(TypeError, match="mask would be lost"):
        DynamicDelaunay(np.ma.masked_array(POINTS, POINTS > 0.5))


def test_refuses_ids_that_do_not_fit():
    with pytest.raises(ValueError, match="smaller than 2"):
        Population(np.array([2**63], np.uint64), [(0, 0)])
    assert Population(np.array([2**63 - 1], np.uint64), [(0, 0)]).ids[0] == 2**63 - 1
    with pytest.raises(ValueError, match="there must be as many"):
        Population([1, 2], [(0, 0)])
    with pytest.raises(ValueError, match="shape"):
        Population([[1]], [(0, 0)])


def test_takes_ids_that_are_whole_numbers_as_floats():
    population = Population(np.array([3.0, -7.0, 2.0**53]), OTHERS[:3])
    assert population.ids.tolist() == [3, -7, 2**53]
    population.update([-7.0, 3.0], OTHERS[:2])
    population.move([3.0], [(2, 2)])
    population.remove(-7.0)
    assert population.ids.tolist() == [3] and population.points.tolist() == [[2, 2]]
    for bad, text in ((1.5, "1.5"), (np.nan, "nan"), (np.inf, "inf"), (2.0**54, r"1.8\d*e\+16")):
        with pytest.raises(TypeError, match=f"ids are real numbers, of which number 1 is {text}: integers are needed"):
            population.update([3.0, bad], OTHERS[:2])
    assert population.ids.tolist() == [3]
    for ids in ([], np.empty(0)):
        population.update(ids, np.empty((0, 2)))


@pytest.mark.parametrize("box", [(0, 1, 0, 1), (0, 0, 0, 1), (1, 0, 0, 1), (0, 0, np.nan, 1), (0, 0, np.inf, 1)])
def test_a_box_that_is_empty_or_in_another_order_is_refused(box):
    with pytest.raises(errors.InputValueError, match="xmin, ymin, xmax and ymax, in this order"):
        DynamicDelaunay(POINTS).clipped_cells(box)


@pytest.mark.parametrize("kind", [DynamicDelaunay, PeriodicDelaunay, Population, PeriodicPopulation])
def test_attributes_that_an_object_cannot_have_are_not_there(kind):
    ids = [] if kind in (DynamicDelaunay, PeriodicDelaunay) else [np.arange(60)]
    triangulation = kind(*ids, POINTS, classifier="point_distance:0.1")
    assert not hasattr(triangulation, "created_edges") and hasattr(triangulation, "areas")
    triangulation.update(*ids, 1.001 * POINTS)
    assert not triangulation.is_certified and not hasattr(triangulation, "areas")
    names = {name for name, _ in inspect.getmembers(triangulation)}
    assert "edges" in names and not names & {"created_edges", "removed_edges", "areas", "ridges"}
    recorded = kind(*ids, POINTS, changes=True)
    assert {"created_edges", "removed_edges", "areas"} <= {name for name, _ in inspect.getmembers(recorded)}
    assert not hasattr(kind.__new__(kind), "edges")
    with pytest.raises(errors.NotRecordedError, match=rf"{kind.__name__}\(..., changes=True\)"):
        triangulation.removed_edges


def test_load_by_the_class_says_how_it_is_called(tmp_path):
    DynamicDelaunay(POINTS).save(tmp_path / "file")
    for call in (lambda: DynamicDelaunay.load(tmp_path / "file"), lambda: DynamicDelaunay().load()):
        with pytest.raises(errors.InputTypeError, match=r"load\(\) is called by a triangulation, .* dt.load\(...\)"):
            call()
    with pytest.raises(errors.InputTypeError, match=r"restore\(\) is called by a triangulation"):
        DynamicDelaunay.restore(DynamicDelaunay(POINTS).checkpoint())
    dt = DynamicDelaunay()
    dt.load(tmp_path / "file")
    assert np.array_equal(dt.points, POINTS)


def test_says_which_areas_are_infinite():
    points = [(0, 0), (4, 0), (4, 4), (0, 4), (2, 2)]
    assert np.isinf(DynamicDelaunay(points).areas).tolist() == [True] * 4 + [False]
    assert np.isinf(DynamicDelaunay([(0, 0), (1, 0), (2, 0)]).areas).all()
    assert np.isfinite(PeriodicDelaunay(points, (5, 5)).areas).all()
    assert np.isinf(PeriodicDelaunay(points, [(5, 0)]).areas).tolist() == [True] * 4 + [False]


def test_refuses_an_id_that_is_given_twice():
    dt = DynamicDelaunay(POINTS)
    with pytest.raises(errors.RepeatedIdError) as refused:
        dt.remove([3, 4, 3])
    assert refused.value.id == 3 and len(dt) == 60


def test_arrays_stay_as_they_were_and_say_so():
    dt = DynamicDelaunay(POINTS, changes=True)
    names = ["edges", "triangles", "neighbors", "indptr", "indices", "points", "ids", "duplicates", "areas"]
    names += ["perimeters", "centroids", "shape_indices", "created_edges", "removed_edges"]
    old = {name: getattr(dt, name) for name in names}
    copies = {name: array.copy() for name, array in old.items()}
    for name, array in old.items():
        assert getattr(dt, name) is array and dt.is_current(array)
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    with pytest.raises(errors.NonFiniteCoordinateError):
        dt.update(POINTS * np.nan)
    dt.update(np.random.default_rng(9).random((60, 2)))
    for name, array in old.items():
        assert not dt.is_current(array)
        assert np.array_equal(array, copies[name])
        assert getattr(dt, name) is not array and dt.is_current(getattr(dt, name))
    del dt
    assert np.array_equal(old["edges"], copies["edges"])


def resident_kilobytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4


def test_leaks_nothing_over_ten_thousand_objects():
    def use():
        dt = DynamicDelaunay(POINTS, changes=True)
        dt.update(POINTS + OTHERS * 0.05)
        population = Population(np.arange(60), POINTS, classifier=lambda frame: frame.ids[1:3])
        population.update(np.arange(1, 61), POINTS)
        periodic = PeriodicDelaunay(POINTS, (1, 1))
        for array in (dt.triangles, dt.areas, dt.created_edges, population.edges, periodic.indices):
            assert len(array)
        with pytest.raises(errors.PointCountError):
            dt.update(POINTS[1:])

    for _ in range(500):
        use()
    before = resident_kilobytes()
    for _ in range(10_000):
        use()
    assert resident_kilobytes() - before < 4000  # less than half a byte for each number of one object
