"""Runs an explorer on many mats with many noises, and says how it did, as a table.

    npm run explore                          the solution of U8.7 on 30 mats, 5 noises each
    npm run explore -- --mats 6 --seeds 1    a small sample
    npm run explore -- --program my.py       another explorer; --mat 17 one mat, --each a line a run

May import: the standard library, `bugbot`, `grader`, `mats` beside it.

The runs are made and judged as a learner's are: by trials of a check. The exit status is 1 if a run
crashed, hung or stopped without a reason.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "py"), str(Path(__file__).parent)]

from mats import KINDS, floor_cells, mat  # noqa: E402 - the path has to be set first

from grader.marking import Performer, mark_program  # noqa: E402

SOLUTION = ROOT / "lessons" / "u8-7-map-the-mat" / "map-the-mat" / "solution.py"

SECONDS = 300
"""So many simulated seconds a run may take: an explorer must have stopped by itself before."""

REAL_S = 120.0
"""A run that computes longer than this hangs [real s]."""

CHECK = """
from grader import check

@check("{name}")
def one_mat(task):
    for trial in task.trials("{name}", seeds={seeds}, seconds={seconds}):
        trial.known().wrong_walls().took().drove().bumps().says_why(after="stops:")
"""


@dataclass(frozen=True, slots=True)
class Run:
    """What one run came to.

    ended        "finished", or what cut it short
    why          the reason that the program gave
    passed       it ended by itself and gave a reason
    known        per cent of the mat
    of_floor     per cent of the cells with floor that are known
    wrong        per cent of the black cells with nothing real near
    seconds      simulated
    metres       driven
    bumps        how often it touched something
    """

    mat: int
    seed: int
    ended: str
    why: str
    passed: bool
    known: float = 0.0
    of_floor: float = 0.0
    wrong: float = 0.0
    seconds: float = 0.0
    metres: float = 0.0
    bumps: int = 0

    @property
    def kind(self) -> str:
        return list(KINDS)[self.mat % len(KINDS)]


def explore(number: int, seeds: Sequence[int], program: str) -> list[Run]:
    """An explorer's runs on one mat."""
    world = mat(number)
    lesson = {"slug": "explore", "worlds": {world.name: world.to_dict()}}
    check = CHECK.format(name=world.name, seeds=tuple(seeds), seconds=SECONDS)
    with Performer() as performer:

        def perform(job: dict[str, Any], program: str) -> dict[str, Any]:
            # All cores are busy here: what would be a hang for one learner is none yet.
            limits = {**job["limits"], "real_s": REAL_S, "silent_s": REAL_S / 4}
            return performer.perform({**job, "limits": limits}, program)

        mark = mark_program(check, lesson, "explore", program, perform)
    if mark["ours"] is not None:
        raise RuntimeError(mark["ours"])
    floor = floor_cells(world)
    runs = []
    for result in mark["results"]:
        seed, ended, why = result["seed"], result["ended"], result["why"]
        figures = {each["name"]: each["value"] for each in result["figures"]}
        if result["map"] is None or None in figures.values():
            runs.append(Run(number, seed, ended, why, passed=False))
            continue
        across, signs = result["map"]["across"], result["map"]["cells"]
        seen = sum(signs[row * across + column] != "?" for column, row in floor)
        runs.append(
            Run(
                number,
                seed,
                ended,
                why,
                result["passed"],
                figures["known"],
                100 * seen / len(floor),
                figures["wrong walls"],
                figures["time"],
                figures["distance"] / 100,
                round(figures["bumps"]),
            )
        )
    return runs


def explore_all(
    numbers: Iterable[int], seeds: Sequence[int], program: str, processes: int | None = None
) -> list[Run]:
    """The runs on all these mats, shared out among processes."""
    with ProcessPoolExecutor(processes or os.cpu_count()) as pool:
        found = pool.map(partial(explore, seeds=seeds, program=program), numbers)
        return [run for runs in found for run in runs]


def table(runs: Sequence[Run]) -> str:
    """The runs by the character of their mats, and all together."""
    lines = [
        f"{'':10}{'runs':>5}{'finished':>10}{'known %':>15}{'of floor %':>15}{'wrong %':>13}"
        f"{'seconds':>15}{'metres':>14}{'bumps':>7}",
        f"{'':10}{'':>5}{'':>10}{'median':>9}{'least':>6}{'median':>9}{'least':>6}"
        f"{'median':>8}{'most':>5}{'median':>9}{'most':>6}{'median':>8}{'most':>6}{'all':>7}",
    ]
    kinds = [kind for kind in KINDS if any(run.kind == kind for run in runs)]
    for name, some in [
        *((kind, [run for run in runs if run.kind == kind]) for kind in kinds),
        ("all", list(runs)),
    ]:
        finished = 100 * sum(run.ended == "finished" for run in some) / len(some)
        known, floor = [run.known for run in some], [run.of_floor for run in some]
        wrong, seconds = [run.wrong for run in some], [run.seconds for run in some]
        metres = [run.metres for run in some]
        lines.append(
            f"{name:10}{len(some):5}{finished:8.0f} %"
            f"{median(known):9.1f}{min(known):6.1f}{median(floor):9.1f}{min(floor):6.1f}"
            f"{median(wrong):8.1f}{max(wrong):5.1f}{median(seconds):9.0f}{max(seconds):6.0f}"
            f"{median(metres):8.1f}{max(metres):6.1f}"
            f"{sum(run.bumps for run in some):7}"
        )
    reasons = Counter(run.why if run.ended == "finished" else run.ended for run in runs)
    lines += ["", "why they stopped:"]
    lines += [f"{count:5}  {reason}" for reason, count in reasons.most_common()]
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run, print the table; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mats", type=int, default=30, help="so many, from number 0")
    parser.add_argument("--mat", type=int, action="append", help="only the mat of this number")
    parser.add_argument("--seeds", type=int, default=5, help="so many noises on each")
    parser.add_argument("--program", type=Path, default=SOLUTION, help="the explorer's file")
    parser.add_argument("--each", action="store_true", help="a line for each run as well")
    parser.add_argument("--processes", type=int, help="at once; as many as there are cores")
    chosen = parser.parse_args(arguments)
    numbers = chosen.mat or range(chosen.mats)
    seeds = range(1, chosen.seeds + 1)
    runs = explore_all(numbers, seeds, chosen.program.read_text("utf-8"), chosen.processes)
    if chosen.each:
        for run in runs:
            print(
                f"{run.mat:3} {run.kind:8} seed {run.seed}: known {run.known:5.1f} %, of floor "
                f"{run.of_floor:5.1f} %, wrong {run.wrong:4.1f} %, {run.seconds:5.1f} s, "
                f"{run.metres:4.1f} m, {run.bumps} bumps, {run.ended}: {run.why}"
            )
    print(table(runs), flush=True)
    bad = [run for run in runs if not run.passed]
    for run in bad:
        print(f"mat {run.mat}, seed {run.seed}: {run.ended}: {run.why}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
