"""One clock: whatever of Python's library a program asks for the time, it is the run's."""

import asyncio
import datetime
import logging
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

Run = Callable[..., Any]

NOW = [
    ("time.time()", "1767225602.5"),
    ("time.time_ns()", "1767225602500000000"),
    ("time.monotonic()", "2.5"),
    ("time.perf_counter()", "2.5"),
    ("time.process_time()", "2.5"),
    ("time.process_time_ns()", "2500000000"),
    ("time.thread_time()", "2.5"),
    ("time.clock_gettime(time.CLOCK_MONOTONIC)", "2.5"),
    ("time.clock_gettime(time.CLOCK_REALTIME)", "1767225602.5"),
    ("time.gmtime()[:6]", "(2026, 1, 1, 0, 0, 2)"),
    ("time.localtime()[:6]", "(2026, 1, 1, 0, 0, 2)"),
    ("time.mktime(time.localtime())", "1767225602.0"),
    ("time.strftime('%d %b %Y %H:%M:%S')", "01 Jan 2026 00:00:02"),
    ("time.ctime()", "Thu Jan  1 00:00:02 2026"),
    ("time.asctime()", "Thu Jan  1 00:00:02 2026"),
    ("time.timezone, time.tzname", "0 ('UTC', 'UTC')"),
    ("datetime.datetime.now()", "2026-01-01 00:00:02.500000"),
    ("datetime.datetime.now().timestamp()", "1767225602.5"),
    ("datetime.datetime.today()", "2026-01-01 00:00:02.500000"),
    ("datetime.datetime.utcnow()", "2026-01-01 00:00:02.500000"),
    ("datetime.datetime.now(datetime.timezone.utc)", "2026-01-01 00:00:02.500000+00:00"),
    ("datetime.datetime.now().astimezone()", "2026-01-01 00:00:02.500000+00:00"),
    ("datetime.datetime.fromtimestamp(0)", "1970-01-01 00:00:00"),
    ("datetime.date.fromtimestamp(0)", "1970-01-01"),
    ("datetime.date.today()", "2026-01-01"),
    ("timeit.default_timer()", "2.5"),
]


@pytest.mark.parametrize(("asked", "told"), NOW)
def test_every_clock_is_the_runs(run_calls: Run, asked: str, told: str) -> None:
    ran = run_calls(f"import datetime, time, timeit\nwait(2.5)\nprint({asked})")
    assert ran.console == f"{told}\n"


def test_names_imported_one_by_one_are_the_runs_as_well(run_calls: Run) -> None:
    ran = run_calls("""
        from datetime import date, datetime
        from time import localtime, process_time, time
        wait(1)
        print(time() - datetime.now().timestamp(), date.today(), localtime().tm_sec, process_time())
    """)
    assert ran.console == "0.0 2026-01-01 1 1.0\n"


def test_a_simulated_date_is_a_date_in_every_other_respect(run: Run) -> None:
    ran = run("""
        import copy, datetime, pickle
        from datetime import date, datetime as dt, timedelta
        now = dt.now()
        class Birthday(date):
            pass
        print(repr(now), repr(date.today()), type(now))
        print(now - timedelta(days=1), now - dt(2025, 12, 31), now > dt(2020, 1, 1))
        print(isinstance(now, dt), isinstance(now, date), isinstance(now.date(), date))
        print(isinstance(3, date), isinstance(now, Birthday), issubclass(dt, date))
        print(dt.strptime("2026-05-06", "%Y-%m-%d"), dt.fromisoformat("2026-05-06"))
        print(Birthday.today(), type(Birthday.today()).__name__)
        print(copy.copy(now) == now, pickle.loads(pickle.dumps(now)) == now, {now: 1}[now])
    """)
    assert ran.console.splitlines() == [
        "datetime.datetime(2026, 1, 1, 0, 0) datetime.date(2026, 1, 1) <class 'datetime.datetime'>",
        "2025-12-31 00:00:00 1 day, 0:00:00 True",
        "True True True",
        "False False True",
        "2026-05-06 00:00:00 2026-05-06 00:00:00",
        "2026-01-01 Birthday",
        "True True 1",
    ]


def test_waiting_by_other_means_lets_simulated_time_pass(run_calls: Run) -> None:
    program = """
        import queue, sched, threading
        plan = sched.scheduler()
        plan.enter(2, 1, lambda: print("planned", clock()))
        plan.run()
        print(threading.Event().wait(1.5), clock())
        try:
            queue.Queue().get(timeout=0.5)
        except queue.Empty:
            print("nothing came", clock())
    """
    for _ in range(2):  # the second run finds the modules loaded by the first
        assert run_calls(program).console == "planned 2.0\nFalse 3.5\nnothing came 4.0\n"


@pytest.mark.parametrize("wait", ["threading.Event().wait()", "queue.Queue().get()"])
def test_a_wait_that_nobody_can_end_is_an_error(run: Run, wait: str) -> None:
    ran = run(f"import queue, threading\n{wait}")
    assert ran.fault["message"].startswith("the program waits for something that can't come")
    assert ran.fault["line"] == 2


def test_logging_tells_simulated_time(run_calls: Run) -> None:
    ran = run_calls("""
        import logging
        logging.basicConfig(format="%(asctime)s %(relativeCreated)d %(message)s", force=True)
        wait(61)
        logging.warning("still here")
    """)
    assert ran.console == "2026-01-01 00:01:01,000 61000 still here\n"
    logging.getLogger().handlers.clear()


def test_timeit_measures_the_computer(run: Run) -> None:
    ran = run("from timeit import timeit\nprint(timeit(lambda: sum(range(1000)), number=20) > 0)")
    assert ran.console == "True\n"


def test_everything_is_put_back(run: Run) -> None:
    before = (time.process_time, datetime.datetime, datetime.date, threading.Condition.wait)
    loops = (asyncio.run, asyncio.new_event_loop, asyncio.get_event_loop)
    run("import asyncio, datetime, sched, timeit\nasyncio.run(asyncio.sleep(1))")
    assert before == (
        time.process_time,
        datetime.datetime,
        datetime.date,
        threading.Condition.wait,
    )
    assert loops == (asyncio.run, asyncio.new_event_loop, asyncio.get_event_loop)
    assert abs(time.time() - datetime.datetime.now().timestamp()) < 60
