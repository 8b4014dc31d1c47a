"""The examples in the docstrings come out as they say."""

import doctest
import importlib
import pkgutil

import pytest

import mapping


@pytest.mark.parametrize("name", [each.name for each in pkgutil.iter_modules(mapping.__path__)])
def test_the_examples(name):
    assert doctest.testmod(importlib.import_module(f"mapping.{name}")).failed == 0
