"""Lists and NumPy arrays give the same map, to the last bit."""

import subprocess
import sys
from pathlib import Path

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mapping import arrays, frontiers
from mapping.arrays import ArrayMapper
from mapping.beam import Weights
from mapping.grid import Grid
from mapping.mapper import Mapper

poses = st.tuples(st.floats(0, 200), st.floats(0, 200), st.floats(0, 360))
scans = st.lists(st.tuples(st.floats(-30, 30), st.floats(0, 200)), max_size=8)
drives = st.lists(st.tuples(poses, scans), max_size=5)


@given(drives, st.sampled_from([5, 8, 20, 30, 67]), st.floats(0.5, 10))
def test_the_same_drive_gives_the_same_grid(drive, cell_cm, l_max):
    weights = Weights(l_max=l_max)
    lists, array = Mapper(cell_cm, weights), ArrayMapper(cell_cm, weights)
    for pose, scan in drive:
        lists.add_scan(*pose, scan)
        array.add_scan(*pose, scan)
    assert array.cells.ravel().tolist() == lists.grid.cells


@given(st.integers(1, 8), st.data())
def test_the_same_grid_gives_the_same_states_and_frontier(across, data):
    grid = Grid(200 / across)
    odds = data.draw(st.lists(st.floats(-8, 8), min_size=across**2, max_size=across**2))
    states = frontiers.known_states(odds)
    array = arrays.three_states(np.array(odds).reshape(across, across), -1, 1)
    assert array.ravel().tolist() == states
    mask = arrays.frontier_mask(array)
    assert set(np.flatnonzero(mask).tolist()) == frontiers.frontier_cells(grid, states)


def test_row_0_is_at_the_bottom_of_the_mat():
    mapper = ArrayMapper(100)
    mapper.add_beam(50, 50, 0, 110)
    assert mapper.cells.tolist() == [[0, 0], [0.85, 0]]


def test_the_rest_of_the_package_needs_no_numpy():
    modules = ["grid", "log_odds", "beam", "mapper", "frontiers", "score"]
    program = (
        "import sys; sys.modules['numpy'] = None\n"  # makes every import of it fail
        + "".join(f"import mapping.{each}\n" for each in modules)
    )
    source = Path(__file__).parents[3] / "py"
    subprocess.run([sys.executable, "-c", program], check=True, cwd=source)
