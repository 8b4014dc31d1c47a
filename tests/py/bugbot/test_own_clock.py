import time
from collections.abc import Callable
from typing import Any

import pytest

from bugbot.own_clock import EPOCH_S, simulated_time

CLOCKS = (
    "monotonic",
    "monotonic_ns",
    "perf_counter",
    "perf_counter_ns",
    "sleep",
    "time",
    "time_ns",
)

Run = Callable[..., Any]


def test_every_clock_follows_and_is_put_back() -> None:
    before = [getattr(time, name) for name in CLOCKS]
    slept: list[float] = []
    with simulated_time(lambda: 2.5, slept.append):
        assert time.time() == EPOCH_S + 2.5
        assert time.time_ns() == (EPOCH_S + 2.5) * 1e9
        assert time.monotonic() == time.perf_counter() == 2.5
        assert time.monotonic_ns() == time.perf_counter_ns() == 2_500_000_000
        time.sleep(7)
    assert slept == [7]
    assert [getattr(time, name) for name in CLOCKS] == before


def test_the_clocks_are_put_back_after_an_error() -> None:
    before = time.time
    with pytest.raises(KeyError), simulated_time(lambda: 0.0, lambda _: None):
        raise KeyError
    assert time.time is before


def test_a_program_written_with_time_runs_on_simulated_time(run: Run) -> None:
    ran = run("""
        import time
        from time import sleep
        from bugbot import forward, clock
        begin = time.time()
        forward(100)
        while time.time() < begin + 3:
            sleep(0.5)
        print(clock(), time.monotonic(), time.perf_counter_ns(), time.gmtime(begin)[:3])
    """)
    assert ran.console == "3.0 3.0 3000000000 (2026, 1, 1)\n"
    assert ran.pose["y"] == 134.5


@pytest.mark.parametrize("seconds", ["-1", "'a'", "float('nan')"])
def test_sleep_checks_its_argument_as_wait_does(run: Run, seconds: str) -> None:
    ran = run(f"import time\ntime.sleep({seconds})")
    assert ran.fault["message"].startswith(
        "time.sleep(seconds) wants a number of 0 or more; it got "
    )
    assert ran.fault["line"] == 2
