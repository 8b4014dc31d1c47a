"""Every call of the robot, used rightly; `test_arguments.py` has the wrong uses."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import bugbot
from bugbot import (
    Robot,
    backward,
    battery,
    beep,
    clock,
    connect,
    distance,
    draw,
    drive,
    forward,
    heading,
    led,
    left,
    odometry,
    plot,
    position,
    right,
    scan,
    stop,
    turn,
    wait,
)
from bugbot.errors import NoCameraError, NoRobotError
from bugbot.link import Link, connected
from bugbot.worlds import World


def events(link: Link, kind: str) -> list[dict[str, Any]]:
    return list(link.trace.of_kind(kind))


def test_drive_moves_while_time_passes(robot: Link) -> None:
    drive(50, -100, 10)
    assert position() == (0, 0)
    wait(0.02)
    assert position() == pytest.approx((-0.23, 0.115), abs=0.002)
    assert heading() == 0.24
    assert clock() == 0.02


def test_forward_and_backward_without_a_distance_go_on(robot: Link) -> None:
    forward()
    wait(2)
    assert position() == (0, 11.5)
    backward(100)
    wait(1)
    stop()
    wait(1)
    assert position() == (0, 0)


@pytest.mark.parametrize(
    ("call", "arguments", "y", "seconds"),
    [
        (forward, {"distance": 23}, 23, 4),
        (forward, {"speed": 100, "distance": 11.5}, 11.5, 1),
        (forward, {"speed": 500, "distance": 11.5}, 11.5, 1),  # clamped
        (forward, {"speed": -100, "distance": 11.5}, -11.5, 1),
        (forward, {"distance": 0}, 0, 0),
        (backward, {"distance": 23}, -23, 4),
        (backward, {"speed": 25, "distance": 2.875}, -2.875, 1),
    ],
)
def test_with_a_distance_they_wait_until_it_is_driven_and_stop(
    robot: Link, call: Callable[..., None], arguments: dict[str, float], y: float, seconds: float
) -> None:
    call(**arguments)
    assert position() == (0, pytest.approx(y, abs=1e-6))
    assert clock() == pytest.approx(seconds)
    wait(1)
    assert position()[1] == pytest.approx(y, abs=1e-6)


def test_forward_against_a_wall_returns_and_has_stopped(
    make_world: Callable[..., World], make_link: Callable[..., Link]
) -> None:
    with connected(make_link(make_world((0, 115, 200, 5), at=(100, 100, 0)))) as link:
        forward(100, distance=80)
        assert position() == (0, 10)
        assert clock() < 1
        assert not link.sim.driving


def test_a_long_way_that_is_blocked_soon_is_no_limit(
    make_world: Callable[..., World], make_link: Callable[..., Link]
) -> None:
    with connected(make_link(make_world((0, 110, 200, 5), at=(100, 100, 0)))):
        forward(10, distance=1000)  # would take 870 s
        assert position() == (0, 5)
        assert clock() < 5


@pytest.mark.parametrize(("call", "facing"), [(left, 300), (right, 60)])
def test_left_and_right_spin_on_the_spot(
    robot: Link, call: Callable[..., None], facing: float
) -> None:
    call()
    wait(1)
    assert heading() == facing
    call(speed=25)
    wait(1)
    assert heading() == (facing - 30 if facing == 300 else facing + 30)
    assert position() == (0, 0)


@pytest.mark.parametrize(
    ("degrees", "speed", "facing", "seconds"),
    [
        (90, 30, 90, 2.5),
        (-90, 30, 270, 2.5),
        (720, 100, 0, 6),
        (0, 30, 0, 0),
        (33.3, 7, 33.3, 3.964),
    ],
)
def test_turn_waits_until_it_has_turned_exactly_so_far(
    robot: Link, degrees: float, speed: float, facing: float, seconds: float
) -> None:
    turn(degrees, speed)
    assert heading() == pytest.approx(facing)
    assert clock() == pytest.approx(seconds, abs=0.001)
    wait(1)
    assert heading() == pytest.approx(facing)


def test_wait_of_nothing_takes_no_time(robot: Link) -> None:
    wait(0)
    assert clock() == 0


def test_scan_gives_eight_pairs_from_left_to_right(robot: Link) -> None:
    pairs = scan()
    assert len(pairs) == 8
    assert [angle for angle, _ in pairs] == sorted(angle for angle, _ in pairs)
    assert all(cm == pytest.approx(105, abs=15) for _, cm in pairs)
    assert len(events(robot, "scan")) == 1


def test_distance_looks_straight_ahead(robot: Link) -> None:
    assert distance() == pytest.approx(100, abs=10)


def test_position_counts_from_the_start_along_the_mat(
    make_world: Callable[..., World], make_link: Callable[..., Link]
) -> None:
    with connected(make_link(make_world(at=(50, 60, 90)))):
        forward(100, distance=20)
        assert position() == (20, 0)
        assert heading() == 90
        x, y, facing = odometry()
        assert (x, y) == pytest.approx((20, 0), abs=2)
        assert facing == pytest.approx(90, abs=1)


@pytest.mark.parametrize(("call", "words"), [(position, "position()"), (heading, "heading()")])
def test_without_a_camera_the_exact_pose_is_refused_and_odometry_is_not(
    make_world: Callable[..., World],
    make_link: Callable[..., Link],
    call: Callable[[], Any],
    words: str,
) -> None:
    with connected(make_link(replace(make_world(at=(50, 60, 90)), camera=False))):
        with pytest.raises(NoCameraError) as refusal:
            call()
        assert str(refusal.value) == (
            f"{words} needs a camera above the mat, and this mat has none; "
            "odometry() is all that the robot has"
        )
        assert odometry()[2] == pytest.approx(90, abs=1)


def test_battery_is_full_at_the_start(robot: Link) -> None:
    assert battery() == 100
    wait(120)
    assert battery() < 100


def test_draw_puts_and_replaces_a_layer(robot: Link) -> None:
    draw("free", [(2.5, 7.5), (102.5, 199)], "#9ECAE1", "squares", 5)
    draw("free", [], "Red")
    first, second = events(robot, "layer")
    assert robot.trace.points_of(first) == [(2.5, 7.5), (102.5, 199)]
    assert (first["colour"], first["shape"], first["size"]) == ("#9ecae1", "squares", 5)
    assert (second["colour"], second["shape"], second["size"]) == ("red", "dots", 2)
    assert second["count"] == 0
    assert second["texts"] is None


@pytest.mark.parametrize(
    "points",
    [
        [(1, 2), (3.5, 4)],
        ((1, 2), (3.5, 4)),
        [[1, 2], [3.5, 4]],
        iter([(1, 2), (3.5, 4)]),
        {(1, 2): "a", (3.5, 4): "b"},
        np.array([[1, 2], [3.5, 4]]),
        [np.array([1, 2]), np.array([3.5, 4])],
        [(np.float64(1), np.int32(2)), (np.float32(3.5), 4)],
    ],
)
def test_draw_takes_points_in_any_wrapping(robot: Link, points: Any) -> None:
    draw("a", points)
    (layer,) = events(robot, "layer")
    assert robot.trace.points_of(layer) == [(1, 2), (3.5, 4)]


def test_text_shows_its_words_or_the_layers_name(robot: Link) -> None:
    draw("goal", [(1, 2), (3, 4, "here"), [5, 6, 7]], shape="text", size=6)
    (layer,) = events(robot, "layer")
    assert layer["texts"] == ["goal", "here", "7"]
    assert robot.trace.points_of(layer) == [(1, 2), (3, 4), (5, 6)]


def test_plot_adds_a_point_at_the_present_time(robot: Link) -> None:
    plot("known %", 1)
    wait(0.5)
    plot("known %", np.float32(2.5))
    assert events(robot, "plot") == [
        {"t": 0.0, "name": "known %", "value": 1.0},
        {"t": 0.5, "name": "known %", "value": 2.5},
    ]


@pytest.mark.parametrize(
    ("arguments", "light"),
    [
        (("red",), (255, 0, 0)),
        (("RebeccaPurple",), (102, 51, 153)),
        (("#0f8",), (0, 255, 136)),
        (("#9ecae1",), (158, 202, 225)),
        ((255, 160, 0.4), (255, 160, 0)),
        (("off",), (0, 0, 0)),
        ((), (0, 0, 0)),
    ],
)
def test_led_takes_a_name_hex_or_three_amounts(
    robot: Link, arguments: tuple[Any, ...], light: tuple[int, int, int]
) -> None:
    led(*arguments)
    (event,) = events(robot, "led")
    assert (event["red"], event["green"], event["blue"]) == light


def test_beep_takes_no_time(robot: Link) -> None:
    beep(440)
    beep(freq=20_000, ms=0)
    assert [(event["freq"], event["ms"]) for event in events(robot, "beep")] == [
        (440, 200),
        (20_000, 0),
    ]
    assert clock() == 0


def test_connect_works_with_and_without_arguments(robot: Link) -> None:
    for device in (connect(), connect("BUGBOT-7", timeout=3), Robot(), Robot("10.0.0.7")):
        assert repr(device) == "<the robot>"
        device.forward(100)
    wait(1)
    assert position() == (0, 11.5)


def test_a_with_block_stops_the_robot_at_its_end(robot: Link) -> None:
    with Robot() as device:
        device.drive(100, 0, 0)
        device.wait(1)
    assert not robot.sim.driving
    forward()
    connect().__exit__(KeyError, KeyError(), None)
    assert not robot.sim.driving


def test_go_puts_the_names_into_the_program(robot: Link) -> None:
    names: dict[str, Any] = {"bugbot": bugbot}
    exec("bugbot.go()\nforward(100)\nwait(1)", names)
    assert position() == (0, 11.5)
    assert {*bugbot.__all__} - {"go", "BugbotError"} <= set(names)


@pytest.mark.parametrize(
    "call", [wait, scan, connect, Robot, bugbot.go, stop], ids=lambda call: call.__name__
)
def test_a_call_outside_a_run_says_how_to_start_one(call: Callable[..., Any]) -> None:
    with pytest.raises(
        NoRobotError, match=rf"^{call.__name__}.* has no robot to talk to: press Run"
    ):
        call(1) if call is wait else call()


def test_fractions_and_decimals_are_numbers(run_calls: Callable[..., Any]) -> None:
    head = "from fractions import Fraction\nfrom decimal import Decimal\n"
    ran = run_calls(
        f"{head}draw('a', [(Fraction(5, 2), Decimal('7.5'))])\nplot('b', Decimal('0.5'))\n"
        "wait(Decimal('0.1'))\n"
    )
    assert ran.status == "finished"
    refused = run_calls(f"{head}plot('b', Decimal('sNaN'))\n")
    assert "plot(name, value) wants" in refused.fault["message"]
