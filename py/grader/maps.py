"""The map that a run has drawn, and what is expected of it.

May import: the standard library, `bugbot.errors`, `mapping`, `grader.failures`, `grader.naming`,
`grader.scans`.

A map is judged by what is drawn on the mat: squares in two layers, one of the cells that it calls
free and one of those it calls occupied. What variables hold it in the program is nobody's business,
nor is the rule by which it turns beams into cells. It is held against two things: what really
stands on the mat (`mapping.score`), and what the run's own beams say (`mapping.evidence`).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import ceil
from typing import TYPE_CHECKING, Any

from bugbot.errors import WrongValueError, counted, with_article
from bugbot.frames import MAT_CM
from grader.naming import perhaps_meant, what_there_is
from mapping.frontiers import State, known_states
from mapping.grid import Grid
from mapping.mapper import Mapper
from mapping.score import Score, score, surfaces_found

if TYPE_CHECKING:
    from grader.runs import Run
    from mapping.evidence import Evidence

__all__ = ["Map", "drawn_map", "reference_map"]

_OFF_CENTRE = 0.25
"""A square may be so much of its side from the middle of its cell."""


class Map:
    """What is known of each cell, drawn by a run or made by the reference.

    known   log odds of the beams that a cell must be beyond to count as known
    off_by  how far the poses it was made with may be off [cm]; 0 if the camera told them

    Each expectation returns the map, so that they can be written one after the other.
    """

    def __init__(
        self,
        run: Run,
        grid: Grid,
        states: Sequence[State],
        seconds: float,
        known: float = 0.0,
        off_by: float = 0.0,
    ) -> None:
        self.run = run
        self.grid = grid
        self.states = list(states)
        self.seconds = seconds
        self._known = known
        self._off_by = off_by

    # -- values --------------------------------------------------------------

    @cached_property
    def score(self) -> Score:
        """The map against the truth, as `mapping.score` counts."""
        return score(self.grid, self.states, self.run.obstacles)

    @cached_property
    def _said(self) -> list[int]:
        return [index for index, state in enumerate(self.states) if state is not State.UNKNOWN]

    @property
    def _evidence(self) -> Evidence:
        return self.run.evidence(self.grid, self.seconds)

    @cached_property
    def unsupported(self) -> list[int]:
        """The cells it calls known without support from the beams; none where poses may be off."""
        if self._off_by:
            return []
        supports = self._evidence.supports
        return [each for each in self._said if not supports(each, self.states[each], self._known)]

    @property
    def known_percent(self) -> float:
        """Share of the mat that is known, with the beams' support, 0 to 100."""
        return 100.0 * (len(self._said) - len(self.unsupported)) / len(self.states)

    @property
    def unsupported_percent(self) -> float:
        """Share of the mat that it calls known without support from its beams, 0 to 100."""
        return 100.0 * len(self.unsupported) / len(self.states)

    @cached_property
    def backed_percent(self) -> float:
        """Share of the mat that is known, and would be by any rule for its floor, 0 to 100."""
        backs = self._evidence.backs
        backed = sum(backs(each, self.states[each], self._known) for each in self._said)
        return 100.0 * backed / len(self.states)

    @cached_property
    def _surfaces(self) -> tuple[list[int], list[int]]:
        return surfaces_found(self.grid, self.states, self.run.surfaces(self.grid, self.seconds))

    @property
    def walls_found_percent(self) -> float:
        """Share of the surfaces met by three beams or more that it shows; 100 if there is none."""
        found, missed = self._surfaces
        return 100.0 * len(found) / (len(found) + len(missed)) if found or missed else 100.0

    # -- expectations --------------------------------------------------------

    def known(self, at_least: float = 0.0, at_most: float = 100.0) -> Map:
        """Expect so many per cent of the mat to be known, free or occupied, by the beams' word."""
        percent = self.known_percent
        if percent < at_least:
            unknown = self._cells(i for i, s in enumerate(self.states) if s is State.UNKNOWN)
            got = f"{percent:.1f} %"
            if self.unsupported_percent >= 0.5:
                unknown = self._cells(self.unsupported)
                got += (
                    f", not counting {counted(len(self.unsupported), 'cell')} drawn though the "
                    "beams don't say so"
                )
            self._fail(f"at least {at_least:g} % of the mat known", got, unknown)
        if percent > at_most:
            words = f"at most {at_most:g} % of the mat known: the rest can't be seen from there"
            self._fail(words, f"{percent:.1f} %", [])
        return self

    def wrong_walls(self, at_most: float) -> Map:
        """Expect at most so many per cent of the occupied cells to have nothing real near."""
        percent = self.score.wrong_walls_percent
        if percent > at_most:
            self._fail(
                f"at most {at_most:g} % of the occupied cells more than a cell from anything real",
                f"{percent:.1f} %: {len(self.score.wrong_walls)} of "
                f"{counted(self.score.occupied, 'cell')}",
                self._cells(self.score.wrong_walls),
            )
        return self

    def wrong_floor(self, at_most: float) -> Map:
        """Expect at most so many per cent of the free cells to be inside an obstacle."""
        wrong, free = self.score.wrong_floor, self.score.free
        percent = self.score.wrong_floor_percent
        if percent > at_most:
            self._fail(
                f"at most {at_most:g} % of the free cells inside something solid",
                f"{percent:.1f} %: {len(wrong)} of {counted(free, 'cell')}",
                self._cells(wrong),
            )
        return self

    def walls_found(self, at_least: float) -> Map:
        """Expect the map to show so many per cent of the surfaces that its beams have met."""
        percent = self.walls_found_percent
        if percent < at_least:
            found, missed = self._surfaces
            self._fail(
                f"at least {at_least:g} % of the walls that its beams have met to be black, "
                "give or take a cell",
                f"{percent:.1f} %: {len(found)} of {counted(len(found) + len(missed), 'place')}",
                self._cells(missed),
            )
        return self

    def unsupported_cells(self, at_most: float) -> Map:
        """Expect at most so many per cent of its known cells to be without the beams' support."""
        cells = self.unsupported
        percent = 100.0 * len(cells) / max(1, len(self._said))
        if percent > at_most:
            self._fail(
                f"of the cells it draws free or occupied, at most {at_most:g} % without enough "
                "evidence from the beams",
                f"{percent:.1f} %: {len(cells)} of {counted(len(self._said), 'cell')}",
                self._cells(cells),
            )
        return self

    def plain(self, floor_at_least: float, walls_at_least: float) -> Map:
        """Expect what the beams leave no doubt of: so many per cent of that floor and those walls.

        Whatever rule a map is made by, these cells come out the same.
        """
        plain = [self._evidence.plain(index) for index in range(len(self.states))]
        for state, at_least, what in (
            (State.FREE, floor_at_least, "floor"),
            (State.OCCUPIED, walls_at_least, "wall"),
        ):
            there = [index for index, each in enumerate(plain) if each is state]
            other = [index for index in there if self.states[index] is not state]
            if 100.0 * (len(there) - len(other)) < at_least * len(there):
                self._fail(
                    f"at least {at_least:g} % of the cells that are plainly {what}, by what the "
                    f"beams read, drawn as {state.name.lower()}",
                    f"{100.0 - 100.0 * len(other) / len(there):.1f} %: "
                    f"{len(other)} of {len(there):,} "
                    f"{'is' if len(other) == 1 else 'are'} not",
                    self._cells(other),
                )
        return self

    def cells_of(self, cell_cm: float) -> Map:
        """Expect cells of this side [cm]."""
        if abs(self.grid.cell_cm - cell_cm) > 1e-6:
            self._fail(f"cells of {cell_cm:g} cm", f"cells of {self.grid.cell_cm:g} cm", [])
        return self

    def cell(self, x: float, y: float, state: str) -> Map:
        """Expect the cell that holds a point to be "free", "occupied" or "unknown"."""
        wanted = State[state.upper()]
        index = self.grid.index_at(x, y)
        if index is not None and self.states[index] is not wanted:
            self._fail(
                f"{with_article(state)} cell at ({x:g}, {y:g})",
                self.states[index].name.lower(),
                self._cells([index]),
            )
        return self

    def agrees(self, other: Map, at_least: float = 95.0) -> Map:
        """Expect so many per cent of the cells known in either map to be the same in both."""
        self.cells_of(other.grid.cell_cm)
        percent = self.agreement(other)
        if percent < at_least:
            differing = [
                index
                for index, pair in enumerate(zip(self.states, other.states, strict=True))
                if pair[0] is not pair[1]
            ]
            self._fail(
                f"a map that agrees with its scans in at least {at_least:g} % of the known cells",
                f"{percent:.1f} %: {counted(len(differing), 'cell differs', 'cells differ')}",
                self._cells(differing),
            )
        return self

    # -- likeness, for naming mistakes ---------------------------------------

    def agreement(self, other: Map) -> float:
        """Per cent of the cells known in either map that are the same in both; 0 if none are."""
        if len(self.states) != len(other.states):
            return 0.0
        pairs = [
            pair
            for pair in zip(self.states, other.states, strict=True)
            if pair != (State.UNKNOWN, State.UNKNOWN)
        ]
        return 100.0 * sum(a is b for a, b in pairs) / max(1, len(pairs))

    def looks_like(self, other: Map, at_least: float = 97.0) -> bool:
        """Whether it is (nearly) that map, and more so than the right one: for naming slips."""
        agreement = self.agreement(other)
        right = self.run.mapped(cell_cm=other.grid.cell_cm)
        return agreement >= at_least and agreement > self.agreement(right)

    # -- evidence ------------------------------------------------------------

    def must_have_been_seen(self) -> None:
        """Refuse a map of cells where no beam has been, or of which the beams say the opposite."""
        reach = 1 + ceil(self._off_by / self.grid.cell_cm)
        allows = self._evidence.allows
        unseen = [each for each in self._said if not allows(each, self.states[each], reach)]
        if len(unseen) > max(3, len(self._said) // 50):
            raise self.run.failure(
                "a map of what the beams of this run have seen",
                f"{len(unseen)} of its {len(self._said)} known cells lie where no beam has been, "
                "or are the opposite of what the beams say",
                cells=self._cells(unseen),
                cell_cm=self.grid.cell_cm,
                seconds=self.seconds,
            )

    # -- inside --------------------------------------------------------------

    def _cells(self, indices: Any) -> list[tuple[int, int]]:
        return [self.grid.cell(index) for index in indices]

    def _fail(self, expected: str, got: str, cells: list[tuple[int, int]]) -> None:
        raise self.run.failure(
            expected, got, cells=cells, cell_cm=self.grid.cell_cm, seconds=self.seconds
        )


def reference_map(run: Run, mapper: Mapper, known: float, seconds: float) -> Map:
    """The map that a mapper of the reference has made of a run's scans."""
    return Map(run, mapper.grid, known_states(mapper.grid.cells, known), seconds, known)


def drawn_map(
    run: Run,
    layers: dict[str, State],
    seconds: float,
    known: float = 0.0,
    off_by: float = 0.0,
) -> Map:
    """The map in those layers as they were at a time; fails if it is none."""
    grid: Grid | None = None
    states: list[State] = []
    for name, state in layers.items():
        drawn = _layer(run, name, seconds)
        if drawn["shape"] != "squares":
            raise run.failure(
                f'the layer "{name}" drawn as squares',
                f"it is drawn as {drawn['shape']}",
                likely=f'the shape is missing: draw("{name}", points, colour, "squares", CELL)',
            )
        if grid is None:
            grid = _grid(run, name, drawn["size"])
            states = [State.UNKNOWN] * len(grid.cells)
        elif grid.cell_cm != drawn["size"]:
            raise run.failure(
                "all layers of the map with cells of one size",
                f'the squares of "{name}" are {drawn["size"]:g} cm wide, the others '
                f"{grid.cell_cm:g} cm",
            )
        _fill(run, grid, states, name, state, drawn["points"], seconds)
    assert grid is not None
    return Map(run, grid, states, seconds, known, off_by)


def _layer(run: Run, name: str, seconds: float) -> dict[str, Any]:
    layers = run.layers(seconds)
    if name not in layers:
        raise run.failure(
            f'a layer named "{name}", drawn with draw("{name}", …)',
            what_there_is("layer", "layers", layers),
            likely=perhaps_meant("layer", name, layers),
        )
    return layers[name]


def _grid(run: Run, name: str, size: float) -> Grid:
    try:
        return Grid(size)
    except WrongValueError:
        raise run.failure(
            f'squares as large as a cell in the layer "{name}"', f"squares of {size:g} cm"
        ) from None


def _fill(
    run: Run,
    grid: Grid,
    states: list[State],
    name: str,
    state: State,
    points: list[tuple[float, float]],
    seconds: float,
) -> None:
    both = []
    for x, y in points:
        # Cells that hang over the far edges have their middle beyond the mat.
        index = grid.index_at(min(x, MAT_CM - 1e-6), min(y, MAT_CM - 1e-6))
        off = 0.0
        if index is not None:
            middle = grid.centre(index)
            off = max(abs(x - middle[0]), abs(y - middle[1]))
        if index is None or off > _OFF_CENTRE * grid.cell_cm:
            what = "beyond the mat" if index is None else "not in the middle of a cell"
            raise run.failure(
                f'each square of the layer "{name}" in the middle of a cell of {grid.cell_cm:g} cm',
                f"the square at ({x:g}, {y:g}) is {what}",
                likely=None
                if index is None
                else "a square is drawn round its point: the middle is half a cell from the corner",
                seconds=seconds,
            )
        if states[index] not in (State.UNKNOWN, state):
            both.append(grid.cell(index))
        states[index] = state
    if both:
        raise run.failure(
            "each cell either free or occupied",
            f"{counted(len(both), 'cell is', 'cells are')} drawn as both",
            cells=both,
            cell_cm=grid.cell_cm,
            seconds=seconds,
        )
