"""Scan matching: the pose at which what the robot sees agrees best with the map it has.

May import: the standard library, `bugbot.frames`, `bugbot.errors`, `mapping.beam`, `mapping.grid`,
`mapping.mapper`.

`match` is a correlative search: every pose of a small window round the guess is tried, and the
one whose hits fall on the most occupied cells wins. It can't be caught in a wrong valley as a
search downhill can, and it costs the same every time.

`Follower` is the front end of a mapper without exact poses: it adds up odometry, and every few
looks matches them with its own map. Two things keep it from following its own error:

* A few looks of the turning robot are gathered and matched as one. A single scan of eight beams
  over 39 degrees fits a wall nearly as well a little to the side, and what chance makes of that
  is drawn into the map, where the next scan finds it.
* It matches with the map of some seconds ago. A gyro turns the robot's belief by much less than a
  cell from one look to the next, so the looks of just now agree with the drift.

A laser scanner that sees all round needs neither. Larger programs add loop closure, which bends
the whole path when an old place comes back; here an error that was drawn once stays.

Where it comes from:
  E. Olson, "Real-time correlative scan matching", ICRA 2009
  W. Hess, D. Kohler, H. Rapp, D. Andor, "Real-time loop closure in 2D LIDAR SLAM", ICRA 2016
    (Cartographer: the search, which it uses to close loops and, if switched on, before least
    squares, and the penalty for leaving the guess); slam_toolbox's front end, K. Konolige's and
    SRI's Karto, matches every scan by such a search
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import exp, floor

from bugbot.errors import WrongValueError, got
from bugbot.frames import direction, wrap_heading
from mapping.beam import FAR_CM
from mapping.grid import Grid, Point
from mapping.mapper import Mapper

__all__ = ["Follower", "Match", "Pose", "Window", "hits_of", "likelihoods", "match", "place"]

Pose = tuple[float, float, float]
"""x, y on the mat [cm], heading [degrees clockwise from up the mat]."""

Beams = Iterable[tuple[float, float]]
"""(angle from straight ahead [degrees], reading [cm]) pairs, as `scan()` gives them."""

_CERTAIN = 3.0
"""Log odds from which a wall counts in full: an old one then does not outweigh a fresh one."""

_BESIDE = 0.5
"""What a hit beside a wall is worth: nearly right, which leads the search there."""

_FEWEST_HITS = 8
"""With fewer hits a scan fits nearly anywhere, and the guess is kept."""

_POOREST_FIT = 0.3
"""With a poorer fit the scan shows what the map does not have yet, and the guess is kept."""


@dataclass(frozen=True, slots=True)
class Window:
    """The poses to try, and what it costs to leave the guess.

    turn_deg, turn_step_deg   headings up to so far from the guess, in such steps [degrees]
    shift_cm, shift_step_cm   places up to so far from it, along x and along y [cm]
    turn_cost, shift_cost     what fits d degrees or cm away is worth exp(-(cost * d)²) as much
    """

    turn_deg: float = 3.0
    turn_step_deg: float = 0.5
    shift_cm: float = 3.0
    shift_step_cm: float = 1.5
    turn_cost: float = 0.05
    shift_cost: float = 0.05

    def __post_init__(self) -> None:
        if not (self.turn_step_deg > 0 and self.shift_step_cm > 0):  # True for NaN too
            raise WrongValueError(
                f"Window wants steps above 0; it got {got(self.turn_step_deg)} degrees "
                f"and {got(self.shift_step_cm)} cm"
            )

    def turns(self) -> list[tuple[float, float]]:
        """The turns to try [degrees], and what each is worth; the smallest first."""
        steps = _steps(self.turn_deg, self.turn_step_deg)
        return [(turn, exp(-((self.turn_cost * turn) ** 2))) for turn in steps]

    def shifts(self) -> list[tuple[float, float, float]]:
        """The shifts to try, along x and along y [cm], and what each is worth; nearest first."""
        steps = _steps(self.shift_cm, self.shift_step_cm)
        found = [
            (dx, dy, exp(-(self.shift_cost**2) * (dx * dx + dy * dy)))
            for dx in steps
            for dy in steps
        ]
        return sorted(found, key=lambda shift: shift[0] ** 2 + shift[1] ** 2)


@dataclass(frozen=True, slots=True)
class Match:
    """The pose that was found, and the mean likelihood of the hits there, 0 to 1."""

    pose: Pose
    fit: float


def hits_of(beams: Beams, far_cm: float = FAR_CM) -> list[Point]:
    """Where the beams of a scan ended, as the robot sees it: (ahead, to the right) [cm].

    Readings of `far_cm` or more are no hits.

    >>> hits_of([(0, 50), (0, 200)])
    [(50.0, 0.0)]
    """
    found = []
    for angle_deg, reading_cm in beams:
        if reading_cm < far_cm:
            right, ahead = direction(angle_deg)
            found.append((reading_cm * ahead, reading_cm * right))
    return found


def place(pose: Pose, hit: Point) -> Point:
    """Where a hit lies on the mat [cm], if the robot is at this pose.

    >>> place((100, 40, 90), (50, 10))
    (150.0, 30.0)
    """
    x, y, heading_deg = pose
    ahead, right = hit
    dx, dy = direction(heading_deg)
    return x + ahead * dx + right * dy, y + ahead * dy - right * dx


def likelihoods(grid: Grid) -> Grid:
    """For each cell, how well a hit there would agree with the map, 0 to 1.

    It is the cell's own evidence for a wall, or half of that of the best cell beside it.

    >>> grid = Grid(50)
    >>> grid.cells[5] = 6.0
    >>> likelihoods(grid).cells[:8]
    [0.0, 0.5, 0.0, 0.0, 0.5, 1.0, 0.5, 0.0]
    """
    own = [min(max(each, 0.0), _CERTAIN) / _CERTAIN for each in grid.cells]
    field = Grid(grid.cell_cm)
    field.cells = own[:]
    for index, each in enumerate(own):
        if each:
            for beside in grid.beside(index):
                field.cells[beside] = max(field.cells[beside], _BESIDE * each)
    return field


def match(field: Grid, guess: Pose, hits: Sequence[Point], window: Window | None = None) -> Match:
    """The pose near the guess at which the hits agree best with a field of likelihoods.

    field   what `likelihoods` makes of a map
    guess   where the robot is, by odometry say
    hits    (ahead, right) of the robot [cm], from `hits_of`

    Of equally good poses the one nearest to the guess is taken. Without hits, or without a cell
    of the field under any of them, that is the guess itself, with a fit of 0.
    """
    window = window or Window()
    shifts = window.shifts()
    cells, across, cell_cm = field.cells, field.across, field.cell_cm
    best, best_fit, best_worth = guess, 0.0, 0.0
    for turn, turned_worth in window.turns():
        heading = wrap_heading(guess[2] + turn)
        ends = [place((guess[0], guess[1], heading), hit) for hit in hits]
        for dx, dy, shifted_worth in shifts:
            fit = 0.0
            for x, y in ends:  # the innermost loop of all: no calls of Grid in it
                column, row = floor((x + dx) / cell_cm), floor((y + dy) / cell_cm)
                if 0 <= column < across and 0 <= row < across:
                    fit += cells[row * across + column]
            fit /= max(1, len(ends))
            worth = fit * turned_worth * shifted_worth
            if worth > best_worth:
                best = (guess[0] + dx, guess[1] + dy, heading)
                best_fit, best_worth = fit, worth
    return Match(best, best_fit)


class Follower:
    """Where the robot is, by odometry and by matching what it sees with its own map.

    start    the pose it begins at, on the mat
    lag_s    the map that is matched holds only looks at least so old [s]; 0 is the map so far
    every    so many looks are gathered and matched as one: eight beams alone say too little
    gain     how much of what a match finds is believed, 0 to 1; 0 is odometry alone
    window   the poses to try

    poses    the corrected pose of each look that was added
    """

    def __init__(
        self,
        start: Pose,
        *,
        lag_s: float = 10.0,
        every: int = 5,
        gain: float = 0.5,
        window: Window | None = None,
    ) -> None:
        if every < 1 or not 0 <= gain <= 1 or not lag_s >= 0:
            raise WrongValueError(
                "Follower wants lag_s of 0 or more, every of 1 or more and gain from 0 to 1; "
                f"it got {got(lag_s)}, {got(every)} and {got(gain)}"
            )
        self.poses: list[Pose] = []
        self._pose = start
        self._believed = (0.0, 0.0, start[2])  # what odometry() says at the start
        self._lag_s, self._every, self._gain = lag_s, every, gain
        self._window = window or Window()
        self._old = Mapper()
        self._looks: list[tuple[float, list[tuple[float, float]]]] = []
        self._waiting: deque[int] = deque()
        """Looks that are not in the old map yet."""

    def add(self, t: float, odometry: Pose, beams: Beams) -> Pose:
        """Add a look taken at a time [s]; returns where the robot is believed to be.

        odometry  (x, y, heading) as `odometry()` gives it: x and y from the start
        """
        self._pose = _moved(self._pose, self._believed, odometry)
        self._believed = odometry
        self.poses.append(self._pose)
        self._looks.append((t, list(beams)))
        self._waiting.append(len(self._looks) - 1)
        if len(self._looks) % self._every == 0 and self._gain:
            self._correct(t)
        return self._pose

    def map(self) -> Mapper:
        """All looks, each from its corrected pose, as a map."""
        mapper = Mapper()
        for pose, (_, beams) in zip(self.poses, self._looks, strict=True):
            mapper.add_scan(*pose, beams)
        return mapper

    def _correct(self, t: float) -> None:
        """Match the looks gathered last, and move their poses by a part of what is found."""
        first = len(self._looks) - self._every
        while self._waiting and self._waiting[0] < first:
            index = self._waiting[0]
            if self._looks[index][0] > t - self._lag_s:
                break
            self._old.add_scan(*self.poses[index], self._looks[index][1])
            self._waiting.popleft()
        hits = [
            _seen_from(self._pose, place(self.poses[index], hit))
            for index in range(first, len(self._looks))
            for hit in hits_of(self._looks[index][1])
        ]
        if len(hits) < _FEWEST_HITS:
            return
        found = match(likelihoods(self._old.grid), self._pose, hits, self._window)
        if found.fit < _POOREST_FIT:
            return
        before = self._pose
        turn = (found.pose[2] - before[2] + 180) % 360 - 180
        self._pose = (
            before[0] + self._gain * (found.pose[0] - before[0]),
            before[1] + self._gain * (found.pose[1] - before[1]),
            wrap_heading(before[2] + self._gain * turn),
        )
        for index in range(first, len(self._looks)):
            x, y, heading = self.poses[index]
            where = place(self._pose, _seen_from(before, (x, y)))
            self.poses[index] = (*where, wrap_heading(heading + self._pose[2] - before[2]))


def _moved(pose: Pose, before: Pose, now: Pose) -> Pose:
    """A pose after the step that odometry tells of, which turns with what was corrected."""
    ahead, right = _seen_from(before, (now[0], now[1]))
    x, y = place(pose, (ahead, right))
    return x, y, wrap_heading(pose[2] + now[2] - before[2])


def _seen_from(pose: Pose, point: Point) -> Point:
    """A point of the mat as (ahead, right) of the robot: `place` the other way round."""
    x, y, heading_deg = pose
    dx, dy = direction(heading_deg)
    right, up = point[0] - x, point[1] - y
    return right * dx + up * dy, right * dy - up * dx


def _steps(most: float, step: float) -> list[float]:
    """0, then steps to either side, the nearest first."""
    found = [0.0]
    for i in range(1, int(most / step + 1e-9) + 1):
        found += [i * step, -i * step]
    return found
