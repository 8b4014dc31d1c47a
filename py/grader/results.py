"""What a mark reports of its trials: each run with its map, and the score of all.

May import: the standard library, `mapping`, the rest of `grader`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from grader.failures import AuthorError
from grader.maps import Map
from grader.runs import Run
from grader.trials import Trial
from mapping.frontiers import State

__all__ = ["FREE", "OCCUPIED", "UNKNOWN", "WRONG_FLOOR", "WRONG_WALL", "result_of", "score_of"]

UNKNOWN, FREE, OCCUPIED, WRONG_WALL, WRONG_FLOOR = "?", ".", "#", "!", "x"
"""A cell of a map, in a result."""

_SIGNS = {State.UNKNOWN: UNKNOWN, State.FREE: FREE, State.OCCUPIED: OCCUPIED}
_LONGEST_WHY = 200
_MOST_PLACES = 250
"""Of a path: enough to draw it small."""


def result_of(trial: Trial, check: int) -> dict[str, Any]:
    """A trial as a mark has it; `check` is the place of its check in the mark."""
    return {
        "check": check,
        **trial.run.place,
        "layers": trial.layers,
        "ended": trial.run.ending.kind,
        "why": trial.why[:_LONGEST_WHY],
        "figures": trial.figures,
        "points": trial.points,
        "passed": not trial.failures,
        "map": None if trial.drawn is None else _map_of(trial.drawn),
        "path": _path_of(trial.run) if trial.run.is_honest else [],
    }


def score_of(trials: Sequence[Trial]) -> dict[str, Any] | None:
    """The score of all trials that are worth something; None if none is."""
    found = {trial.scoring for trial in trials if trial.scoring is not None}
    if not found:
        return None
    if len(found) > 1:
        raise AuthorError("its trials are scored in different ways: one scoring(…) is enough")
    (scoring,) = found
    points = [trial.points for trial in trials if trial.points is not None]
    return {"value": round(sum(points) / len(points), 1), "of": scoring.of, "how": scoring.how}


def _map_of(drawn: Map) -> dict[str, Any]:
    """One letter a cell, row after row from the bottom."""
    signs = [_SIGNS[state] for state in drawn.states]
    for index in drawn.score.wrong_walls:
        signs[index] = WRONG_WALL
    for index in drawn.score.wrong_floor:
        signs[index] = WRONG_FLOOR
    return {"across": drawn.grid.across, "cell_cm": drawn.grid.cell_cm, "cells": "".join(signs)}


def _path_of(run: Run) -> list[list[float]]:
    """Some of the places the robot has been at, from its first to its last [cm]."""
    step = max(1, -(-len(run.path) // _MOST_PLACES))
    places = [*run.path[::step], *run.path[-1:]]
    return [[round(x, 1), round(y, 1)] for _, x, y, _ in places]
