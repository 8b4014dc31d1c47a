"""What `from bugbot import *` gives, and the help that goes with it."""

import doctest
import inspect
import pkgutil
from collections.abc import Callable

import pytest

import bugbot
from bugbot import api
from bugbot.link import Link, connected
from bugbot.run.slips.case import CALLS

BRIEF = {
    "drive": "(forward, right, turn)",
    "forward": "(speed=50, distance=None)",
    "backward": "(speed=50, distance=None)",
    "left": "(speed=50)",
    "right": "(speed=50)",
    "turn": "(degrees, speed=30)",
    "stop": "()",
    "wait": "(seconds)",
    "clock": "()",
    "scan": "()",
    "distance": "()",
    "position": "()",
    "heading": "()",
    "odometry": "()",
    "battery": "()",
    "draw": "(name, points, colour='black', shape='dots', size=2)",
    "plot": "(name, value)",
    "led": "(colour='off', green=None, blue=None)",
    "beep": "(freq, ms=200)",
    "connect": "(*address, **options)",
    "go": "()",
}


def test_all_lists_every_public_name_and_nothing_else() -> None:
    modules = {each.name for each in pkgutil.iter_modules(bugbot.__path__)}
    public = {name for name in vars(bugbot) if not name.startswith("_")} - modules
    assert set(bugbot.__all__) == public
    assert set(bugbot.__all__) == {*BRIEF, "Robot", "BugbotError"}
    assert bugbot.__all__ == sorted(bugbot.__all__)
    assert set(api.__all__) == {*BRIEF, "Robot"}


def test_no_module_hides_a_call_of_the_same_name() -> None:
    modules = {each.name for each in pkgutil.iter_modules(bugbot.__path__)}
    assert not modules & set(bugbot.__all__)


@pytest.mark.parametrize("name", BRIEF)
def test_the_calls_have_the_arguments_of_the_real_robot(name: str) -> None:
    parameters = inspect.signature(getattr(bugbot, name)).parameters.values()
    plain = [each.replace(annotation=each.empty) for each in parameters]
    assert f"({', '.join(map(str, plain))})" == BRIEF[name]


def test_the_class_has_every_call_as_a_method() -> None:
    for name in set(CALLS) - {"connect"}:
        assert getattr(bugbot.Robot, name) is getattr(bugbot, name)


@pytest.mark.parametrize("name", [*BRIEF, "Robot"])
def test_the_help_has_its_form(name: str) -> None:
    """One sentence; a line for each argument; an example."""
    thing = getattr(bugbot, name)
    text = inspect.getdoc(thing)
    assert text is not None
    first, _, rest = text.partition("\n")
    assert first.endswith(".")
    assert first.count(". ") == 0
    assert "\n>>> " in rest
    if name == "Robot":
        return
    for parameter in inspect.signature(thing).parameters:
        if parameter != "options":
            assert f"\n{parameter}: " in rest
    returns = inspect.signature(thing).return_annotation
    assert (returns != "None") == ("\nReturns " in rest)


@pytest.mark.parametrize("name", [*BRIEF, "Robot"])
def test_the_examples_in_the_help_run(name: str, make_link: Callable[..., Link]) -> None:
    finder, runner = doctest.DocTestFinder(recurse=False), doctest.DocTestRunner()
    names = {each: getattr(bugbot, each) for each in bugbot.__all__}
    (example,) = finder.find(getattr(bugbot, name), name, globs=names)
    with connected(make_link("post-and-shelf")):
        assert runner.run(example).failed == 0
    assert example.examples
