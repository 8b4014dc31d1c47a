"""What a fault tells: its type, words, line, and the learner's own frames only."""

from collections.abc import Callable
from typing import Any

import pytest

from bugbot.run import slips
from bugbot.run.faults import fault_of
from bugbot.sim import simulator

Run = Callable[..., Any]


def test_the_line_is_the_innermost_of_the_learners(run: Run) -> None:
    ran = run("""
        from bugbot import *
        import json

        def inner():
            wait("long")

        def outer():
            inner()

        outer()
    """)
    assert ran.status == "fault"
    assert ran.fault["line"] == 5
    assert ran.message == (
        "Stopped by an error on line 5: wait(seconds) wants a number of 0 or more; it got 'long'"
    )
    (fault,) = ran.of_kind("fault")
    assert fault["traceback"] == (
        "Traceback (most recent call last):\n"
        '  File "program.py", line 10, in <module>\n'
        "    outer()\n"
        '  File "program.py", line 8, in outer\n'
        "    inner()\n"
        '  File "program.py", line 5, in inner\n'
        '    wait("long")\n'
        "TypeError: wait(seconds) wants a number of 0 or more; it got 'long'\n"
    )


def test_an_error_raised_in_a_library_is_on_the_learners_line(run: Run) -> None:
    ran = run("import json\n\nx = json.loads('{')\n")
    assert (ran.fault["type"], ran.fault["line"]) == ("JSONDecodeError", 3)
    (fault,) = ran.of_kind("fault")
    assert "json/decoder" not in fault["traceback"]


@pytest.mark.parametrize(
    ("program", "kind", "message"),
    [
        ("x", "NameError", "name 'x' is not defined"),
        ("1 / 0", "ZeroDivisionError", "division by zero"),
        ("1.0 % 0", "ZeroDivisionError", "division by zero"),
        ("{}['a']", "KeyError", "there is no key 'a'"),
        ("raise KeyError", "KeyError", "a KeyError, without a message"),
        ("raise IndexError", "IndexError", "an IndexError, without a message"),
        ("raise OSError", "OSError", "an OSError, without a message"),
        ("raise UnicodeError", "UnicodeError", "a UnicodeError, without a message"),
        ("raise UnboundLocalError", "UnboundLocalError", "an UnboundLocalError, without a message"),
        (
            "class HTTPError(Exception):\n    pass\nraise HTTPError",
            "HTTPError",
            "an HTTPError, without a message",
        ),
        ("assert 1 == 2", "AssertionError", "what the assert says is not so"),
        ("assert 1 == 2, 'as I said'", "AssertionError", "as I said"),
        ("next(iter([]))", "StopIteration", "a StopIteration, without a message"),
        ("x = [0] * 10**14", "MemoryError", "the program wants more memory than there is"),
        ("raise ZeroDivisionError('mine')", "ZeroDivisionError", "mine"),
        ("class E(Exception): pass\nraise E('mine')", "E", "mine"),
        ("class E(BaseException): pass\nraise E('mine')", "E", "mine"),
        ("from bugbot import *\nraise BugbotError('mine')", "Exception", "mine"),
        ("x = = 3", "SyntaxError", "this can't be read as Python (invalid syntax)"),
        ("x = 'a", "SyntaxError", "unterminated string literal"),
        ("x = 1\n  y = 2", "IndentationError", "unexpected indent"),
        ("raise ValueError('x' * 5000)", "ValueError", "x" * 1999 + "…"),
        ("raise SyntaxError", "SyntaxError", "a SyntaxError, without a message"),
        ("exec('x =')", "SyntaxError", "this can't be read as Python (invalid syntax)"),
        (
            "raise ExceptionGroup('g', [ValueError('a'), ExceptionGroup('h', [KeyError(1)])])",
            "ExceptionGroup",
            "2 errors at once: ValueError: a; ExceptionGroup: h (1 sub-exception)",
        ),
    ],
)
def test_the_words_are_pythons_or_plainer(run: Run, program: str, kind: str, message: str) -> None:
    fault = run(program).fault
    assert (fault["type"], fault["message"]) == (kind, message)
    assert fault["line"] == len(program.splitlines())


def test_an_error_whose_own_text_fails_is_told_without_it(run: Run) -> None:
    ran = run("""
        class Broken(Exception):
            def __str__(self):
                return 1 / 0
        raise Broken
    """)
    assert ran.fault["type"] == "Broken"
    assert ran.fault["line"] == 4
    assert ran.fault["message"] == "(its own text can't be shown: ZeroDivisionError)"


def traceback(ran: Any) -> str:
    (fault,) = ran.of_kind("fault")
    return str(fault["traceback"])


def test_a_chain_of_errors_is_told_from_the_first(run: Run) -> None:
    ran = run("""
        try:
            try:
                {}["a"]
            except KeyError as error:
                raise ValueError("second") from error
        except ValueError:
            print(1 / 0)
    """)
    assert ran.fault["type"] == "ZeroDivisionError"
    assert ran.fault["line"] == 7
    heads = [line for line in traceback(ran).splitlines() if not line.startswith((" ", "Trace"))]
    assert heads == [
        "KeyError: there is no key 'a'",
        "",
        "That error led to this one:",
        "",
        "ValueError: second",
        "",
        "While that was handled, this:",
        "",
        "ZeroDivisionError: division by zero",
    ]


def test_from_none_hides_the_cause(run: Run) -> None:
    ran = run("""
        try:
            1 / 0
        except ZeroDivisionError:
            raise ValueError("plain") from None
    """)
    assert "ZeroDivisionError" not in traceback(ran)


def test_a_chain_that_bites_its_tail_or_is_very_long_ends(run: Run) -> None:
    ring = run("""
        a, b = ValueError("a"), ValueError("b")
        a.__cause__, b.__cause__ = b, a
        raise a
    """)
    assert traceback(ring).count("ValueError: ") == 2
    long = run("""
        error = None
        for i in range(100):
            new = ValueError(str(i))
            new.__cause__ = error
            error = new
        raise error
    """)
    assert traceback(long).count("ValueError: ") == 11


def test_deep_recursion_is_cut_in_the_middle(run: Run) -> None:
    ran = run("""
        def down(n):
            return down(n + 1)
        def begin():
            return down(0)
        begin()
    """)
    assert (ran.fault["type"], ran.fault["line"]) == ("RecursionError", 2)
    text = traceback(ran)
    assert text.count("in down") < 25
    assert "in begin" in text
    assert " more calls …\n" in text
    assert len(text) < 3000


def test_recursion_ends_at_the_same_depth_wherever_it_is_run_from(run: Run) -> None:
    program = """
        depth = 0
        def down():
            global depth
            depth += 1
            down()
        try:
            down()
        except RecursionError:
            print(depth)
    """

    def deeper(levels: int) -> str:
        return deeper(levels - 1) if levels else str(run(program).console)

    assert deeper(0) == deeper(40)


def test_long_lines_of_the_program_are_cut(run: Run) -> None:
    ran = run("x = 1 / 0 " + "+ 1 " * 1000)
    assert len(traceback(ran)) < 400


def test_a_group_raised_inside_a_library_takes_the_line_of_its_first_part() -> None:
    namespace: dict[str, Any] = {}
    exec(compile("def f():\n    1 / 0\n", "program.py", "exec"), namespace)
    parts: list[Exception] = []
    try:
        namespace["f"]()
    except ZeroDivisionError as error:
        parts.append(error)
    fault = fault_of(ExceptionGroup("g", parts), "def f():\n    1 / 0\n", "program.py")
    assert fault.line == 2
    assert fault.message == "1 error at once: ZeroDivisionError: division by zero"


def test_an_error_from_nowhere_has_no_line() -> None:
    fault = fault_of(ValueError("lost"), "", "program.py")
    assert (fault.line, fault.hint, fault.traceback) == (None, None, "ValueError: lost\n")


def test_a_fault_of_ours_is_said_to_be_ours(
    run_calls: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(simulator, "_BATTERY_S", 0)
    ran = run_calls("battery()")
    assert ran.fault == {
        "type": "ZeroDivisionError",
        "message": "bugbot itself failed here, which is our fault and not yours: division by zero",
        "line": 2,
        "hint": None,
    }


def test_an_error_of_the_learners_inside_our_call_is_theirs(run_calls: Run) -> None:
    ran = run_calls("def points():\n    yield 1 / 0\ndraw('a', points())")
    assert (ran.fault["line"], ran.fault["message"]) == (3, "division by zero")


def test_an_error_is_told_even_if_no_cause_can_be_looked_for(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(_case: object) -> str:
        raise KeyError("warnings")

    monkeypatch.setattr(slips, "_ORDER", (broken,))
    ran = run("x = 1 / 0")
    assert (ran.fault["type"], ran.fault["line"], ran.fault["hint"]) == (
        "ZeroDivisionError",
        1,
        None,
    )
