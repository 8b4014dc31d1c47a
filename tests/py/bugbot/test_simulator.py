import itertools
from collections.abc import Callable
from math import cos, hypot, pi, radians, sin
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot import worlds
from bugbot.frames import turn_between
from bugbot.sim.simulator import Simulator
from bugbot.trace import Trace
from bugbot.worlds import World

Worlds = Callable[..., World]


def simulator(world: World | str, seed: int = 1) -> tuple[Simulator, Trace]:
    loaded = worlds.load(world) if isinstance(world, str) else world
    trace = Trace("", loaded.to_dict(), seed)
    return Simulator(loaded, seed, trace), trace


@pytest.mark.parametrize(
    ("heading", "command", "moved"),
    [
        (0, (100, 0, 0), (0, 11.5)),
        (90, (100, 0, 0), (11.5, 0)),
        (0, (0, 100, 0), (11.5, 0)),
        (90, (0, 100, 0), (0, -11.5)),
        (0, (-50, 0, 0), (0, -5.75)),
        (30, (100, 0, 0), (5.75, 11.5 * cos(pi / 6))),
        (45, (100, 100, 0), (11.5 * 2**0.5, 0)),
    ],
)
def test_one_second_of_straight_driving(
    make_world: Worlds,
    heading: float,
    command: tuple[float, float, float],
    moved: tuple[float, float],
) -> None:
    sim, _ = simulator(make_world(at=(100, 100, heading)))
    sim.drive(*command)
    sim.advance(1)
    assert (sim.x - 100, sim.y - 100) == pytest.approx(moved, abs=1e-6)
    assert sim.heading == heading
    assert sim.t == 1


def test_driving_while_turning_follows_a_circle() -> None:
    """Speed v and turning rate w go round a circle of radius v / w."""
    sim, _ = simulator("empty")
    sim.drive(100, 0, 25)  # 11.5 cm/s and 30 degrees/s
    radius = 11.5 / radians(30)
    sim.advance(3)  # a quarter of the circle, clockwise
    assert (sim.x, sim.y) == pytest.approx((100 + radius, 100 + radius), abs=0.01)
    assert sim.heading == 90
    sim.advance(9)  # and back to the start
    assert (sim.x, sim.y) == pytest.approx((100, 100), abs=0.01)
    assert sim.heading == 0


@given(
    st.floats(-100, 100),
    st.floats(-100, 100),
    st.floats(-100, 100),
    st.lists(st.floats(0, 1), min_size=1, max_size=8),
)
def test_it_does_not_matter_how_time_is_cut_up(
    forward: float, right: float, turn: float, waits: list[float]
) -> None:
    cut, _ = simulator("empty")
    whole, _ = simulator("empty")
    for sim in (cut, whole):
        sim.drive(forward, right, turn)
    for seconds in waits:
        cut.advance(seconds)
    whole.advance(sum(waits))
    assert cut.t == pytest.approx(whole.t, abs=1e-6)
    assert (cut.x, cut.y) == pytest.approx((whole.x, whole.y), abs=0.01)
    assert turn_between(cut.heading, whole.heading) == pytest.approx(0, abs=1e-4)


def test_it_stops_dead_where_it_touches_and_says_so_once(make_world: Worlds) -> None:
    sim, trace = simulator(make_world((0, 150, 200, 8), at=(100, 144, 20)))
    sim.drive(100, 0, 0)
    sim.advance(2)
    assert sim.y == 145
    assert sim.x == pytest.approx(100 + sin(radians(20)) / cos(radians(20)))  # no sliding on
    (bump,) = trace.of_kind("bump")
    assert (bump["x"], bump["y"]) == pytest.approx((sim.x, 150))
    assert 0.08 < bump["t"] < 0.12  # 1 cm nearer at 11.5 cm/s times cos 20


def test_it_may_turn_where_it_touches_and_drive_away(make_world: Worlds) -> None:
    sim, trace = simulator(make_world((0, 150, 200, 8), at=(100, 140, 0)))
    sim.drive(100, 0, 0)
    sim.advance(1)
    assert sim.y == 145
    sim.drive(0, 0, 75)
    sim.advance(1)
    assert (sim.x, sim.y, sim.heading) == (100, 145, 90)
    sim.drive(100, 0, 0)
    sim.advance(1)  # exactly along the wall
    assert (sim.x, sim.y) == (111.5, 145)
    sim.drive(0, 0, 75)
    sim.advance(1)
    sim.drive(100, 0, 0)
    sim.advance(1)  # away from it
    assert (sim.x, sim.y) == (111.5, 133.5)
    assert len(list(trace.of_kind("bump"))) == 1


def test_each_new_contact_is_a_bump_of_its_own(make_world: Worlds) -> None:
    sim, trace = simulator(make_world((0, 150, 200, 8), at=(100, 144, 0)))
    for forward in (100, -100, 100, 100):
        sim.drive(forward, 0, 0)
        sim.advance(0.5)
    assert len(list(trace.of_kind("bump"))) == 2


def test_a_bump_in_the_first_moment_after_standing_comes_after_the_standing(
    make_world: Worlds,
) -> None:
    sim, trace = simulator(make_world((0, 150, 200, 8), at=(100, 144.9, 0)))
    sim.advance(1)
    sim.drive(100, 0, 0)
    sim.advance(0.1)
    sim.finish()
    times = [(event[0], event[1]) for event in trace.events]
    assert times == [("pose", 0.0), ("pose", 1.0), ("bump", 1.02), ("pose", 1.04), ("pose", 1.1)]


def test_a_blocked_robot_that_turns_comes_free(make_world: Worlds) -> None:
    sim, _ = simulator(make_world((0, 150, 200, 8), at=(100, 145, 0)))
    sim.drive(100, 0, 25)  # 30 degrees/s: from 90 degrees on it leads away
    sim.advance(3)
    assert (sim.x, sim.y) == (100, 145)
    sim.advance(1)
    assert sim.x > 105
    assert sim.y < 145


def test_until_blocked_returns_at_the_contact(make_world: Worlds) -> None:
    sim, _ = simulator(make_world((0, 150, 200, 8), at=(100, 140, 0)))
    sim.drive(100, 0, 0)
    sim.advance(10, until_blocked=True)
    assert sim.t == pytest.approx(5 / 11.5, abs=0.02)
    assert sim.y == 145
    before = sim.t
    sim.advance(10, until_blocked=True)
    assert sim.t == pytest.approx(before + 0.02)


commands = st.tuples(*[st.integers(-100, 100)] * 3, st.floats(0, 3))


@given(st.sampled_from(worlds.names()), st.lists(commands, max_size=8), st.integers(0, 3))
def test_whatever_it_is_told_it_never_enters_anything_and_time_never_goes_back(
    name: str, orders: list[Any], seed: int
) -> None:
    sim, trace = simulator(name, seed)
    for forward, right, turn, seconds in orders:
        sim.drive(forward, right, turn)
        sim.scan()
        sim.advance(seconds)
    sim.finish()
    for pose in trace.of_kind("pose"):
        x, y = pose["x"], pose["y"]
        assert min(x, y) >= 5 - 1e-6
        assert max(x, y) <= 195 + 1e-6
        assert all(each.gap(x, y) >= 5 - 1e-6 for each in worlds.load(name).obstacles)
        assert 0 <= pose["heading"] < 360
    times = [event[1] for event in trace.events]
    assert times == sorted(times)


def test_poses_are_close_enough_together_to_be_joined_by_lines() -> None:
    sim, trace = simulator("small-maze")
    for forward, turn, seconds in ((60, 20, 1.3), (0, 0, 2), (100, 0, 3), (0, -50, 0.7)):
        sim.drive(forward, 0, turn)
        sim.advance(seconds)
    sim.finish()
    poses = list(trace.of_kind("pose"))
    assert poses[0]["t"] == 0
    assert poses[-1]["t"] == sim.t
    for before, after in itertools.pairwise(poses):
        assert before["t"] < after["t"]
        still = all(before[key] == after[key] for key in ("x", "y", "heading"))
        assert still or after["t"] - before["t"] <= 0.1
        assert hypot(after["x"] - before["x"], after["y"] - before["y"]) <= 1.2


def test_a_robot_that_stands_records_only_its_first_and_last_moment() -> None:
    sim, trace = simulator("empty")
    for _ in range(50):
        sim.advance(0.1)
    sim.finish()
    assert [event[:2] for event in trace.events] == [("pose", 0.0), ("pose", 5.0)]
    sim.drive(10, 0, 0)
    sim.advance(0.04)
    sim.finish()
    assert [event[1] for event in trace.events] == [0.0, 5.0, 5.04]


def test_a_scan_is_recorded_with_the_pose_it_was_taken_from() -> None:
    sim, trace = simulator("wall-ahead")
    sim.drive(50, 0, 0)
    sim.advance(2)
    readings = sim.scan()
    ahead = sim.distance()
    scans = list(trace.of_kind("scan"))
    assert [(scan["t"], scan["x"], scan["y"], scan["heading"]) for scan in scans] == [
        (2.0, 100.0, 51.5, 0.0)
    ] * 2
    assert scans[0]["beams"] == [part for reading in readings for part in reading]
    assert scans[1]["beams"] == [0.0, ahead]
    assert ahead == pytest.approx(98.5, abs=10)


def test_the_battery_falls_slowly_and_not_below_nothing() -> None:
    sim, _ = simulator("empty")
    assert sim.battery() == 100
    sim.advance(600)
    assert sim.battery() == 91.7
    sim.advance(1e6)
    assert sim.battery() == 0


# -- odometry ------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(6))
def test_the_gyro_drifts_steadily_by_about_a_fifth_of_a_degree_a_second(seed: int) -> None:
    sim, _ = simulator("empty", seed)
    assert sim.odometry.heading == sim.heading
    sim.advance(50)
    first = turn_between(sim.heading, sim.odometry.heading)
    assert 7.5 <= abs(first) <= 12.5
    sim.drive(0, 0, 30)
    sim.advance(50)
    assert turn_between(sim.heading, sim.odometry.heading) == pytest.approx(2 * first, abs=1e-3)


def test_it_drifts_to_either_side() -> None:
    sides = {simulator("empty", seed)[0].odometry.drift_deg_s > 0 for seed in range(10)}
    assert sides == {True, False}


@pytest.mark.parametrize("seed", range(6))
def test_the_feet_slip_by_a_few_per_cent(seed: int) -> None:
    sim, _ = simulator("empty", seed)
    sim.drive(100, 0, 0)
    sim.advance(8)
    believed = hypot(sim.odometry.x, sim.odometry.y)
    assert believed == pytest.approx(92, rel=0.08)
    assert believed != pytest.approx(92, abs=0.01)


def test_the_feet_of_a_blocked_robot_walk_on_the_spot(make_world: Worlds) -> None:
    sim, _ = simulator(make_world((0, 105, 200, 5), at=(100, 100, 0)))
    sim.drive(100, 0, 0)
    sim.advance(5)
    assert sim.y == 100
    assert sim.odometry.y > 40


def test_sideways_steps_are_believed_sideways(make_world: Worlds) -> None:
    sim, _ = simulator(make_world(at=(100, 100, 90)))
    sim.drive(0, 100, 0)
    sim.advance(2)
    assert (sim.odometry.x, sim.odometry.y) == pytest.approx((0, -23), abs=2.5)
    assert (sim.x, sim.y) == pytest.approx((100, 77))


def test_turning_on_the_spot_moves_nothing_in_its_belief() -> None:
    sim, _ = simulator("empty")
    sim.drive(0, 0, 100)
    sim.advance(3)
    assert (sim.odometry.x, sim.odometry.y) == (0, 0)


# -- worlds in which turns and ways come out wrong ---------------------------------------


def faulty(**errors: float) -> World:
    return World.from_dict({**worlds.load("empty").to_dict(), "odometry": errors})


def test_turns_come_out_short_in_truth_and_the_gyro_feels_it() -> None:
    sim, _ = simulator(faulty(turn_scale=0.9, drift_deg_s=0.0))
    begin = sim.heading
    sim.drive(0, 0, 50)  # 60 degrees a second are wanted
    sim.advance(2)
    assert turn_between(begin, sim.heading) == pytest.approx(108)
    assert sim.odometry.heading == pytest.approx(sim.heading)


@pytest.mark.parametrize("drift", [-0.35, 0.0, 0.1])
def test_a_worlds_drift_takes_the_place_of_the_seeds(drift: float) -> None:
    for seed in (1, 2):
        sim, _ = simulator(faulty(drift_deg_s=drift), seed)
        sim.advance(20)
        assert turn_between(sim.heading, sim.odometry.heading) == pytest.approx(20 * drift)


def test_feet_that_slip_fall_short_in_truth_and_do_not_know_it() -> None:
    sim, _ = simulator(faulty(slip=0.2, drift_deg_s=0.0))
    begin = sim.x, sim.y
    sim.drive(0, 100, 0)
    sim.advance(4)
    assert hypot(sim.x - begin[0], sim.y - begin[1]) == pytest.approx(0.8 * 46)
    assert hypot(sim.odometry.x, sim.odometry.y) == pytest.approx(46, rel=0.08)


def test_a_world_without_errors_moves_its_robot_to_the_last_bit_as_before() -> None:
    plain, said = simulator("empty", 5), simulator(faulty(turn_scale=1.0, slip=0.0), 5)
    for sim, _ in (plain, said):
        sim.drive(70, 20, 30)
        sim.advance(7.3)
        sim.scan()
    assert plain[1].events == said[1].events
    assert (plain[0].odometry.x, plain[0].odometry.y) == (said[0].odometry.x, said[0].odometry.y)
