"""Rounding that makes every engine keep the same numbers.

May import: nothing.

Sines and cosines differ in their last bits between engines. Rounded as it is
stored, the state does not, and everything computed from it by plain arithmetic is equal
to the last bit. Multiplying, rounding to a whole number and dividing gives what
round(value, 9) gives; it is plain arithmetic too, and six times as fast where Python is
compiled to WebAssembly.
"""

__all__ = ["stored", "unit"]


def stored(value: float) -> float:
    """A time, place or heading as the simulator keeps it: 9 decimals.

    >>> stored(0.1 + 0.2)
    0.3
    """
    return round(value * 1e9) / 1e9


def unit(value: float) -> float:
    """A sine or cosine: 12 decimals.

    >>> from math import cos, pi
    >>> unit(cos(pi / 2))
    0.0
    """
    return round(value * 1e12) / 1e12
