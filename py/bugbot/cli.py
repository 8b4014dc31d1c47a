"""The command line: run a program on a world, list the worlds.

May import: the rest of `bugbot`.

    python -m bugbot run FILE [--world NAME_OR_FILE] [--seed N] [--json] [--trace OUT] [--png OUT]
    python -m bugbot worlds [--json]

Ends with 0 for a program that finished, 1 for one that did not, 2 for wrong usage.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from bugbot import worlds
from bugbot.errors import WorldError
from bugbot.run import outcome_of, run_program
from bugbot.trace import Trace

__all__ = ["main"]

_USAGE = 2


def main(arguments: list[str]) -> int:
    """Do what the arguments say; returns the exit status."""
    options = _parser().parse_args(arguments)
    try:
        return _run(options) if options.command == "run" else _worlds(options)
    except (_UsageError, WorldError) as error:
        print(f"bugbot: {error}", file=sys.stderr)
        return _USAGE


class _UsageError(Exception):
    """Something about the command itself is wrong."""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m bugbot", description="The simulated robot.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="run|worlds")
    run = commands.add_parser("run", help="run a program on a world")
    run.add_argument("file", metavar="FILE", help="the program; - reads it from the keyboard")
    run.add_argument("--world", default="empty", help="name of a world, or a world's .json file")
    run.add_argument("--seed", type=int, default=1, help="of the noise (default 1)")
    run.add_argument("--json", action="store_true", help="print the outcome as JSON")
    run.add_argument("--trace", type=Path, metavar="OUT", help="save the trace to this file")
    run.add_argument("--png", type=Path, metavar="OUT", help="save a picture of the end")
    listing = commands.add_parser("worlds", help="list the worlds")
    listing.add_argument("--json", action="store_true", help="whole, as JSON")
    return parser


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


def _run(options: argparse.Namespace) -> int:
    source = _read(options.file)
    name = "program.py" if options.file == "-" else Path(options.file).name
    trace = run_program(source, options.world, options.seed, filename=name)
    outcome = outcome_of(trace)
    if options.trace is not None:
        with options.trace.open("w", encoding="utf-8") as file:
            trace.save(file)
    if options.json:
        print(json.dumps(outcome, ensure_ascii=False))
    else:
        _show(trace, outcome)
    return 0 if outcome["status"] == "finished" else 1


def _show(trace: Trace, outcome: dict[str, Any]) -> None:
    for event in trace.of_kind("print"):
        print(event["text"], end="", file=getattr(sys, event["stream"]))
    print(outcome["message"], file=sys.stderr)


def _worlds(options: argparse.Namespace) -> int:
    every = [worlds.load(name) for name in worlds.names()]
    if options.json:
        print(json.dumps([world.to_dict() for world in every], ensure_ascii=False, indent=2))
    else:
        for world in every:
            print(f"{world.name:16} {world.description}")
    return 0
