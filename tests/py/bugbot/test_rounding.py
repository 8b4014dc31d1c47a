import doctest

from hypothesis import given
from hypothesis import strategies as st

from bugbot.sim import rounding
from bugbot.sim.rounding import stored, unit


def test_examples_in_the_docstrings_run() -> None:
    assert doctest.testmod(rounding).failed == 0


@given(st.floats(-1e5, 1e5))
def test_it_is_the_rounding_of_python_and_done_once_is_enough(value: float) -> None:
    assert abs(stored(value) - round(value, 9)) <= 1.001e-9  # they may differ on a tie
    assert stored(stored(value)) == stored(value)


@given(st.integers(-(10**14), 10**14))
def test_numbers_of_nine_decimals_stay_as_they_are(billionths: int) -> None:
    assert stored(billionths / 1e9) == billionths / 1e9


@given(st.floats(-1, 1))
def test_a_last_bit_makes_no_difference_away_from_a_tie(value: float) -> None:
    near = value + 1e-16
    fraction = abs(value * 1e12) % 1
    if abs(fraction - 0.5) > 0.01:
        assert unit(value) == unit(near)
