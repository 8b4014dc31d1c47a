"""What there is of layers or lines, in words."""

from __future__ import annotations

import pytest

from grader.naming import perhaps_meant, what_there_is


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ([], "there is no layer"),
        (["a"], 'the only layer is "a"'),
        (["a", "b"], 'the layers are "a" and "b"'),
        (["a", "b", "c"], 'the layers are "a", "b" and "c"'),
    ],
)
def test_none_one_and_many_each_make_a_sentence(names: list[str], words: str) -> None:
    assert what_there_is("layer", "layers", names) == words


def test_only_a_name_that_is_nearly_the_same_was_perhaps_meant() -> None:
    told = perhaps_meant("line", "known %", ["known", "metres"])
    assert told == 'perhaps your line "known" is meant: call it "known %"'
    assert perhaps_meant("line", "known %", ["metres"]) is None
