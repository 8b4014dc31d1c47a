from collections.abc import Callable
from typing import Any

from bugbot import connect
from bugbot.link import Link, active, connected

Run = Callable[..., Any]


def test_links_can_be_nested_and_the_outer_one_comes_back(make_link: Callable[..., Link]) -> None:
    outer, inner = make_link("empty"), make_link("doorway")
    with connected(outer):
        with connected(inner):
            assert active("wait()") is inner
        assert active("wait()") is outer


def test_the_line_is_recorded_whenever_time_is_about_to_pass(run: Run) -> None:
    ran = run("""
        from bugbot import *
        import time
        wait(1)
        for i in range(3):
            wait(1)
        def step():
            forward(
                100,
                distance=11.5,
            )
        step()
        time.sleep(1)
        x = scan()
        turn(36)
    """)
    lines = [(event["t"], event["line"]) for event in ran.of_kind("line")]
    assert lines == [(0, 3), (1, 5), (4, 7), (5.0, 12), (6.0, 14)]


def test_outside_a_program_there_is_no_line(robot: Link) -> None:
    connect().wait(1)
    assert list(robot.trace.of_kind("line")) == []
    assert robot.learner_line() is None
