"""The picture of a run's end, pixel by pixel where it matters."""

import builtins
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from bugbot.picture import PictureError, save_picture
from bugbot.worlds import World

Run = Callable[..., Any]


@pytest.fixture
def picture(
    run_calls: Run, make_world: Callable[..., World], tmp_path: Path
) -> Callable[..., Callable[[float, float], Any]]:
    """Runs a program and returns what is at (x, y) cm in its picture."""

    def make(program: str, *boxes: tuple[float, ...]) -> Callable[[float, float], Any]:
        file = tmp_path / "end.png"
        save_picture(run_calls(program, make_world(*boxes)).trace, file)
        image = Image.open(file).convert("RGB")
        assert image.size == (880, 880)
        return lambda x, y: "#{:02x}{:02x}{:02x}".format(
            *image.getpixel((round(40 + 4 * x), round(40 + 4 * (200 - y))))  # type: ignore[misc]
        )

    return make


def test_mat_obstacle_robot_and_trail_lie_where_they_should(picture: Any) -> None:
    at = picture("forward(100, 50)", (20, 150, 40, 8))
    assert at(-5, 120) == "#f7f4ec"
    assert at(10, 10) == "#ffffff"
    assert at(40, 154) == "#c9c2b2"
    assert at(40, 148) == "#ffffff"
    assert at(103, 150) == "#2f7d55"  # the robot, 50 cm further up
    assert at(100, 153) == "#ffffff"  # its nose points up
    assert at(100, 120) == "#7fae93"  # where it came along


def test_layers_have_their_shape_colour_and_place(picture: Any) -> None:
    at = picture("""
        draw("cells", [(12.5, 12.5), (17.5, 12.5)], "#9ecae1", "squares", 5)
        draw("dot", [(50, 50)], "red", "dots", 10)
        draw("way", [(60, 20), (90, 20)], "blue", "line", 2)
        draw("words", [(150, 50)], "black", "text", 20)
        draw("gone", [(150, 150)], "red", "squares", 20)
        draw("gone", [])
    """)
    assert at(10.5, 10.5) == at(15, 12) == at(19.5, 14.5) == "#9ecae1"
    assert at(9.5, 12) == at(12, 15.5) == "#ffffff"
    assert at(50, 54) == "#ff0000"
    assert at(54.2, 54.2) == "#ffffff"  # a dot is round
    assert at(75, 20.5) == "#0000ff"
    assert at(151.5, 151.5) == "#ffffff"
    words = {at(150 + dx / 2, 50 + dy / 2) for dx in range(-60, 60) for dy in range(-20, 20)}
    assert "#000000" in words


def test_without_pillow_it_says_how_to_get_it(
    run_calls: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    trace = run_calls("").trace
    real = builtins.__import__

    def without_pillow(name: str, *rest: Any) -> Any:
        if name.startswith("PIL"):
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without_pillow)
    with pytest.raises(PictureError, match="--png needs Pillow: python -m pip install pillow"):
        save_picture(trace, tmp_path / "x.png")
