"""A few of the damaged files of `npm run fuzz`: no reader meets one with an error not its own."""

import pytest
from fuzz.__main__ import fuzz
from fuzz.targets import Target, all_targets

TARGETS = all_targets()


@pytest.mark.parametrize("target", TARGETS, ids=[target.name for target in TARGETS])
def test_damaged_files_are_taken_or_refused_in_words(target: Target) -> None:
    _taken, refused = fuzz(target, 150, seed=1)
    assert refused > 30
