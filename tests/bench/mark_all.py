"""200 synthetic submissions marked with 1 and 2 processes and on a dask cluster of 2 workers.

    npm run mark-all:bench [-- --count 200] [--trusted]
    npm run mark-all:bench -- --count 200 --hostile 20

The submissions are made of the lessons' solutions, starters and wrong attempts. Prints the times
side by side, and ends with 1 if a way of marking gives another mark than the others.

With --hostile that many of the files mean no good (tests/py/grader/classes/hostile_files.py). The
class is marked with them and without them, and it ends with 1 if an honest file's mark differs.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import itertools
import json
import random
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from distributed import LocalCluster

from grader.cli import main
from grader.lesson import LESSONS, lesson_at

sys.path.append(str(Path(__file__).parents[1] / "py" / "grader" / "classes"))
from hostile_files import HOSTILE, hostile_program

FROM = ("u8-1-a-map-of-cells", "u8-2-inverse-sensor-model", "u8-3-log-odds", "u8-4-building-a-grid")


def make_class(folder: Path, count: int, lessons: Sequence[str] = FROM, seed: int = 1) -> None:
    """Write so many submissions, FOLDER/LEARNER/TASK.py: half of them right."""
    chance = random.Random(seed)
    tasks = [task for slug in lessons for task in lesson_at(LESSONS / slug).tasks]
    for index in range(count):
        task = tasks[index % len(tasks)]
        wrong = [attempt.path for attempt in task.wrong]
        source = chance.choice([task.solution, chance.choice([task.starter, *wrong])])
        learner = folder / f"learner-{index // len(tasks) + 1:02}"
        learner.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, learner / f"{task.name}.py")


def marked(folder: Path, out: Path, *how: str) -> tuple[float, dict[str, object]]:
    """Seconds that mark-all takes, and what it says of each file."""
    began = time.perf_counter()
    with contextlib.redirect_stdout(io.StringIO()):
        status = main(["mark-all", str(folder), "--out", str(out), "--again", *how])
    seconds = time.perf_counter() - began
    if status != 0:
        raise SystemExit(f"mark-all {' '.join(how)} ended with {status}")
    rows = map(json.loads, (out / "rows.jsonl").read_text("utf-8").splitlines())
    kept = ("status", "passed", "of", "failed", "score", "note")
    return seconds, {row["file"]: {name: row[name] for name in kept} for row in rows}


@contextlib.contextmanager
def cluster() -> Iterator[str]:
    """The address of a local cluster: two workers, each a process."""
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as local:
        yield local.scheduler_address


def bench(count: int, trusted: list[str]) -> int:
    """Mark them in each way, print the table; returns the exit status."""
    with tempfile.TemporaryDirectory() as scratch:
        folder, out = Path(scratch, "class"), Path(scratch, "marks")
        make_class(folder, count)
        ways = {
            "1 process": marked(folder, out, "--processes", "1", *trusted),
            "2 processes": marked(folder, out, "--processes", "2", *trusted),
        }
        with cluster() as address:
            ways["dask, 2 workers"] = marked(folder, out, "--dask", address, *trusted)
    alone, first = ways["1 process"]
    passed = sum(row["status"] == "passed" for row in first.values())
    where = "plain CPython" if trusted else "the locked-down Python under Node"
    print(f"{count} submissions in {where}; {passed} pass")
    print(f"{'':18}{'seconds':>10}{'each':>10}{'against 1':>12}  marks")
    different = 0
    for name, (seconds, rows) in ways.items():
        other = sum(rows.get(file) != row for file, row in first.items())
        different += other
        same = "the same" if other == 0 else f"{other} differ"
        print(f"{name:18}{seconds:10.1f}{seconds / count:10.2f}{alone / seconds:11.2f}x  {same}")
    return 1 if different else 0


def bench_hostile(count: int, hostile: int) -> int:
    """Mark a class with and without its hostile files; returns the exit status."""
    with tempfile.TemporaryDirectory() as scratch:
        folder, marks, alone = (Path(scratch, name) for name in ("class", "marks", "alone"))
        make_class(folder, count - hostile, FROM[:1])
        without = marked(folder, alone)
        for index, what in enumerate(itertools.islice(itertools.cycle(HOSTILE), hostile)):
            learner = folder / f"hostile-{index + 1:02}"
            learner.mkdir()
            program = hostile_program(what, folder, marks)
            (learner / "cell-of-a-point.py").write_text(program, "utf-8")
        before = {path: path.read_bytes() for path in folder.rglob("*.py")}
        beside = marked(folder, marks)
        spoilt = sum(path.read_bytes() != data for path, data in before.items())
    honest = without[1]
    different = [file for file, row in honest.items() if beside[1].get(file) != row]
    for file in different:
        print(f"{file}:\n  without them {honest[file]}\n  beside them  {beside[1].get(file)}")
    passed = sum(row["status"] == "passed" for row in honest.values())
    others = [row["status"] for file, row in beside[1].items() if file not in honest]
    told = ", ".join(f"{others.count(each)} {each}" for each in sorted(set(map(str, others))))
    print(f"{len(honest)} honest submissions, {passed} pass: {without[0]:.1f} s")
    print(f"the same and {hostile} hostile ones ({told}): {beside[0]:.1f} s")
    print(f"honest marks that differ: {len(different)}; files that were changed: {spoilt}")
    return 1 if different or spoilt or len(others) != hostile else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--trusted", action="store_true", help="in plain CPython")
    parser.add_argument("--hostile", type=int, default=0, help="so many of them mean no good")
    options = parser.parse_args()
    if options.hostile:
        sys.exit(bench_hostile(options.count, options.hostile))
    sys.exit(bench(options.count, ["--trusted"] if options.trusted else []))
