"""Programs that can't go well: each ends with a clear message on the right line."""

import builtins
import sys
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from bugbot.run import Limits, run_program, watchdog
from bugbot.run.limits import Meter
from bugbot.trace import Trace

Run = Callable[..., Any]


def test_an_empty_program_finishes_and_says_so(run: Run) -> None:
    for text in ("", "\n\n  \n", "\ufeff"):
        ran = run(text)
        assert (ran.status, ran.message) == (
            "finished",
            "Finished after 0 s. The program is empty.",
        )


def test_a_program_of_a_megabyte_runs(run: Run) -> None:
    ran = run("x = 1  # padding\n" * 60_000 + "print('end')\n")
    assert (ran.status, ran.console) == ("finished", "end\n")


def test_a_megabyte_that_is_no_program_is_refused_on_its_line(run: Run) -> None:
    ran = run("x = 1\n" * 100_000 + "x = = 2\n" + "x = 1\n" * 70_000)
    assert (ran.status, ran.fault["line"]) == ("fault", 100_001)


@pytest.mark.parametrize("text", ["(" * 300, "-" * 100_000 + "1", "[" * 5000 + "]" * 5000])
def test_nesting_beyond_what_python_reads_is_a_fault(run: Run, text: str) -> None:
    assert run(text).status == "fault"


def test_characters_that_cannot_be_stored_are_replaced(run: Run) -> None:
    assert run("print('\ud83e')").console == "\ufffd\ufffd\ufffd\n"
    assert run("print(chr(0xd83e))").console == "\ufffd\ufffd\ufffd\n"
    fault = run("x = 1\nx = \ud83e").fault
    assert (fault["type"], fault["line"]) == ("SyntaxError", 2)
    assert run("raise ValueError(chr(0xd83e))").fault["message"].encode("utf-8")


def test_a_null_character_is_refused_on_its_line(run: Run) -> None:
    fault = run("x = 1\ny = '\0'\n").fault
    assert (fault["type"], fault["line"]) == ("SyntaxError", 2)
    assert "null" in fault["message"]


@pytest.mark.parametrize(
    ("program", "who"),
    [
        ("input('Name? ')", "input()"),
        ("import sys\nsys.stdin.readline()", "sys.stdin"),
        ("import sys\nsys.stdin.read()", "sys.stdin"),
        ("import sys\nfor line in sys.stdin: pass", "sys.stdin"),
        ("breakpoint()", "breakpoint()"),
    ],
)
def test_asking_for_typed_input_is_refused(run: Run, program: str, who: str) -> None:
    ran = run(program)
    assert ran.status == "fault"
    assert ran.fault["type"] == "EOFError"
    assert ran.fault["line"] == len(program.splitlines())
    assert ran.fault["message"].startswith(f"{who} has nobody to answer it: ")


def test_the_keyboard_says_that_it_may_be_asked_and_cannot_be_closed(run: Run) -> None:
    program = "import sys\nsys.stdin.close()\nprint(sys.stdin.readable(), sys.stdin.closed)"
    assert run(program).console == "True False\n"


@pytest.mark.parametrize(
    ("program", "console"),
    [
        ("import sys\nprint('a')\nsys.exit()", "a\n"),
        ("import sys\nprint('a')\nsys.exit(3)", "a\n"),
        ("import sys\nprint('a')\nsys.exit('too bad')", "a\ntoo bad\n"),
        ("print('a')\n\nexit()", "a\n"),
        ("print('a')\n\nquit()", "a\n"),
        ("import os\nprint('a')\nos._exit(1)", "a\n"),
        ("import os\nprint('a')\nos.abort()", "a\n"),
        ("print('a')\ndef leave():\n    raise SystemExit\nleave()", "a\n"),
    ],
)
def test_leaving_early_is_an_ordinary_end(run: Run, program: str, console: str) -> None:
    ran = run(program)
    assert (ran.status, ran.console, ran.fault) == ("finished", console, None)
    assert ran.message == "Finished after 0 s: the program left on line 3."


def test_a_long_goodbye_is_cut(run: Run) -> None:
    assert len(run("import sys\nsys.exit('x' * 10_000_000)").console) == 1001


def test_threads_are_refused(run: Run) -> None:
    ran = run("import threading\nthreading.Thread(target=print).start()")
    assert ran.fault["line"] == 2
    assert ran.fault["type"] == "RuntimeError"
    assert ran.fault["message"].startswith("a program can't start threads")


def test_what_is_written_must_be_text(run: Run) -> None:
    fault = run("import sys\nsys.stdout.write(5)").fault
    assert fault["message"] == "sys.stdout.write(text) wants a text; it got 5"
    assert fault["type"] == "TypeError"
    assert (
        run("import sys\nprint(sys.stderr.write('abc'), sys.stdout.writable())").console
        == "abc3 True\n"
    )


# -- limits --------------------------------------------------------------------


def test_six_hundred_seconds_may_pass_and_no_more(run_calls: Run) -> None:
    assert run_calls("wait(600)").status == "finished"
    ran = run_calls("forward(10)\nfor i in range(7):\n    wait(100)")
    assert (ran.status, ran.seconds) == ("limit", 600)
    assert ran.message == (
        "Stopped on line 4 after 600 simulated seconds: one run may last no longer. "
        "A loop that should end on its own needs a condition, or break."
    )
    assert ran.of_kind("pose")[-1]["t"] == 600


def test_printing_ends_after_two_megabytes_and_is_kept(run: Run) -> None:
    ran = run("print('begin')\nfor _ in range(10_000):\n    print('x' * 999)")
    assert ran.status == "limit"
    assert len(ran.console) == 2_000_000
    assert ran.console.startswith("begin\nxxx")
    assert ran.message.startswith(
        "Stopped on line 3 after printing 2 MB: one run may print no more."
    )


def test_one_huge_print_is_cut_where_the_limit_is(run: Run) -> None:
    ran = run("print('x' * 5_000_000)")
    assert (ran.status, len(ran.console)) == ("limit", 2_000_000)


def test_recording_ends_after_its_limit(run_calls: Run) -> None:
    ran = run_calls(
        "i = 0\nwhile True:\n    i += 1\n    draw('a', [(i % 300, 0)] * 500)",
        limits=Limits(trace_bytes=1_000_000),
    )
    assert ran.status == "limit"
    assert ran.message.startswith("Stopped on line 5 after recording 1 MB, most of it drawing:")
    assert 400 < len(ran.of_kind("layer")) < 520


@pytest.mark.parametrize(
    ("program", "line"),
    [
        ("while True:\n    try:\n        wait(100)\n    except:\n        pass", 4),
        (
            "while 1:\n    try:\n        wait(100)\n    except BaseException:\n        print('no')",
            4,
        ),
        ("try:\n    wait(700)\nexcept BaseException:\n    raise ValueError('mine')", 3),
        ("try:\n    wait(700)\nexcept BaseException:\n    print('on')", 3),
        ("try:\n    wait(700)\nfinally:\n    wait(1)", 3),
        ("try:\n    wait(700)\nexcept Exception:\n    print('not reached')", 3),
    ],
)
def test_a_limit_cannot_be_swallowed(run_calls: Run, program: str, line: int) -> None:
    ran = run_calls(program)
    assert (ran.status, ran.seconds, ran.fault) == ("limit", 600, None)
    assert ran.message.startswith(f"Stopped on line {line} after 600 simulated seconds")


def test_a_swallowed_limit_comes_again_on_the_very_next_lines(
    run_calls: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without waiting for the watchdog, which a browser does not have."""
    tally = SimpleNamespace(caught=0)
    monkeypatch.setitem(sys.modules, "tally", tally)
    ran = run_calls("""
        import tally
        def step():
            wait(300)
        while True:
            try:
                step()
            except:
                tally.caught += 1
    """)
    assert ran.status == "limit"
    assert tally.caught <= 2


@pytest.mark.parametrize(
    ("program", "lines"),
    [
        ("while True:\n    pass", {2, 3}),
        ("while True:\n    try:\n        pass\n    except:\n        pass", {2, 3, 4}),
        ("n = 0\nwhile True:\n    n += 1\n    wait(0)", {3, 4, 5}),
    ],
)
def test_computing_for_ever_is_ended(run_calls: Run, program: str, lines: set[int]) -> None:
    ran = run_calls(program, limits=Limits(silent_s=0.2))
    assert ran.status == "limit"
    assert int(ran.message.split()[3]) in lines
    assert (
        "after 0.2 s of computing in which no simulated time passed. "
        "If a loop waits for the robot there, put wait(0.1) into it." in ran.message
    )


class Looks:
    """The watchdog's event and clock: each look is 0.2 s after the one before."""

    def __init__(self, count: int) -> None:
        self.t, self._left = 0.0, count

    def wait(self, _timeout: float) -> bool:
        self.t, self._left = self.t + 0.2, self._left - 1
        return self._left < 0

    def monotonic(self) -> float:
        return self.t


@pytest.mark.parametrize(
    ("simulated", "ended"),
    [
        (lambda real: real, False),  # time passes at every look
        (lambda real: real // 0.5, False),  # only now and then, but soon enough
        (lambda real: real // 1.5, True),  # too seldom
    ],
)
def test_only_a_long_silence_is_ended_however_long_the_run(
    monkeypatch: pytest.MonkeyPatch, simulated: Callable[[float], float], ended: bool
) -> None:
    looks = Looks(40)
    monkeypatch.setattr(watchdog, "monotonic", looks.monotonic)
    monkeypatch.setattr(watchdog, "interrupt_main", lambda: None)
    meter = Meter(Limits(silent_s=0.9), Trace("", {}, 0), "program.py")
    clock = watchdog._Clock(meter, lambda: simulated(looks.t), None)
    watchdog._watch(meter, clock, looks, None)  # type: ignore[arg-type]
    assert (meter.over is not None) == ended


def test_ctrl_c_stops_the_run(run: Run) -> None:
    ran = run("""
        import os, signal
        os.kill(os.getpid(), signal.SIGINT)
        while True:
            pass
    """)
    assert ran.status == "stopped"
    assert ran.message.startswith("Stopped on line ")
    assert ran.message.endswith("after 0 s.")
    assert ran.fault is None


def test_a_program_that_no_interruption_reaches_is_given_up(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """In real use `on_stuck` ends the process; here it only makes the program give way."""
    monkeypatch.setattr(watchdog, "_GRACE_S", 0.05)
    monkeypatch.setattr(watchdog, "interrupt_main", lambda: None)
    given_up: list[dict[str, Any]] = []

    def give_way(trace: Trace) -> None:
        given_up.extend(trace.of_kind("end"))
        builtins.give_way = True  # type: ignore[attr-defined]

    program = "import builtins\nwhile not hasattr(builtins, 'give_way'):\n    pass\n"
    run_program(program, "empty", 1, limits=Limits(silent_s=0.1), on_stuck=give_way)
    assert [end["status"] for end in given_up] == ["limit"]
    assert not hasattr(builtins, "give_way")


def test_an_error_whose_text_never_ends_is_a_limit(run: Run) -> None:
    program = """
        class Endless(Exception):
            def __str__(self):
                while True:
                    pass
        raise Endless
    """
    assert run(program, limits=Limits(silent_s=0.2)).status == "limit"


def test_what_an_errors_text_prints_goes_to_the_console(run: Run) -> None:
    program = """
        class Chatty(Exception):
            def __str__(self):
                print("hello")
                return "words"
        raise Chatty
    """
    ran = run(program)
    assert ran.fault["message"] == "words"
    assert "hello" in ran.console
