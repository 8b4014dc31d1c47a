"""Chance that a program has from Python and not from a seed of its own: it follows the run's.

May import: the standard library, `bugbot.sim.noise`, `bugbot.run.on_import`.

The same program, world and seed give the same trace, whether it asks `random`, NumPy,
`secrets`, `uuid` or `os.urandom`. All that Python takes from the operating system comes from one
generator; `random` and NumPy's old functions get a seed from it before the program begins.
"""

from __future__ import annotations

import os
import random
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from types import ModuleType
from typing import Any

from bugbot.run.on_import import Change, put_back
from bugbot.sim.noise import generator

__all__ = ["SeededChance"]

_NODE = 0x0242_AC11_0002
"""What uuid.uuid1() takes for the machine's address."""


class SeededChance:
    """What a run has in place of the operating system's chance."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        self._source = generator(seed, "system")

    def bytes(self, size: int, /) -> bytes:
        """os.urandom() during a run."""
        if size < 0:
            raise ValueError("negative argument not allowed")
        return self._source.randbytes(size)

    @contextmanager
    def at_work(self) -> Iterator[None]:
        """Inside this block `random`, `secrets` and `os.urandom` follow the seed."""
        seed_one = random.Random.seed
        state = random.getstate()
        source = self._source

        def seed(self: random.Random, a: Any = None, version: int = 2) -> None:
            """random.seed(): without a number it takes one of the run's own."""
            seed_one(self, source.getrandbits(128) if a is None else a, version)

        here = vars(random)["_inst"]
        names: dict[str, Any] = {
            "urandom": self.bytes,
            "getrandom": lambda size, flags=0: self.bytes(size),
        }
        with ExitStack() as undo:
            put_back(os, undo)
            put_back(random, undo)
            undo.callback(setattr, random.Random, "seed", seed_one)
            undo.callback(here.setstate, state)
            random.Random.seed = seed  # type: ignore[method-assign]
            vars(os).update((name, new) for name, new in names.items() if hasattr(os, name))
            vars(random).update(_urandom=self.bytes, seed=here.seed)
            here.seed(self._seed)
            yield

    def while_loading(self) -> Callable[[], None]:
        """Called before a module is loaded: what loading takes is given back afterwards.

        Whether a module was there before the run is no business of the program's.
        """
        state = self._source.getstate()
        return lambda: self._source.setstate(state)

    def changes(self) -> dict[str, Change]:
        """The modules that have chance of their own, and what makes it follow the seed."""
        return {"numpy.random": self._numpy, "uuid": _uuid}

    def _numpy(self, numpy_random: ModuleType, undo: ExitStack) -> None:
        # NumPy's generators without a seed ask `secrets`; only the old functions' state is its own.
        undo.callback(numpy_random.set_state, numpy_random.get_state())
        numpy_random.seed(generator(self._seed, "numpy").getrandbits(32))


def _uuid(uuid: ModuleType, undo: ExitStack) -> None:
    put_back(uuid, undo)
    vars(uuid).update(_generate_time_safe=None, _UuidCreate=None, _node=_NODE)
