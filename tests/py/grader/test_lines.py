"""Lines of the chart, of two or three points each."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

import pytest

from grader.failures import CheckFailed
from grader.lines import Line

if TYPE_CHECKING:
    from grader.runs import Run


class AnyRun:
    """What a line asks of its run."""

    def failure(self, expected: str, got: str, *, seconds: float | None = None) -> CheckFailed:
        return CheckFailed(expected, got, where={"seconds": seconds})


def line(*points: tuple[float, float]) -> Line:
    return Line(cast("Run", AnyRun()), "a", list(points))


RISING = line((0, 1), (1, 2), (2, 4))
FALLING = line((0, 4), (1, 2), (2, 1))
LATE = line((5, 7), (6, 8))

SAID = [(0, 3), (1, 5), (2, 9)]
"""What a reference says at 0, 1 and 2 s."""


def test_the_value_at_a_time_is_that_of_the_last_point_up_to_then() -> None:
    assert [RISING.at(t) for t in (-1, 0, 0.5, 1, 1.5, 2, 9)] == [1, 1, 1, 2, 2, 4, 4]
    assert (RISING.end, RISING.highest, FALLING.end, FALLING.lowest) == (4, 4, 1, 1)


@pytest.mark.parametrize(
    "expectation",
    [
        lambda: RISING.ends(at_least=4, at_most=4),
        lambda: RISING.stays(at_least=1, at_most=4),
        lambda: RISING.reaches(4),
        lambda: RISING.reaches(2, by=1),
        lambda: FALLING.reaches(1),
        lambda: FALLING.reaches(2, by=1),
        lambda: line((0, 3), (1, 5), (2, 9)).follows(SAID, within=0.0),
        lambda: line((0, 8), (1, 8)).follows(SAID, 0.0, or_else=[(0, 8)]),
        # Plotted just before the scan of the same moment.
        lambda: line((1, 3), (2, 5)).follows(SAID, within=0.0),
        lambda: line((0, 2.5), (1, 5.5)).follows(SAID, within=0.5),
    ],
)
def test_what_a_line_does(expectation: Callable[[], Line]) -> None:
    assert expectation() is not None


@pytest.mark.parametrize(
    ("expectation", "expected", "got", "seconds"),
    [
        (lambda: RISING.ends(at_most=3), 'a line "a" that ends at 3 or below', "4 at 2.00 s", 2),
        (lambda: RISING.stays(at_least=2), 'a line "a" that stays at 2 or above', "1 at 0.00 s", 0),
        (lambda: RISING.stays(at_most=3), 'a line "a" that stays at 3 or below', "4 at 2.00 s", 2),
        (lambda: RISING.reaches(5), 'the line "a" to reach 5', "it only gets to 4", None),
        (
            lambda: RISING.reaches(4, by=1),
            'the line "a" to reach 4 by 1 s',
            "it only gets to 2",
            1,
        ),
        (lambda: FALLING.reaches(0), 'the line "a" to reach 0', "it only gets to 1", None),
        (
            lambda: LATE.reaches(8, by=1),
            'the line "a" to reach 8 by 1 s',
            "it only gets to 7",
            1,
        ),
        (
            lambda: line((0, 3), (1, 8)).follows(SAID, 0, or_else=[(0, 8)]),  # half and half
            'the line "a" at 5.000 after 1.00 s',
            "8.000",
            1,
        ),
        (lambda: RISING.follows([], 1), "a scan to plot something of", "the run has none", None),
        (lambda: line((1, -5)).follows(SAID, 1), 'the line "a" at 5.000 after 1.00 s', "-5.000", 1),
        (lambda: line((1, -3)).follows(SAID, 1), 'the line "a" at 5.000 after 1.00 s', "-3.000", 1),
        (lambda: line((2, 3)).follows(SAID, 1), 'the line "a" at 9.000 after 2.00 s', "3.000", 2),
    ],
)
def test_what_a_line_does_not_do(
    expectation: Callable[[], Line], expected: str, got: str, seconds: float | None
) -> None:
    with pytest.raises(CheckFailed) as caught:
        expectation()
    failure = caught.value
    assert (failure.expected, failure.got, failure.where) == (expected, got, {"seconds": seconds})
