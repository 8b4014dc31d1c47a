"""Which files of a class's folder are marked, for whom, and what is said of the others."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from grader.classes.submissions import UnreadableError, find, read_program
from grader.lesson import CourseError, Lesson, TaskFolder


def lesson(slug: str, *tasks: str) -> Lesson:
    return Lesson(
        slug,
        Path(slug),
        [TaskFolder(each, Path(each), 1, 3, "empty") for each in tasks],
    )


COURSE = [lesson("one", "add", "walk"), lesson("two", "add", "scan-all")]


def placed(folder: Path, **only: str) -> tuple[list[tuple[str, str, str]], dict[str, str], int]:
    found = find(folder, COURSE, **only)
    marked = [(each.learner, each.lesson.slug, each.task.name) for each in found.submissions]
    return marked, {each.name: each.why for each in found.strays}, found.left_out


def write(folder: Path, *names: str) -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("x = 1\n", "utf-8")


def test_learners_are_folders_or_the_beginning_of_a_name(tmp_path: Path) -> None:
    write(
        tmp_path,
        "Ada L/walk.py",
        "Ada L/two/add.py",
        "ben--o--scan-all.py",
        ".git/x",
        "a/.b",
    )
    assert placed(tmp_path) == (
        [
            ("Ada L", "two", "add"),
            ("Ada L", "one", "walk"),
            ("ben--o", "two", "scan-all"),
        ],
        {},
        0,
    )


def test_a_name_that_does_not_fit_is_told(tmp_path: Path) -> None:
    write(
        tmp_path,
        "ada/wlak.py",
        "ada/add.py",
        "ada/notes.txt",
        "cleo.py",
        "ada/tow/add.py",
    )
    write(
        tmp_path,
        "ada/one/scan-all.py",
        "ada/one/two/add.py",
        "ada--walk.py",
        "ada/walk.py",
    )
    (tmp_path / "link.py").symlink_to(tmp_path / "cleo.py")
    (tmp_path / "host").symlink_to("/")
    marked, strays, _ = placed(tmp_path)
    assert marked == [("ada", "one", "walk")]
    assert strays == {
        "ada/wlak.py": "no task is called 'wlak'; the nearest is 'walk'",
        "ada/add.py": "one, two have a task 'add': call it LEARNER/LESSON/add.py",
        "ada/notes.txt": "no .py file",
        "cleo.py": "whose file, and for which task? call it LEARNER/TASK.py or LEARNER--TASK.py",
        "ada/tow/add.py": "no lesson is called 'tow'; the nearest is 'two'",
        "ada/one/scan-all.py": "one has no task 'scan-all'; two has",
        "ada/one/two/add.py": "too many folders: call it LEARNER/TASK.py or LEARNER--TASK.py",
        "ada--walk.py": "ada has this task in ada/walk.py already",
        "link.py": "no plain file: links are not read",
        "host": "no plain file: links are not read",
    }


def test_one_lesson_or_one_task_can_be_asked_for(tmp_path: Path) -> None:
    write(tmp_path, "ada/add.py", "ada/walk.py", "ada/scan-all.py", "cleo.py")
    assert placed(tmp_path, lesson="two")[0] == [
        ("ada", "two", "add"),
        ("ada", "two", "scan-all"),
    ]
    marked, _, left_out = placed(tmp_path, task="walk")
    assert marked == [("ada", "one", "walk"), ("cleo", "one", "walk")]
    assert left_out == 2


def test_what_does_not_exist_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(CourseError, match="no task 'fly'; there are: add, walk, scan-all"):
        placed(tmp_path, task="fly")
    with pytest.raises(CourseError, match="no lesson 'nine'; there are: one, two"):
        placed(tmp_path, lesson="nine")
    with pytest.raises(CourseError, match="is no folder"):
        placed(tmp_path / "missing")


def nested(top: Path, depth: int) -> None:
    """Folders in each other, deeper than a path can be long; made and left from inside."""
    here = os.open(top, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir("deep", dir_fd=here)
        inner = os.open("deep", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = inner
    with open(os.open("add.py", os.O_WRONLY | os.O_CREAT, dir_fd=here), "w") as file:
        file.write("x = 1\n")
    os.close(here)


def unnest(top: Path, depth: int) -> None:
    """What shutil.rmtree can't do: it calls itself for each folder."""
    here = [os.open(top, os.O_RDONLY)]
    for _ in range(depth):
        here.append(os.open("deep", os.O_RDONLY, dir_fd=here[-1]))
    os.unlink("add.py", dir_fd=here[-1])
    for outer in reversed(here):
        if outer != here[-1]:
            os.rmdir("deep", dir_fd=outer)
    for each in here:
        os.close(each)


@pytest.mark.parametrize(("depth", "why"), [(600, "too many folders"), (1500, "can't be read")])
def test_folders_nested_too_deep_are_strays(tmp_path: Path, depth: int, why: str) -> None:
    write(tmp_path, "ada/walk.py", "zoe/walk.py")
    (tmp_path / "bob").mkdir()
    nested(tmp_path / "bob", depth)
    marked, strays, _ = placed(tmp_path)
    assert marked == [("ada", "one", "walk"), ("zoe", "one", "walk")]
    assert len(strays) == 1
    assert why in next(iter(strays.values()))
    unnest(tmp_path / "bob", depth)


def test_what_can_not_be_read_is_a_stray(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, "ada/walk.py", "bob/walk.py", "zoe/walk.py")
    scan, look = os.scandir, os.lstat

    def scandir(path: Path) -> Any:
        if path.name == "bob":  # whoever runs the tests may be allowed everything
            raise PermissionError(13, "Permission denied")
        return scan(path)

    def lstat(path: Path) -> os.stat_result:
        if path.name == "zoe":
            raise FileNotFoundError(2, "No such file or directory")
        return look(path)

    monkeypatch.setattr(os, "scandir", scandir)
    monkeypatch.setattr(os, "lstat", lstat)
    marked, strays, _ = placed(tmp_path)
    assert marked == [("ada", "one", "walk")]
    assert strays == {
        "bob": "can't be read: Permission denied",
        "zoe": "can't be read: No such file or directory",
    }


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "the file is empty"),
        (b" \n\n", "the file is empty"),
        (
            b"x = 1\ny = '\xe9'\n",
            "not written in UTF-8 (byte 0xe9 on line 2): save it as UTF-8",
        ),
        ("x = 1".encode("utf-16"), "written in UTF-16: save it as UTF-8"),
        (b"x = 1\0", "holds zero bytes"),
        (b"#" * 1_000_001, "larger than 1 MB"),
    ],
)
def test_a_file_that_is_no_program_is_told_why(tmp_path: Path, data: bytes, why: str) -> None:
    path = tmp_path / "walk.py"
    path.write_bytes(data)
    with pytest.raises(UnreadableError) as told:
        read_program(path)
    assert why in str(told.value)


def test_a_byte_order_mark_and_other_line_ends_are_no_trouble(tmp_path: Path) -> None:
    path = tmp_path / "walk.py"
    path.write_bytes("\ufeffx = 'é'\r\ny = 2\r".encode())
    assert read_program(path) == "x = 'é'\ny = 2\n"
