"""The command line: what it prints, writes and ends with."""

import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import bugbot
from bugbot import worlds
from bugbot.cli import main
from bugbot.run import outcome_of, run_program
from bugbot.trace import Trace
from sandbox.node import prepared

GOOD = 'from bugbot import *\nprint("on my way")\nforward(100, 23)\ndraw("goal", [position()])\n'


@pytest.fixture
def program(tmp_path: Path) -> Path:
    file = tmp_path / "mine.py"
    file.write_text(GOOD, encoding="utf-8")
    return file


Capture = pytest.CaptureFixture[str]


def test_a_run_shows_the_programs_output_and_how_it_ended(program: Path, capsys: Capture) -> None:
    assert main(["run", str(program)]) == 0
    out, err = capsys.readouterr()
    assert out == "on my way\n"
    assert err == "Finished after 2 s.\n"


def test_json_is_the_outcome_and_nothing_else(program: Path, capsys: Capture) -> None:
    assert main(["run", str(program), "--world", "doorway", "--seed", "7", "--json"]) == 0
    out, err = capsys.readouterr()
    expected = outcome_of(run_program(GOOD, "doorway", 7, filename="mine.py"))
    assert json.loads(out) == json.loads(json.dumps(expected))
    assert err == ""


def test_a_fault_is_shown_with_its_line_and_likely_cause(program: Path, capsys: Capture) -> None:
    program.write_text("from bugbot import *\nprint('hm')\nfoward(50)\n", encoding="utf-8")
    assert main(["run", str(program)]) == 1
    out, err = capsys.readouterr()
    assert out == "hm\n"
    assert err == (
        "Traceback (most recent call last):\n"
        '  File "mine.py", line 3, in <module>\n'
        "    foward(50)\n"
        "NameError: name 'foward' is not defined\n"
        "Did you mean forward?\n"
        "Stopped by an error on line 3: name 'foward' is not defined\n"
    )


def test_a_fault_without_a_likely_cause_is_shown_without(program: Path, capsys: Capture) -> None:
    program.write_text("raise ValueError('mine')", encoding="utf-8")
    assert main(["run", str(program)]) == 1
    assert capsys.readouterr().err.splitlines()[-2] == "ValueError: mine"


def test_a_limit_ends_with_one(program: Path, capsys: Capture) -> None:
    program.write_text("from bugbot import *\nwait(601)", encoding="utf-8")
    assert main(["run", str(program), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["status"] == "limit"


def test_the_trace_is_saved(program: Path, tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "run.trace"
    assert main(["run", str(program), "--trace", str(file)]) == 0
    with file.open(encoding="utf-8") as lines:
        trace = Trace.load(lines)
    assert outcome_of(trace)["seconds"] == 2
    assert trace.header["program"] == GOOD


def test_the_picture_is_saved(program: Path, tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "end.png"
    assert main(["run", str(program), "--png", str(file)]) == 0
    assert file.read_bytes().startswith(b"\x89PNG")


def test_a_program_can_come_from_standard_input(
    monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(b"print(1)\n1/0")))
    assert main(["run", "-"]) == 1
    assert '"program.py", line 2' in capsys.readouterr().err


def test_a_world_of_ones_own_by_its_file(program: Path, tmp_path: Path, capsys: Capture) -> None:
    world = worlds.load("empty").to_dict() | {"start": {"x": 20, "y": 30, "heading": 90}}
    file = tmp_path / "mine.json"
    file.write_text(json.dumps(world), encoding="utf-8")
    assert main(["run", str(program), "--json", "--world", str(file)]) == 0
    assert json.loads(capsys.readouterr().out)["pose"]["x"] == pytest.approx(43)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["run", "nowhere.py"], "bugbot: can't read nowhere.py: No such file or directory\n"),
        (["run", "{program}", "--world", "dorway"], "did you mean 'doorway'?"),
        (["run", "{folder}"], "Is a directory"),
        (["run", "{latin}"], "latin.py is not UTF-8 text: see line 2\n"),
        (["run", "{program}", "--trace", "{folder}/no/x"], "can't write"),
        (["run", "{program}", "--png", "{folder}/no/x.png"], "can't write"),
    ],
)
def test_wrong_usage_ends_with_two_and_says_what(
    program: Path, tmp_path: Path, capsys: Capture, arguments: list[str], message: str
) -> None:
    latin = tmp_path / "latin.py"
    latin.write_bytes(b"x = 1\ny = '\xe9'\n")
    names = {"program": program, "folder": tmp_path, "latin": latin}
    assert main([each.format(**names) for each in arguments]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments", [[], ["fly"], ["run"], ["run", "x.py", "--seed", "a"], ["worlds", "extra"]]
)
def test_arguments_that_make_no_sense_end_with_two(arguments: list[str], capsys: Capture) -> None:
    with pytest.raises(SystemExit) as end:
        main(arguments)
    assert end.value.code == 2
    assert "usage: python -m bugbot" in capsys.readouterr().err


def test_worlds_are_listed_in_words_and_in_full(capsys: Capture) -> None:
    assert main(["worlds"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == worlds.names()
    assert main(["worlds", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    assert listed == [worlds.load(name).to_dict() for name in worlds.names()]


def command(*arguments: Any, code: str | None = None) -> subprocess.CompletedProcess[str]:
    begin = ["-m", "bugbot"] if code is None else ["-c", code]
    root = Path(bugbot.__file__).parents[1]
    return subprocess.run(
        [sys.executable, *begin, *map(str, arguments)],
        capture_output=True,
        text=True,
        encoding="utf-8",
        cwd=root,
        timeout=60,
        check=False,
    )


def test_the_module_is_a_command(program: Path) -> None:
    done = command("run", "--trusted", program, "--json")
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["console"] == "on my way\n"
    assert command("run", "--trusted", "nowhere.py").returncode == 2


# -- programs that only the parent process can end -------------------------------

SOON = """
import sys
from bugbot import cli, supervisor
from bugbot.run import Limits, watchdog
supervisor._GRACE_S = watchdog._GRACE_S = 0.3
sys.exit(cli.main(sys.argv[1:], limits=Limits(silent_s=0.3), in_child=True))
"""


def test_a_calculation_that_nothing_interrupts_is_ended_with_its_outcome(program: Path) -> None:
    program.write_text("sum(iter(int, 1))", encoding="utf-8")
    done = command("run", "--trusted", program, "--json", code=SOON)
    outcome = json.loads(done.stdout)
    assert (done.returncode, outcome["status"]) == (1, "limit")
    assert outcome["message"] == (
        "Stopped after 0.3 s inside one calculation of Python's that would not end."
    )


def test_a_program_that_resists_interruption_is_ended_with_its_outcome(program: Path) -> None:
    program.write_text(
        "print('begin')\n"
        "def resist():\n"
        "    try:\n"
        "        while True: pass\n"
        "    except BaseException:\n"
        "        resist()\n"
        "while True:\n"
        "    try: resist()\n"
        "    except BaseException: pass\n",
        encoding="utf-8",
    )
    done = command("run", "--trusted", program, "--json", code=SOON)
    outcome = json.loads(done.stdout)
    assert (done.returncode, outcome["status"], outcome["console"]) == (1, "limit", "begin\n")


def test_an_interpreter_that_dies_leaves_an_outcome(program: Path) -> None:
    program.write_text("import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)", encoding="utf-8")
    done = command("run", "--trusted", program, "--json", code=SOON)
    outcome = json.loads(done.stdout)
    assert (done.returncode, outcome["status"]) == (1, "fault")
    assert outcome["fault"]["type"] == "RecursionError"
    assert outcome["fault"]["message"].startswith("Python itself died")


@pytest.mark.skipif(shutil.which("node") is None, reason="the sandbox needs Node")
def test_a_file_that_nobody_trusts_runs_where_it_reaches_nothing(program: Path) -> None:
    prepared()  # the first time it takes a while
    lines = [GOOD, "import os", 'print("\\x1b[2J", os.getpid() == PID, os.path.exists(FILE))']
    names = f"PID, FILE = {os.getpid()}, {str(program)!r}"
    program.write_text("\n".join([names, *lines, "1 / 0"]), encoding="utf-8")
    done = command("run", program, "--json")
    outcome = json.loads(done.stdout)
    assert outcome["console"].endswith("False False\n")
    assert outcome["status"] == "fault"
    assert "division by zero" in outcome["message"]
    assert "\x1b" not in done.stdout
    assert done.returncode == 1


def test_without_a_sandbox_it_is_said_how_to_do_without(
    program: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    prepared.cache_clear()
    monkeypatch.setenv("PATH", "/nowhere")
    assert main(["run", str(program)], in_child=True) == 2
    prepared.cache_clear()
    said = capsys.readouterr().err
    assert "Node can't be started" in said
    assert "--trusted" in said
