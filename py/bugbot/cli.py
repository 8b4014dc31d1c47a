"""The command line: run a program on a world, list the worlds.

May import: the rest of `bugbot`.

    python -m bugbot run FILE [--world NAME_OR_FILE] [--seed N] [--json] [--trace OUT] [--png OUT]
                              [--trusted]
    python -m bugbot worlds [--json]

The program runs in a sandbox, where it can reach nothing of this machine, unless `--trusted` says
that it may. Ends with 0 for a program that finished, 1 for one that did not, 2 for wrong usage.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

from bugbot import worlds
from bugbot.errors import BugbotError, WorldError
from bugbot.picture import PictureError, save_picture
from bugbot.plain_text import json_text, plain
from bugbot.run import Limits, outcome_of, run_program
from bugbot.run.watchdog import STILL_S
from bugbot.shut_in import run_shut_in
from bugbot.supervisor import supervised
from bugbot.trace import Trace
from sandbox.node import NoSandboxError, SandboxError

__all__ = ["main"]

_USAGE = 2

_end_process = os._exit  # during a run the name belongs to the program


class _UsageError(BugbotError):
    """Something about the command itself is wrong."""


def main(arguments: list[str], *, limits: Limits | None = None, in_child: bool = False) -> int:
    """Do what the arguments say; returns the exit status.

    With `in_child` the program runs in a process of its own, which can always be ended: the
    sandbox's, or one of plain Python if the arguments say that the file is trusted.
    """
    options = _parser().parse_args(arguments)
    try:
        if options.command == "worlds":
            return _worlds(options.json)
        return _run(options, limits or Limits(), in_child)
    except (_UsageError, WorldError) as error:
        return _refuse(error)


def _refuse(error: BugbotError) -> int:
    print(plain(f"bugbot: {error}"), file=sys.stderr)
    return _USAGE


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m bugbot", description="Run programs for the simulated robot."
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="run|worlds")
    run = commands.add_parser("run", help="run a program on a world")
    run.add_argument("file", metavar="FILE", help="the program's file; - reads standard input")
    run.add_argument("--world", default="empty", help="a world's name or .json file (empty)")
    run.add_argument("--seed", type=int, default=1, help="of the noise and of random (1)")
    run.add_argument("--json", action="store_true", help="print the outcome as JSON, only that")
    run.add_argument("--trace", type=Path, metavar="OUT", help="save the trace to this file")
    run.add_argument(
        "--trusted",
        action="store_true",
        help="run it in plain Python, outside the sandbox: it can do whatever you can do",
    )
    run.add_argument("--png", type=Path, metavar="OUT", help="save a picture of the end")
    listing = commands.add_parser("worlds", help="list the worlds")
    listing.add_argument("--json", action="store_true", help="in full, as JSON")
    return parser


def _run(options: argparse.Namespace, limits: Limits, in_child: bool) -> int:
    source = _read(options.file)
    world = worlds.load(options.world)
    name = "program.py" if options.file == "-" else Path(options.file).name
    out, err = sys.stdout, sys.stderr
    if in_child and not options.trusted:
        try:
            return _report(run_shut_in(source, world, options.seed, limits, name), options)
        except (NoSandboxError, SandboxError) as error:
            raise _UsageError(str(error)) from None
        except PictureError as error:
            return _refuse(error)

    def work(trace_ready: Callable[[Trace], None]) -> int:
        trace = run_program(
            source,
            world,
            options.seed,
            limits=limits,
            filename=name,
            trace_ready=trace_ready,
            on_still=tell_of_standstill,
            on_stuck=give_up if in_child else None,
        )
        return report(trace)

    def tell_of_standstill(line: int) -> None:
        print(
            f"Still computing on line {line}: no simulated time has passed for {STILL_S:g} s. If "
            "a loop waits for the robot there, put wait(0.1) into it.",
            file=err,
            flush=True,
        )

    def give_up(trace: Trace) -> None:
        # The program swallows every interruption: all that is left is to go.
        sys.stdout, sys.stderr = out, err
        status = report(trace)
        out.flush()
        err.flush()
        _end_process(status)

    def report(trace: Trace) -> int:
        try:
            return _report(trace, options)
        except (_UsageError, PictureError) as error:
            return _refuse(error)

    return supervised(work, limits.silent_s, report) if in_child else work(lambda _: None)


def _read(file: str) -> str:
    try:
        raw = sys.stdin.buffer.read() if file == "-" else Path(file).read_bytes()
    except OSError as error:
        raise _UsageError(f"can't read {file}: {error.strerror}") from None
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise _UsageError(f"{file} is not UTF-8 text: see line {line}") from None


def _report(trace: Trace, options: argparse.Namespace) -> int:
    outcome = outcome_of(trace)
    if options.json:
        print(json_text(outcome))
    else:
        _show_what_was_said(trace)
        for fault in trace.of_kind("fault"):
            print(plain(fault["traceback"]), end="", file=sys.stderr)
            if fault["hint"] is not None:
                print(plain(fault["hint"]), file=sys.stderr)
        print(plain(outcome["message"]), file=sys.stderr)
    if options.trace is not None:
        _save(trace, options.trace)
    if options.png is not None:
        save_picture(trace, options.png)
    return 0 if outcome["status"] == "finished" else 1


def _show_what_was_said(trace: Trace) -> None:
    """What the program printed, and the notes on its calls, in the order they came."""
    begun = False
    for kind, _, *values in trace.events:
        if kind == "print":
            stream, text = values
            out = getattr(sys, stream)
            print(plain(text, "\n\t\r") if out.isatty() else text, end="", file=out)
            begun = not text.endswith("\n")
        elif kind == "note":
            line, text = values
            sys.stdout.flush()
            print(
                *([""] if begun else []), plain(f"Line {line}: {text}"), sep="\n", file=sys.stderr
            )
            begun = False


def _save(trace: Trace, path: Path) -> None:
    try:
        with path.open("w", encoding="utf-8") as file:
            trace.save(file)
    except OSError as error:
        raise _UsageError(f"can't write {path}: {error.strerror}") from None


def _worlds(as_json: bool) -> int:
    every = [worlds.load(name) for name in worlds.names()]
    if as_json:
        print(json.dumps([world.to_dict() for world in every], ensure_ascii=False, indent=2))
    else:
        for world in every:
            print(f"{world.name:16} {world.description}")
    return 0
