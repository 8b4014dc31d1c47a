"""npm run fuzz: how many damaged files each reader took or refused, and which broke it.

    python -m fuzz [--cases N] [--seed S]

Ends with 1 and prints the case if a reader raised an error that is not its own.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from random import Random

from .targets import Target, all_targets


def fuzz(target: Target, cases: int, seed: int) -> tuple[int, int]:
    """How many of the cases were taken, and how many refused by an error of the reader's own."""
    taken = 0
    for number in range(cases):
        # A case can be had again by its number alone.
        case = target.damage(Random(f"{seed} {number}"))
        try:
            taken += target.read(case)
        except target.allowed:
            pass
        except Exception as error:
            error.add_note(f"{target.name}, seed {seed}, case {number}: {case!r}"[:3000])
            raise
    return taken, cases - taken


def main(arguments: Sequence[str] | None = None) -> int:
    """The command."""
    parser = argparse.ArgumentParser(prog="python -m fuzz")
    parser.add_argument("--cases", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    for target in all_targets():
        taken, refused = fuzz(target, options.cases, options.seed)
        print(
            f"{target.name:26} {options.cases} cases: {taken} taken, {refused} refused, 0 broke it"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
