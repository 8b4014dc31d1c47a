"""The article's four demos come out as the article says, and are what they claim to be."""

from __future__ import annotations

import ast
import itertools
import math
import re
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest
from programs import DEMOS, drawn_map, obstacles_of, run, score_of, value_at

from bugbot import worlds
from mapping.beam import bresenham
from mapping.frontiers import known_states, regions, states_by_probability
from mapping.log_odds import log_odds
from mapping.mapper import Mapper

WORLDS = {
    "demo-1-from-one-spot": "post-and-shelf",
    "demo-2-adding-up-evidence": "wall-ahead",
    "demo-3-wrong-pose": "post-and-shelf",
    "demo-4-frontiers": "doorway",
}
SEEDS = range(1, 9)


def demo(number: int, seed: int = 1, **numbers: object) -> tuple[Any, dict[str, Any]]:
    name = next(each for each in WORLDS if each.startswith(f"demo-{number}-"))
    return run(DEMOS / f"{name}.py", WORLDS[name], seed, **numbers)


# -- the figures -----------------------------------------------------------------


def chart(line: str, seconds: float) -> Callable[[dict[str, Any]], float]:
    return lambda outcome: value_at(outcome, line, seconds)


def cells(layer: str) -> Callable[[dict[str, Any]], float]:
    return lambda outcome: len(outcome["layers"][layer]["points"])


def when(line: str, holds: Callable[[float], bool]) -> Callable[[dict[str, Any]], float]:
    """The first time [s] at which a line of the chart fulfils a condition; never is infinite."""
    return lambda outcome: next(
        (t for t, value in outcome["series"][line] if holds(value)), float("inf")
    )


class Figure(NamedTuple):
    """One figure: where to read it, and from what to what it may be, on seed 1 and on any."""

    demo: int
    label: str
    read: Callable[[dict[str, Any]], float]
    seed_1: tuple[float, float]
    any_seed: tuple[float, float]


def about(wanted: float, per_cent: float) -> tuple[float, float]:
    return wanted * (1 - per_cent / 100), wanted * (1 + per_cent / 100)


# Within 5 % of each figure; the occupied cells, which noise moves most, within 15 %. Which cells
# are wrong walls hangs on single readings: on other seeds than 1 the share at the end
# is 46 to 53 %, and while it climbs steeply (from 10 to 30 % between 5 and 6 s) it
# differs by up to half from seed to seed.
FIGURES = [
    Figure(1, "known % at 3 s", chart("known %", 3), about(12, 5), about(12, 5)),
    Figure(1, "known % at 8.5 s", chart("known %", 8.5), about(62, 5), about(62, 5)),
    Figure(1, "known % at the end", chart("known %", 13), about(63.5, 5), about(63.5, 5)),
    Figure(1, "free cells", cells("free"), about(901, 5), about(901, 5)),
    Figure(1, "occupied cells", cells("occupied"), about(115, 15), about(115, 15)),
    Figure(1, "wrong walls %", chart("wrong walls %", 13), (0, 0), (0, 0)),
    Figure(2, "floor at -8 [s]", when("floor", lambda value: value <= -8), (0.9, 0.9), (0.9, 0.9)),
    Figure(2, "wall at +8 [s]", when("wall", lambda value: value >= 8), (2, 4), (2, 4.5)),
    Figure(2, "in front at the end", chart("in front", 10), (7, 8), (7, 8)),
    Figure(3, "wrong walls % at 2 s", chart("wrong walls %", 2), (0, 3), (0, 8)),
    Figure(3, "wrong walls % at 5.5 s", chart("wrong walls %", 5.5), about(20, 10), (10, 30)),
    Figure(3, "wrong walls % at the end", chart("wrong walls %", 13), about(46, 5), (43.7, 54)),
    Figure(3, "known % at the end", chart("known %", 13), about(69.5, 5), about(69.5, 5)),
    Figure(4, "known % after the sweep", chart("known %", 10), about(66, 5), about(66, 5)),
    Figure(4, "known % at the end", chart("known %", 99), about(98.4, 5), (97, 100)),
]


@pytest.mark.parametrize("number", [1, 2, 3, 4])
def test_the_figures(number):
    rows, wrong = [], 0
    for figure in FIGURES:
        if figure.demo != number:
            continue
        found = [figure.read(demo(number, seed)[1]) for seed in SEEDS]
        first, rest = figure.seed_1, figure.any_seed
        sound = first[0] <= found[0] <= first[1]
        sound = sound and rest[0] <= min(found) and max(found) <= rest[1]
        wrong += not sound
        rows.append(
            f"{' ' if sound else '!'} {figure.label:26} seed 1: {found[0]:8.2f} "
            f"({first[0]:.2f} to {first[1]:.2f})   seeds {SEEDS[0]} to {SEEDS[-1]}: "
            f"{min(found):8.2f} to {max(found):8.2f} ({rest[0]:.2f} to {rest[1]:.2f})"
        )
    assert not wrong, f"demo {number}: {wrong} of {len(rows)} figures are off\n" + "\n".join(rows)


def test_demo_2_the_floor_falls_by_two_steps_a_look_and_nothing_is_said_of_what_is_behind():
    series = demo(2)[1]["series"]
    floor = [value for _, value in series["floor"]]
    assert floor[:9] == pytest.approx([-0.8 * look for look in range(1, 10)])
    assert {value for _, value in series["behind"]} == {0.0}


@pytest.mark.parametrize("seed", SEEDS)
def test_demo_4_goes_through_the_doorway_and_leaves_no_region_to_explore(seed):
    _, outcome = demo(4, seed)
    ((x, y),) = outcome["layers"]["goal"]["points"]
    assert 90 < x < 110
    assert y > 128
    assert (outcome["pose"]["x"], outcome["pose"]["y"]) == pytest.approx((x, y), abs=1)
    grid, _ = drawn_map(outcome)
    frontier = [grid.index_at(*point) for point in outcome["layers"]["frontier"]["points"]]
    assert len(frontier) == outcome["series"]["frontier cells"][-1][1]
    largest = len(regions(grid, frontier)[0])
    # Gaps that noise leaves in a wall now and then line up to five; on seed 7 they do.
    assert largest < 5 if seed == 1 else largest <= 5


# -- the programs do what the reference mapper does ----------------------------------


@pytest.mark.parametrize(("number", "drift_deg_s"), [(1, 0), (2, 0), (3, 3), (4, 0)])
def test_the_map_is_the_reference_mappers_map_of_the_same_scans(number, drift_deg_s):
    trace, outcome = demo(number)
    mapper = Mapper()
    for look in trace.of_kind("scan"):
        beams = zip(look["beams"][::2], look["beams"][1::2], strict=True)
        mapper.add_scan(look["x"], look["y"], look["heading"] + drift_deg_s * look["t"], beams)
    read = states_by_probability if number == 4 else known_states
    assert drawn_map(outcome)[1] == read(mapper.grid.cells)


@pytest.mark.parametrize("number", [1, 3, 4])
def test_the_chart_shows_the_score_of_the_map(number):
    outcome = demo(number)[1]
    result = score_of(outcome, "doorway" if number == 4 else "post-and-shelf")
    last = {line: points[-1][1] for line, points in outcome["series"].items()}
    assert last["known %"] == pytest.approx(result.known_percent)
    if number != 4:
        assert last["wrong walls %"] == pytest.approx(result.wrong_walls_percent)


# -- the experiments -------------------------------------------------------------


def test_without_evidence_for_free_cells_only_walls_are_known():
    outcome = demo(1, L_FREE=0)[1]
    assert outcome["layers"]["free"]["points"] == []
    assert outcome["layers"]["occupied"]["points"]


def test_large_cells_make_a_coarse_map():
    grid, _ = drawn_map(demo(1, CELL=20)[1])
    assert len(grid.cells) == 100


def test_without_a_clamp_the_sums_run_on():
    series = demo(2, L_MAX=100)[1]["series"]
    assert series["floor"][-1][1] < -50
    assert series["wall"][-1][1] > 20


def test_passes_that_weigh_as_much_as_hits_clear_the_floor_in_half_the_time():
    at_the_clamp = when("floor", lambda value: value <= -8)
    assert at_the_clamp(demo(2)[1]) == 0.9  # the tenth look
    assert at_the_clamp(demo(2, L_FREE=-0.85)[1]) == 0.4  # the fifth


def test_less_drift_makes_fewer_wrong_walls():
    wrong = [value_at(demo(3, DRIFT=drift)[1], "wrong walls %", 13) for drift in (3, 1, 0.2)]
    assert wrong[0] > wrong[1] > wrong[2]
    assert wrong[2] < 2


@pytest.mark.parametrize("experiment", [{"MIN_REGION": 1}, {"OCC_P": 0.95}])
def test_other_frontiers_lead_elsewhere(experiment):
    outcome = demo(4, **experiment)[1]
    assert outcome["status"] == "finished"
    assert outcome["layers"]["goal"]["points"] != demo(4)[1]["layers"]["goal"]["points"]


# -- the texts -------------------------------------------------------------------


def constants(name: str) -> dict[str, Any]:
    """The values that a demo gives its names in capitals, where they are plain to see."""
    found: dict[str, Any] = {}
    for node in ast.parse((DEMOS / f"{name}.py").read_text("utf-8")).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            try:
                found[node.targets[0].id] = ast.literal_eval(node.value)
            except ValueError:
                continue
    return found


@pytest.mark.parametrize("name", WORLDS)
def test_what_a_demo_says_about_its_world_is_so(name):
    world = worlds.load(WORLDS[name])
    said = constants(name)
    assert said["START"] == (world.start.x, world.start.y)
    assert said.get("REAL", obstacles_of(world.name)) == obstacles_of(world.name)


# -- the article ------------------------------------------------------------------

ARTICLE = (DEMOS.parent / "lesson.md").read_text("utf-8")


def article_code() -> list[str]:
    return re.findall(r"^```python\n(.*?)^```$", ARTICLE, flags=re.M | re.S)


def rows_after(heading: str) -> list[list[str]]:
    """The cells of the first table after a line of the article, without its two rows of heads."""
    lines = ARTICLE.split(f"\n{heading}\n")[1].split("\n\n")
    table = next(block for block in lines if block.startswith("|")).splitlines()
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in table[2:]]


def typed(number: str) -> float:
    return float(number.replace("−", "-"))


def test_the_articles_table_of_log_odds_is_right():
    rows = rows_after("## Log odds")
    assert len(rows) > 6
    for p, l, _ in rows:  # noqa: E741
        assert log_odds(typed(p)) == pytest.approx(typed(l), abs=0.12 if typed(l) == 8 else 0.006)


def test_the_articles_table_of_systems_is_right():
    for system, hit, miss, limits, hits, passes in rows_after("### The numbers of real systems"):
        added = [typed(cell.split()[0]) for cell in (hit, miss)]
        for cell, value in zip((hit, miss), added, strict=True):
            (p,) = re.findall(r"\((.+)\)", cell)
            assert log_odds(float(p)) == pytest.approx(value, abs=0.006), system
        top = typed(re.findall(r"[\d.]+", limits)[-1])
        assert int(hits) == math.ceil(top / added[0] - 1e-9), system
        most = int(hits) * added[0] if "stop" in limits else top
        assert int(passes) == math.ceil(most / -added[1] - 1e-9), system


def test_the_articles_list_code_maps_as_the_reference_mapper_does():
    names: dict[str, Any] = {}
    exec(article_code()[0], names)
    mapper = Mapper()
    for angle, reading in [(0, 100.0), (37, 52.5), (200, 171.0), (285, 200.0), (90, 3.0)]:
        for _ in range(9):
            names["add_beam"](101, 99, angle, reading)
            mapper.add_beam(101, 99, angle, reading)
    assert names["log_odds"] == pytest.approx(mapper.grid.cells)


def test_the_articles_numpy_code_draws_bresenhams_line():
    names: dict[str, Any] = {}
    exec(article_code()[1], names)
    grid = names["grid"]
    assert grid[26, 33] == pytest.approx(0.85)
    assert sorted({round(float(value), 2) for value in grid.flat}) == [-0.4, 0, 0.85]
    for last in itertools.product(range(6), range(6)):
        rows, columns = names["line"]((2, 3), last)
        assert list(zip(columns.tolist(), rows.tolist(), strict=True)) == bresenham((2, 3), last)
