"""Lesson U8.5's maps, scored: one run of the hall by four kinds of poses, over many seeds.

    python tests/lessons/u8_5_scores.py [SEEDS]

The run is that of the task "A map from odometry alone", with the camera on for the truth. The drift
is taken out by the task's own solution, scans are matched by `mapping.matching`.
"""

from __future__ import annotations

import statistics
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "py"))

from bugbot.run import outcome_of, run_program  # noqa: E402
from bugbot.trace import Trace  # noqa: E402
from bugbot.worlds import load  # noqa: E402
from mapping.frontiers import known_states  # noqa: E402
from mapping.mapper import Mapper  # noqa: E402
from mapping.matching import Follower, Pose  # noqa: E402
from mapping.score import Score, score  # noqa: E402

LESSON = ROOT / "lessons" / "u8-5-a-wrong-pose"
WORLD = load(LESSON / "worlds" / "hall.json")
START = (WORLD.start.x, WORLD.start.y, WORLD.start.heading)
REAL = [(each.x, each.y, each.width, each.height) for each in WORLD.obstacles]

TOLD = """
print("RUN", rate)
for look, pose in zip(looks, poses):
    print("LOOK", *look[:4], *pose)
"""

Beams = list[tuple[float, float]]


def looks_of(trace: Trace) -> list[tuple[Pose, Beams]]:
    """True pose and beams of each look."""
    return [
        ((each["x"], each["y"], each["heading"]), beams_of(each)) for each in trace.of_kind("scan")
    ]


def beams_of(scan: dict[str, Any]) -> Beams:
    """The (angle, reading) pairs of a scan event."""
    flat = scan["beams"]
    return list(zip(flat[::2], flat[1::2], strict=True))


def scored(poses: list[Pose], beams: list[Beams]) -> Score:
    """The map of looks from these poses, against the truth."""
    mapper = Mapper()
    for pose, each in zip(poses, beams, strict=True):
        mapper.add_scan(*pose, each)
    return score(mapper.grid, known_states(mapper.grid.cells), REAL)


def one_seed(seed: int) -> dict[str, Score]:
    """The scores of the maps of one run."""
    program = (LESSON / "odometry-alone" / "solution.py").read_text("utf-8") + TOLD
    trace = run_program(program, WORLD, seed)
    outcome = outcome_of(trace)
    if outcome["status"] != "finished":
        raise SystemExit(f"seed {seed}: {outcome['message']}")
    lines = [line.split()[1:] for line in outcome["console"].splitlines() if line[:4] == "LOOK"]
    rows = [[float(value) for value in line] for line in lines]
    true = [pose for pose, _ in looks_of(trace)]
    beams = [each for _, each in looks_of(trace)]
    believed = [(START[0] + row[1], START[1] + row[2], row[3]) for row in rows]
    straightened = [(START[0] + row[4], START[1] + row[5], row[6]) for row in rows]
    found = {"odometry as it is": scored(believed, beams)}
    ways = {
        "matched, each look, map of just now": Follower(START, lag_s=0, every=1, gain=1),
        "matched, 5 looks, map of just now": Follower(START, lag_s=0),
        "matched, 5 looks, map of 10 s ago": Follower(START),
    }
    for name, follower in ways.items():
        for row, each in zip(rows, beams, strict=True):
            follower.add(row[0], (row[1], row[2], row[3]), each)
        found[name] = scored(follower.poses, beams)
    found["one drift taken out"] = scored(straightened, beams)
    found["camera"] = scored(true, beams)
    return found


def main() -> None:
    """Print the table."""
    seeds = range(1, 1 + int(sys.argv[1] if len(sys.argv) > 1 else 20))
    every = [one_seed(seed) for seed in seeds]
    print(f"{f'wrong walls [%], {len(seeds)} seeds':38} median  lowest  highest  known [%]")
    for name in every[0]:
        wrong = [each[name].wrong_walls_percent for each in every]
        known = statistics.median(each[name].known_percent for each in every)
        print(
            f"{name:38} {statistics.median(wrong):6.1f}  {min(wrong):6.1f}  {max(wrong):7.1f}"
            f"  {known:9.1f}"
        )


if __name__ == "__main__":
    main()
