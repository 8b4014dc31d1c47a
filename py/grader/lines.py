"""A line of the chart, and what is expected of it.

May import: the standard library.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from grader.runs import Run

__all__ = ["Line"]

Points = Sequence[tuple[float, float]]
"""Seconds and value of each."""


class Line:
    """Each expectation returns the line, so that they can be written one after the other."""

    def __init__(self, run: Run, name: str, points: list[tuple[float, float]]) -> None:
        self.run = run
        self.name = name
        self.points = points

    @property
    def end(self) -> float:
        """The last value."""
        return self.points[-1][1]

    @property
    def highest(self) -> float:
        """The highest value."""
        return max(value for _, value in self.points)

    @property
    def lowest(self) -> float:
        """The lowest value."""
        return min(value for _, value in self.points)

    def at(self, seconds: float) -> float:
        """The value at a time: the last point up to then, or the first of all."""
        return _value_at(self.points, seconds)

    def ends(self, at_least: float | None = None, at_most: float | None = None) -> Line:
        """Expect the last value within bounds."""
        self._within("ends", self.points[-1], at_least, at_most)
        return self

    def stays(self, at_least: float | None = None, at_most: float | None = None) -> Line:
        """Expect every value within bounds."""
        for point in self.points:
            self._within("stays", point, at_least, at_most)
        return self

    def reaches(self, value: float, by: float | None = None) -> Line:
        """Expect the line to get to a value from below or above, by a time [s] if need be."""
        rising = self.points[0][1] < value
        end = self.points[-1][0] if by is None else by
        within = [each for t, each in self.points if t <= end + 1e-9]
        if not any(each >= value if rising else each <= value for each in within):
            nearest = (max if rising else min)(within, default=self.points[0][1])
            when = "" if by is None else f" by {by:g} s"
            raise self.run.failure(
                f'the line "{self.name}" to reach {value:g}{when}',
                f"it only gets to {nearest:.3g}",
                seconds=by,
            )
        return self

    def follows(self, reference: Points, within: float, or_else: Points = ()) -> Line:
        """Expect each point within so much of a reference's value at its time.

        or_else  another reference, if there are two ways to be right: all follow the one or the
                 other
        """
        if not reference:
            raise self.run.failure("a scan to plot something of", "the run has none")
        apart = self._apart(reference, within)
        if apart is None or (or_else and self._apart(or_else, within) is None):
            return self
        t, value, right = apart
        raise self.run.failure(
            f'the line "{self.name}" at {right:.3f} after {t:.2f} s', f"{value:.3f}", seconds=t
        )

    def _apart(self, reference: Points, within: float) -> tuple[float, float, float] | None:
        """The first point too far from a reference: its time, its value, what is right there."""
        for t, value in self.points:
            right = _value_at(reference, t)
            # What is plotted just before the scan of the same moment is right as well.
            before = _value_at(reference, t - 1e-6)
            if min(abs(value - right), abs(value - before)) > within:
                return t, value, right
        return None

    def _within(
        self, verb: str, point: tuple[float, float], low: float | None, high: float | None
    ) -> None:
        t, value = point
        if low is not None and value < low:
            wanted = f"at {low:g} or above"
        elif high is not None and value > high:
            wanted = f"at {high:g} or below"
        else:
            return
        raise self.run.failure(
            f'a line "{self.name}" that {verb} {wanted}', f"{value:.4g} at {t:.2f} s", seconds=t
        )


def _value_at(points: Points, seconds: float) -> float:
    index = bisect_right(points, (seconds + 1e-9, float("inf")))
    return points[max(0, index - 1)][1]
