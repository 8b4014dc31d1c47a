"""What the page is told of the robot's calls: all of them, each once, with its own words."""

import inspect

import bugbot
from bridge.describe import describe


def test_every_public_call_is_in_one_group() -> None:
    grouped = [name for group in describe()["groups"] for name in group["names"]]
    public = {
        name
        for name in bugbot.__all__
        if inspect.isroutine(getattr(bugbot, name)) or name == "Robot"
    }
    assert sorted(grouped) == sorted(public)


def test_a_call_is_described_by_its_own_signature_and_docstring() -> None:
    (beep,) = [call for call in describe()["api"] if call["name"] == "beep"]
    assert beep["signature"] == "beep(freq, ms=200)"
    assert beep["summary"] == "Sound a tone while the program goes on."
    assert beep["doc"] == inspect.getdoc(bugbot.beep)
