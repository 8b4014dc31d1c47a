"""Chance of every source follows the run's seed, unless a program gives one of its own."""

import os
import random
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from bugbot.run.chance import SeededChance

Run = Callable[..., Any]

SOURCES = [
    "random.random()",
    "random.Random().random()",
    "random.SystemRandom().random()",
    "random.SystemRandom().randint(1, 10**9)",
    "(random.seed(), random.random())",
    "(random.seed(None), random.random())",
    "secrets.token_hex(8)",
    "secrets.randbelow(10**9)",
    "os.urandom(8)",
    "uuid.uuid4()",
    "uuid.uuid1()",
    "np.random.rand()",
    "np.random.randint(10**9)",
    "np.random.normal()",
    "np.random.default_rng().random()",
    "np.random.default_rng().normal()",
    "np.random.RandomState().rand()",
    "(np.random.seed(), np.random.rand())",
    "np.random.Generator(np.random.PCG64()).random()",
    "np.random.SeedSequence().entropy",
]
IMPORTS = "import os, random, secrets, uuid\nimport numpy as np\n"


@pytest.mark.parametrize("source", SOURCES)
def test_chance_follows_the_seed(run: Run, source: str) -> None:
    program = f"{IMPORTS}print({source}, {source})"
    first, again, other = run(program, seed=1), run(program, seed=1), run(program, seed=2)
    assert first.status == "finished", first.message
    assert first.console == again.console
    assert first.console != other.console
    one, two = first.console.split()[0], first.console.split()[-1]
    assert one != two or "seed" in source


def test_a_seed_of_the_programs_own_counts(run: Run) -> None:
    program = """
        import random
        import numpy as np
        random.seed(5)
        np.random.seed(5)
        print(random.random(), np.random.rand(), np.random.default_rng(5).random())
    """
    random.seed(5)
    np.random.seed(5)
    expected = f"{random.random()} {np.random.rand()} {np.random.default_rng(5).random()}\n"
    assert run(program, seed=1).console == run(program, seed=2).console == expected


def test_whether_a_module_was_loaded_before_makes_no_difference(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = "import os\nimport uuid\nprint(os.urandom(4), uuid.uuid4(), os.urandom(4))"
    loaded = run(program).console
    monkeypatch.delitem(sys.modules, "uuid")
    assert run(program).console == loaded


def test_what_loading_a_module_takes_is_given_back() -> None:
    chance, untouched = SeededChance(1), SeededChance(1)
    loaded = chance.while_loading()
    chance.bytes(40)
    loaded()
    assert chance.bytes(8) == untouched.bytes(8)


def test_the_hosts_chance_is_put_back(run: Run) -> None:
    np.random.seed(3)
    random.seed(3)
    expected = (np.random.rand(), random.random())
    np.random.seed(3)
    random.seed(3)
    before = (os.urandom, random.Random.seed, random.seed)
    run("import random\nimport numpy as np\nnp.random.rand()\nrandom.random()\nrandom.seed()")
    assert (np.random.rand(), random.random()) == expected
    assert before == (os.urandom, random.Random.seed, random.seed)
