"""The small changes of a solution: each operator on a function of a few lines, worked by hand."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from grader import cli
from grader.mutants import study
from grader.mutants.equivalent import entries_of, explained
from grader.mutants.mutants import Mutant, mutants_of, own_lines

TINY = Path(__file__).parents[2] / "lessons" / "tiny-course"


def changes(program: str) -> dict[str, set[str]]:
    """What each kind of change makes of the only line with an X before its comment."""
    lines = program.splitlines()
    line = next(at for at, each in enumerate(lines, start=1) if "# X" in each)
    found: dict[str, set[str]] = {}
    for mutant in mutants_of(program, {line}):
        found.setdefault(mutant.kind, set()).add(mutant.after.replace("  # X", ""))
    return found


@pytest.mark.parametrize(
    ("line", "kind", "made"),
    [
        ("return a < b", "comparison", {"return a <= b", "return a > b"}),
        ("return a >= b", "comparison", {"return a > b", "return a <= b"}),
        ("return a == b", "comparison", {"return a != b"}),
        ("return a is None", "comparison", {"return a is not None", "return not a"}),
        ("return a is not None", "comparison", {"return a", "return a is None"}),
        ("return 0 <= a", "comparison", {"return 0 < a", "return 0 >= a"}),
        ("return a + b", "arithmetic", {"return a - b"}),
        ("return a / b", "arithmetic", {"return a * b", "return a // b"}),
        ("return a // b", "arithmetic", {"return a / b", "return a % b"}),
        ("return a // b", "rounding", {"return round(a / b)", "return int(a / b)"}),
        ("return abs(a - b)", "swapped", None),
        ("return max(a, b)", "swapped", None),
        ("return a % b", "arithmetic", {"return a // b"}),
        ("return a**2", "arithmetic", {"return a*2"}),
        ("return a not in b", "comparison", {"return a in b"}),
        ("return a + b", "left out", {"return a", "return b"}),
        ("return a - b", "swapped", {"return b - a"}),
        ("return 3", "number", {"return 4", "return 2"}),
        ("return 0", "number", {"return 1", "return (-1)"}),
        ("return 0.5", "number", {"return (0.5 + 1)", "return 0.0"}),
        ("return True", "number", {"return False"}),
        ("return a and b", "and/or", {"return a or b"}),
        ("return a and b", "guard", {"return a", "return b"}),
        ("return not a", "negation", {"return a"}),
        ("return -a", "negation", {"return a"}),
        ("return f(a, b)", "swapped", {"return f(b, a)"}),
        ("return a, b", "swapped", {"return b, a"}),
        ("return int(a)", "left out", {"return a"}),
        (
            "return int(a)",
            "rounding",
            {"return round(a)", "return math.floor(a)", "return math.ceil(a)"},
        ),
        (
            "return math.floor(a)",
            "rounding",
            {"return int(a)", "return round(a)", "return math.ceil(a)"},
        ),
        ("return math.sin(a)", "other call", {"return math.cos(a)"}),
        ("return math.radians(a)", "left out", {"return a"}),
        ("return max(a, b)", "left out", {"return a", "return b"}),
        ("return max(a, b)", "other call", {"return min(a, b)"}),
        ("a.append(b)", "other call", {"a.extend(b)"}),
        (
            "return range(a)",
            "off by one",
            {f"return range({s})" for s in ("a + 1", "a - 1", "1, a")},
        ),
        ("return a[b]", "off by one", {"return a[b + 1]", "return a[b - 1]"}),
        ("return math.floor(a / b)", "arithmetic", {"return math.floor(a * b)"}),
        ("return int(a // b)", "rounding", None),
        ("return CELL", "number for a name", {"return 5"}),
        ("return CELL", "other name", {"return ACROSS"}),
        ("return a", "other name", {"return b"}),
        ("return a if b else 0", "guard", {"return a", "return 0"}),
        ("return [c for c in a if c]", "guard", {"return [c for c in a if True]"}),
        (
            "return [c for c in a if c]",
            "negation",
            {"return [c for c in a if not (c)]"},
        ),
        ("a += b", "not added", {"a = b"}),
        ("a += b", "arithmetic", {"a -= b"}),
        ("a.clear()", "statement left out", {"pass"}),
    ],
)
def test_one_line_is_changed_in_the_ways_of_its_kind(
    line: str, kind: str, made: set[str] | None
) -> None:
    program = f"import math\nCELL = 5\nACROSS = 40\n\n\ndef f(a, b):\n    {line}  # X\n"
    assert changes(program).get(kind) == made


def test_paired_names_are_swapped_wherever_they_stand_in_a_name() -> None:
    program = "goal_x = 1\ngoal_y = 2\nprint(goal_x)  # X\n"
    assert changes(program)["other name"] == {"print(goal_y)"}


def test_a_guard_is_dropped_or_turned_round() -> None:
    program = "def f(a):\n    if a:  # X\n        return 1\n    else:\n        return 2\n"
    assert changes(program)["guard"] == {"if True:", "if False:"}
    assert changes(program)["negation"] == {"if not (a):"}


def test_one_side_of_a_double_comparison_is_dropped() -> None:
    assert changes("def f(a):\n    return 0 <= a < 9  # X\n")["guard"] == {
        "return a < 9",
        "return 0 <= a",
    }


def kinds(program: str, kind: str) -> list[tuple[int, str]]:
    count = len(program.splitlines())
    return [
        (mutant.line, mutant.change)
        for mutant in mutants_of(program, set(range(1, count + 1)))
        if mutant.kind == kind
    ]


def test_a_loop_may_end_after_its_first_round() -> None:
    program = "for a in scan():\n    print(a)\n    print(1)\n"
    assert kinds(program, "early return") == [(3, "print(1) -> print(1) | break")]


def test_break_and_continue_are_taken_for_each_other() -> None:
    program = "while go():\n    if a:\n        break\n    wait(1)\n"
    assert kinds(program, "break/continue") == [(3, "break -> continue")]


def test_two_statements_change_places_where_that_can_matter() -> None:
    program = "a, d = 1, 3\nb = 2\nc = b\nprint(c)\n"
    assert kinds(program, "order") == [
        (2, "b = 2 | c = b -> c = b | b = 2"),
        (3, "c = b | print(c) -> print(c) | c = b"),
    ]


def test_a_block_and_the_statement_beside_it_change_places() -> None:
    program = "a = 1\nif b:\n    a = 2\nprint(a)\n"
    assert [line for line, _ in kinds(program, "order")] == [1, 2]


def test_a_whole_block_is_left_out() -> None:
    program = "def f(a):\n    for b in a:\n        print(b)\n    return a\n"
    assert (2, "for b in a: … -> left out") in kinds(program, "statement left out")
    assert all("def f" not in change for _, change in kinds(program, "statement left out"))


def test_docstrings_and_imports_stay() -> None:
    program = 'import math\n\n\ndef f():\n    """Say."""\n'
    assert mutants_of(program, set(range(1, 9))) == []


def test_only_the_part_is_changed_and_no_program_is_made_twice() -> None:
    program = "a = 1\nb = 2\n"
    made = mutants_of(program, {2})
    assert {mutant.line for mutant in made} == {2}
    assert all(mutant.program.startswith("a = 1\n") for mutant in made)
    programs = [mutant.program for mutant in mutants_of("a = 0 + 0\n", {1})]
    assert len(programs) == len(set(programs))


def test_letters_beyond_ascii_do_not_move_the_change() -> None:
    program = 'print("é°", 1 + 2)  # X\n'
    assert changes(program)["arithmetic"] == {'print("é°", 1 - 2)'}


def test_a_change_says_in_which_function_and_the_how_manieth_it_is() -> None:
    inner = "        def inner():\n            return 1\n"
    program = f"class Map:\n    def of(self):\n{inner}        return 1\n"
    found = mutants_of(program, {4, 5})
    assert [(each.function, each.number) for each in found if each.after == "return 2"] == [
        ("of.inner", 1),
        ("of", 1),
    ]
    twice = mutants_of("print(1)\nprint(1)\n", {1, 2})
    assert [each.number for each in twice if each.after == "print(2)"] == [1, 2]


def test_without_a_marked_part_the_lines_that_the_starter_lacks_are_the_learners() -> None:
    assert own_lines("a = 1\nb = 2\n", "a = 1\nb = 3\nc = 4\n") == {2, 3}


# -- equivalent.json -------------------------------------------------------------


MUTANT = Mutant("number", "f", 2, "return 3", "return 4", "…")
OTHER = Mutant("number", "f", 2, "return 3", "return 2", "…")
KILLED = Mutant("negation", "f", 2, "return 3", "return -3", "…")


def entries(folder: Path, *data: dict[str, object]) -> tuple[int, list[str]]:
    """How many of the two mutants the entries explain, and the faults."""
    (folder / "equivalent.json").write_text(json.dumps(list(data), indent=1))
    read, faults = entries_of(folder)
    reasons, useless = explained(folder, read, [MUTANT, OTHER, KILLED], [MUTANT, OTHER])
    return len(reasons), [fault.what for fault in faults + useless]


WHY = "both are as good: nobody counts them"


@pytest.mark.parametrize(
    ("entry", "count"),
    [
        ({"in": "f", "change": "return 3 -> return 4"}, 1),
        ({"in": "f", "change": "return 3 -> *"}, 2),
        ({"in": "f"}, 2),
        ({"in": "f", "kinds": ["number"], "number": 1}, 2),
    ],
)
def test_an_entry_explains_a_change_or_a_family(
    entry: dict[str, object], count: int, tmp_path: Path
) -> None:
    assert entries(tmp_path, {**entry, "why": WHY}) == (count, [])


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        (
            {"in": "g", "change": "return 3 -> return 4"},
            "no change of the solution is like this",
        ),
        (
            {"in": "f", "change": "return 3 -> return 5"},
            "no change of the solution is like this",
        ),
        ({"in": "f", "kinds": ["guard"]}, "no change of the solution is like this"),
        (
            {"change": "return 3 -> return 4", "number": 2},
            "no change of the solution is like this",
        ),
        ({"in": "f", "kinds": ["negation"]}, "the checks notice this change"),
    ],
)
def test_an_entry_that_explains_nothing_is_a_fault(
    entry: dict[str, object], told: str, tmp_path: Path
) -> None:
    count, faults = entries(tmp_path, {**entry, "why": WHY})
    assert count == 0
    assert faults == [f"{told}: remove the entry"]


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        ({"in": "f"}, "lacks 'why'"),
        ({"in": "f", "why": "no"}, "why"),
        ({"why": WHY}, "say which change is meant"),
        ({"in": "f", "why": WHY, "line": 3}, "line is not known here"),
    ],
)
def test_an_entry_without_a_reason_or_a_change_is_a_fault(
    entry: dict[str, object], told: str, tmp_path: Path
) -> None:
    assert told in entries(tmp_path, entry)[1][0]


# -- the command -----------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(TINY, tmp_path / "course", ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(study, "CACHE", tmp_path / "kept")
    return tmp_path / "course"


def run(folder: Path, *arguments: str) -> int:
    return cli.main(["mutants", "--lessons", str(folder), "--processes", "2", *arguments])


def test_every_mutant_of_a_task_is_killed_and_the_verdicts_are_kept(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(folder, "one-step", "whole-steps") == 0
    first = capsys.readouterr().out
    row = next(line for line in first.splitlines() if "whole-steps" in line).split()
    assert row[1:5] == ["8", "7", "1", "0"]
    assert run(folder, "one-step", "whole-steps") == 0
    again = capsys.readouterr().out
    assert next(line for line in again.splitlines() if "whole-steps" in line).split()[5] == "0.0"


def test_a_study_that_is_ended_goes_on_from_there(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = folder.parent / "kept/one-step/whole-steps.json"
    write = study._Kept.write

    def write_and_end(known: study._Kept) -> None:
        write(known)
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(study._Kept, "write", write_and_end)
        with pytest.raises(KeyboardInterrupt):
            run(folder, "one-step", "whole-steps")
    first = json.loads(kept.read_text())
    assert len(first) == 1
    assert run(folder, "one-step", "whole-steps") == 0
    every = json.loads(kept.read_text())
    assert len(every) == 8
    assert first.items() <= every.items()


def kept_for(folder: Path) -> set[str]:
    """Under what the verdicts on the mutants of a task are kept."""
    (its,) = study.studies_of(folder, ["one-step"], "whole-steps")
    known = study._Kept(its)
    return {known.key(each) for each in its.mutants}


@pytest.mark.parametrize(
    ("changed", "same"),
    [
        ("step-up/starter.py", True),
        ("step-up/check.py", True),
        ("whole-steps/check.py", False),
        ("worlds/*.json", False),
    ],
)
def test_a_verdict_holds_until_something_that_it_depends_on_is_changed(
    folder: Path, changed: str, same: bool
) -> None:
    before = kept_for(folder)
    path = next((folder / "one-step").glob(changed))
    text = path.read_text()
    path.write_text(text.replace("{", '{"camera": false, ', 1) if "json" in changed else text + "#")
    assert (kept_for(folder) == before) is same


def test_a_change_that_no_check_notices_is_open_until_it_is_explained(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task = folder / "one-step/whole-steps"
    text = (task / "solution.py").read_text()
    (task / "solution.py").write_text(
        text.replace("int(length // step)", "int(length // step) + 0")
    )
    assert run(folder, "one-step", "whole-steps") == 1
    out = capsys.readouterr().out
    change = "return int(length // step) + 0 -> return int(length // step) - 0"
    assert f"solution.py:8 in steps, arithmetic: {change}" in out
    (task / "equivalent.json").write_text(
        json.dumps(
            [
                {
                    "in": "steps",
                    "change": "* + 0 -> *",
                    "why": "adding nothing is no mistake",
                }
            ]
        )
    )
    assert run(folder, "one-step", "whole-steps") == 0
    assert " 0 open" in capsys.readouterr().out


def test_a_solution_that_fails_is_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    task = folder / "one-step/whole-steps"
    (task / "solution.py").write_text((task / "starter.py").read_text().replace("0  #", "1  #"))
    assert run(folder, "one-step", "whole-steps") == 1
    assert "solution.py: the solution fails: A length with a rest" in capsys.readouterr().out


def test_a_check_that_breaks_on_a_changed_solution_is_told(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = folder / "one-step/whole-steps/check.py"
    begin, rest = path.read_text().split("@check(", 1)
    breaks = "compare=lambda wanted, got: got == wanted or wanted // got < 0,\n    mistakes="
    path.write_text(begin.replace("mistakes=", breaks) + "@check(" + rest)
    assert run(folder, "one-step", "whole-steps") == 1
    assert "check.py: it can't judge the solution changed so" in capsys.readouterr().out


def test_a_lesson_has_a_line_of_its_own(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(folder, "one-step")
    tasks: dict[str, list[int]] = {}
    for line in capsys.readouterr().out.splitlines():
        if line.startswith("one-step"):
            name, *figures, _ = line.rsplit(maxsplit=5)
            tasks[name] = [int(each) for each in figures]
    total = tasks.pop(f"one-step, {len(tasks) - 1} tasks")
    assert total == [sum(column) for column in zip(*tasks.values(), strict=True)]


def test_a_sample_is_the_same_for_the_same_seed(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lists = []
    for seed in ("1", "1", "2"):
        assert run(folder, "--list", "--sample", "4", "--seed", seed) == 0
        lists.append(capsys.readouterr().out)
    assert lists[0] == lists[1] != lists[2]
    assert len(lists[0].splitlines()) == 4


def test_several_lessons_can_be_named(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copytree(folder / "one-step", folder / "two-steps")
    (folder / "course.json").write_text('{"format": 1, "lessons": ["one-step", "two-steps"]}')
    assert run(folder, "--list", "one-step", "two-steps") == 0
    lines = capsys.readouterr().out.splitlines()
    assert {line.split(":")[0].split("/")[-3] for line in lines} == {"one-step", "two-steps"}
    assert run(folder, "--list", "two-steps", "whole-steps") == 0
    lines = capsys.readouterr().out.splitlines()
    assert {tuple(line.split(":")[0].split("/")[-3:-1]) for line in lines} == {
        ("two-steps", "whole-steps")
    }


def test_each_task_is_a_line_of_json_on_demand(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(folder, "one-step", "whole-steps", "--sample", "2", "--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["task"], told["mutants"], told["killed"], told["open"]) == (
        "whole-steps",
        2,
        2,
        [],
    )
