import copy
import json
from pathlib import Path
from typing import Any

import pytest

from bugbot import worlds
from bugbot.errors import WorldError
from bugbot.frames import MAT_CM, ROBOT_RADIUS_CM
from bugbot.worlds import World

GOOD: dict[str, Any] = {
    "name": "good",
    "title": "Good",
    "description": "Sound in every field.",
    "obstacles": [{"x": 10, "y": 20, "width": 30, "height": 40, "name": "box"}],
    "start": {"x": 100, "y": 100, "heading": 90},
}


def test_the_worlds_of_the_article_have_exactly_these_rectangles() -> None:
    rectangles = {
        name: [(each.x, each.y, each.width, each.height) for each in worlds.load(name).obstacles]
        for name in ("post-and-shelf", "wall-ahead", "doorway", "empty")
    }
    assert rectangles == {
        "post-and-shelf": [(130, 70, 8, 70), (40, 150, 70, 8)],
        "wall-ahead": [(0, 150, 200, 8)],
        "doorway": [(0, 120, 90, 8), (110, 120, 90, 8)],
        "empty": [],
    }
    starts = {name: worlds.load(name).start for name in rectangles}
    assert [(s.x, s.y, s.heading) for s in starts.values()] == [
        (100, 100, 0),
        (100, 40, 0),
        (100, 25, 0),
        (100, 100, 0),
    ]


def test_there_are_a_cluttered_room_and_a_maze() -> None:
    assert {"cluttered-room", "small-maze"} <= set(worlds.names())
    assert worlds.names() == sorted(worlds.names())


@pytest.mark.parametrize("name", worlds.names())
def test_every_world_is_named_as_its_file_and_survives_a_round_trip(name: str) -> None:
    world = worlds.load(name)
    assert world.name == name
    assert World.from_dict(json.loads(json.dumps(world.to_dict()))) == world


def reachable_and_free(name: str) -> tuple[set[tuple[int, int]], set[tuple[int, int]]]:
    """Flood over a lattice of 2 cm: where the robot can get to, and where it fits."""
    world, step = worlds.load(name), 2
    begin = (int(world.start.x), int(world.start.y))
    low, high = int(ROBOT_RADIUS_CM), int(MAT_CM - ROBOT_RADIUS_CM)
    free = {
        (x, y)
        for x in range(low + (begin[0] - low) % step, high + 1, step)
        for y in range(low + (begin[1] - low) % step, high + 1, step)
        if all(each.gap(x, y) > ROBOT_RADIUS_CM for each in world.obstacles)
    }
    reached, edge = {begin}, [begin]
    while edge:
        x, y = edge.pop()
        for near in ((x + step, y), (x - step, y), (x, y + step), (x, y - step)):
            if near in free and near not in reached:
                reached.add(near)
                edge.append(near)
    return reached, free


@pytest.mark.parametrize("name", worlds.names())
def test_the_robot_starts_with_room_all_round(name: str) -> None:
    world = worlds.load(name)
    start = world.start
    assert all(each.gap(start.x, start.y) > 2 * ROBOT_RADIUS_CM for each in world.obstacles)
    assert min(start.x, start.y, MAT_CM - start.x, MAT_CM - start.y) >= 10


@pytest.mark.parametrize("name", sorted(set(worlds.names()) - {"wall-ahead"}))
def test_the_robot_can_reach_every_place_it_fits(name: str) -> None:
    reached, free = reachable_and_free(name)
    assert reached == free


def test_nothing_behind_the_wall_ahead_can_be_reached() -> None:
    reached, _ = reachable_and_free("wall-ahead")
    assert max(y for _, y in reached) < 145


@pytest.mark.parametrize(
    ("point", "gap"),
    [((5, 40), 5), ((25, 30), 0), ((25, 63), 3), ((43, 64), 5), ((40, 60), 0), ((7, 16), 5)],
)
def test_gap_to_an_obstacle_beside_above_within_and_off_a_corner(
    point: tuple[float, float], gap: float
) -> None:
    box = World.from_dict(GOOD).obstacles[0]
    assert box.gap(*point) == pytest.approx(gap)


def _without(*path: Any) -> dict[str, Any]:
    world = copy.deepcopy(GOOD)
    place: Any = world
    for step in path[:-1]:
        place = place[step]
    del place[path[-1]]
    return world


def _with(value: Any, *path: Any) -> dict[str, Any]:
    world = copy.deepcopy(GOOD)
    place: Any = world
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    return world


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (
            [],
            "w.json: the world wants an object with name, title, description, obstacles, start; "
            "it got []",
        ),
        (_without("title"), "w.json: title is missing; add it"),
        (
            _with(1, "colour"),
            "w.json: colour is not a field here; "
            "the fields are name, title, description, obstacles, start, camera, odometry",
        ),
        (_with("  ", "title"), "w.json: title wants a text that is not empty; it got '  '"),
        (_with("no", "camera"), "w.json: camera wants true or false; it got 'no'"),
        (_with(3, "name"), "w.json: name wants a text that is not empty; it got 3"),
        (_with({}, "obstacles"), "w.json: obstacles wants a list of rectangles; it got {}"),
        (
            _with(7, "obstacles", 0),
            "w.json: obstacles[0] wants an object with x, y, width, height, name; it got 7",
        ),
        (_without("obstacles", 0, "y"), "w.json: obstacles[0].y is missing; add it"),
        (
            _with(-3, "obstacles", 0, "width"),
            "w.json: obstacles[0].width wants a number from 0.1 to 190; it got -3",
        ),
        (
            _with("wide", "obstacles", 0, "width"),
            "w.json: obstacles[0].width wants a number from 0.1 to 190; it got 'wide'",
        ),
        (
            _with(True, "obstacles", 0, "x"),
            "w.json: obstacles[0].x wants a number from 0 to 200; it got True",
        ),
        (
            _with(float("nan"), "obstacles", 0, "x"),
            "w.json: obstacles[0].x wants a number from 0 to 200; it got nan",
        ),
        (
            _with(181, "obstacles", 0, "height"),
            "w.json: obstacles[0].height wants a number from 0.1 to 180; it got 181",
        ),
        (_without("start", "heading"), "w.json: start.heading is missing; add it"),
        (_with(4, "start", "x"), "w.json: start.x wants a number from 5 to 195; it got 4"),
        (
            _with({"x": 42, "y": 40, "heading": 0}, "start"),
            "w.json: start (42, 40) is too near obstacles[0], the box: move it 3.0 cm away "
            "(the robot's radius is 5 cm)",
        ),
    ],
)
def test_a_broken_world_is_refused_by_file_field_and_remedy(data: Any, message: str) -> None:
    with pytest.raises(WorldError) as refusal:
        World.from_dict(data, "w.json")
    assert str(refusal.value) == message


def test_a_start_that_just_touches_is_allowed() -> None:
    assert World.from_dict(_with({"x": 45, "y": 40, "heading": -90}, "start")).start.heading == 270


def test_a_world_has_a_camera_unless_it_says_not_and_says_so_only_then() -> None:
    assert World.from_dict(GOOD).camera
    assert "camera" not in World.from_dict(_with(True, "camera")).to_dict()
    without = World.from_dict(_with(False, "camera"))
    assert not without.camera
    assert World.from_dict(without.to_dict()) == without


def test_an_unknown_world_names_the_nearest_and_the_known() -> None:
    with pytest.raises(WorldError) as refusal:
        worlds.load("post-and-shelv")
    assert str(refusal.value) == (
        "there is no world 'post-and-shelv' (did you mean 'post-and-shelf'?); known worlds: "
        "cluttered-room, doorway, empty, post-and-shelf, small-maze, wall-ahead; "
        "or give the path of a world's .json file"
    )
    with pytest.raises(WorldError, match=r"there is no world 'xyz'; known worlds"):
        worlds.load("xyz")


def test_a_world_of_ones_own_is_loaded_by_its_path(tmp_path: Path) -> None:
    file = tmp_path / "mine.json"
    file.write_text(json.dumps(GOOD), encoding="utf-8")
    assert worlds.load(file) == worlds.load(str(file)) == World.from_dict(GOOD)


def test_a_world_file_that_cannot_be_read_is_refused(tmp_path: Path) -> None:
    with pytest.raises(WorldError, match=r"there is no world file .*none\.json"):
        worlds.load(tmp_path / "none.json")
    folder = tmp_path / "folder.json"
    folder.mkdir()
    with pytest.raises(WorldError, match=r"folder\.json can't be read"):
        worlds.load(folder)
    latin = tmp_path / "latin.json"
    latin.write_bytes(b'{"name": "caf\xe9"}')
    with pytest.raises(WorldError, match=r"latin\.json can't be read"):
        worlds.load(latin)
    broken = tmp_path / "broken.json"
    broken.write_text("{", encoding="utf-8")
    with pytest.raises(WorldError, match=r"broken\.json is not JSON: .*line 1"):
        worlds.load(broken)


AGREED = Path(__file__).parents[2] / "golden" / "worlds.json"


@pytest.mark.parametrize("case", json.loads(AGREED.read_text("utf-8")), ids=lambda c: c["what"])
def test_worlds_are_judged_as_by_the_sites_editor(case: dict[str, Any]) -> None:
    """tests/unit/mats.spec.ts asks the editor's rules about the same worlds."""
    world = case["world"]
    for field, times in case.get("times", {}).items():
        world[field] = world[field] * times
    if case["refused"] is None:
        read = World.from_dict(world, "w.json")
        assert World.from_dict(read.to_dict()) == read
    else:
        with pytest.raises(WorldError) as refusal:
            World.from_dict(world, "w.json")
        assert str(refusal.value).split("; it got")[0] == f"w.json: {case['refused']}"


def test_a_world_file_of_a_windows_editor_and_one_that_nests_without_end(tmp_path: Path) -> None:
    marked = tmp_path / "marked.json"
    marked.write_text(json.dumps(GOOD), encoding="utf-8-sig")
    assert worlds.load(marked).name == "good"
    deep = tmp_path / "deep.json"
    deep.write_text("[" * 100_000, encoding="utf-8")
    with pytest.raises(WorldError, match=r"deep\.json is not a world: its lists lie too deep"):
        worlds.load(deep)
