"""Probabilities and log odds."""

from math import inf, log, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.errors import WrongValueError
from mapping.log_odds import clamped, log_odds, probability


@pytest.mark.parametrize(
    ("p", "odds"), [(0.5, 0), (0.75, log(3)), (0.25, -log(3)), (0.9, log(9)), (0.1, -log(9))]
)
def test_the_table_both_ways(p, odds):
    assert log_odds(p) == pytest.approx(odds)
    assert probability(odds) == pytest.approx(p)


def test_the_evidence_of_the_lessons_is_what_it_is_called():
    assert probability(0.85) == pytest.approx(0.70, abs=0.001)
    assert probability(-0.4) == pytest.approx(0.40, abs=0.002)


@pytest.mark.parametrize("p", [0, 1, -0.1, 1.1, nan, inf])
def test_no_log_odds_for_certainty_or_nonsense(p):
    with pytest.raises(WrongValueError, match=r"log_odds\(p\) wants a probability above 0 and"):
        log_odds(p)


@given(st.floats(1e-9, 1 - 1e-9))
def test_probability_undoes_log_odds(p):
    assert probability(log_odds(p)) == pytest.approx(p, rel=1e-6)


@given(st.floats(-30, 30))
def test_log_odds_undoes_probability(odds):
    # Near p = 1 a float has few digits left to say how near.
    assert log_odds(probability(odds)) == pytest.approx(odds, rel=1e-3, abs=1e-9)


@given(st.floats(allow_nan=False))
def test_any_log_odds_have_a_probability_and_its_mirror(odds):
    assert 0 <= probability(odds) <= 1
    assert probability(odds) + probability(-odds) == pytest.approx(1)


@given(st.floats(0.01, 0.99), st.floats(0.01, 0.99))
def test_adding_log_odds_is_bayes_rule(prior, p):
    together = prior * p / (prior * p + (1 - prior) * (1 - p))
    assert probability(log_odds(prior) + log_odds(p)) == pytest.approx(together)


@given(st.floats(-100, 100), st.floats(0.1, 50))
def test_clamping_keeps_what_is_within_and_its_sign(odds, limit):
    kept = clamped(odds, limit)
    assert -limit <= kept <= limit
    assert kept == odds or abs(kept) == limit
    assert kept * odds >= 0
