"""The pictures' drawing package: y turned over once, known classes only, words escaped."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from sketch import CLASSES, Drawing

CSS = Path(__file__).parents[2] / "site/src/page/sketch.css"
SVG = "{http://www.w3.org/2000/svg}"


def sheet() -> Drawing:
    return Drawing(100, 60, "A title", "What one sees.")


def parts(drawing: Drawing) -> list[ElementTree.Element]:
    text = drawing.svg().replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
    return list(ElementTree.fromstring(text))


def test_a_picture_says_what_it_is_to_who_cant_see_it():
    root = ElementTree.fromstring(sheet().svg())
    assert root.get("viewBox") == "0 0 100 60"
    assert root.get("role") == "img"
    assert [root.find(f"*[@id='{each}']").text for each in root.get("aria-labelledby").split()] == [
        "A title",
        "What one sees.",
    ]


def test_a_plane_has_its_own_units_and_y_up():
    plane = sheet().plane(10, 5, scale=2, width_cm=40, height_cm=20, origin=(100, 50))
    assert plane.on_sheet((100, 50)) == (10, 45), "its lower left corner"
    assert plane.on_sheet((140, 70)) == (90, 5), "its upper right corner"


def test_a_chart_may_have_another_scale_upwards():
    plane = sheet().plane(0, 0, scale=5, scale_y=50, width_cm=20, height_cm=1)
    assert plane.on_sheet((4, 0.5)) == (20, 25)


def test_a_cell_is_drawn_where_it_lies():
    drawing = sheet()
    drawing.plane(0, 0, scale=2, width_cm=20, height_cm=20).cells([(1, 0)], "free", 5)
    square = parts(drawing)[-1]
    place = [square.get(each) for each in ("x", "y", "width", "height")]
    assert place == ["10", "30", "10", "10"]
    assert square.get("class") == "free"


def test_the_robot_looks_where_its_heading_points():
    drawing = sheet()
    drawing.plane(0, 0, scale=1, width_cm=60, height_cm=60).robot((30, 30), 90)
    body, nose = parts(drawing)[-2:]
    assert (body.get("cx"), body.get("cy"), body.get("r")) == ("30", "30", "5")
    assert float(nose.get("cx")) > 30, "90 is right"
    assert nose.get("cy") == "30"


def test_an_arrows_head_lies_behind_its_tip_on_both_sides():
    drawing = sheet()
    drawing.arrow((0, 10), (20, 10))
    assert parts(drawing)[-1].get("d") == "M0 10L20 10M14 6.5L20 10L14 13.5"


@pytest.mark.parametrize(
    ("to_deg", "way"),
    [(90, "M50 20A10 10 0 0 1 60 30"), (-90, "M50 20A10 10 0 0 0 40 30")],
)
def test_an_arc_runs_between_two_headings(to_deg, way):
    drawing = sheet()
    drawing.arc((50, 30), 10, 0, to_deg, "outline")
    assert parts(drawing)[-1].get("d") == way


def test_words_are_escaped():
    drawing = sheet()
    drawing.text(1, 2, 'p < 0.35 & "so on"', "soft small")
    assert parts(drawing)[-1].text == 'p < 0.35 & "so on"'


def test_a_class_without_a_look_is_an_error_that_names_it():
    with pytest.raises(ValueError, match=r"'ink pink' has no look: pink is not among .*mat"):
        sheet().text(0, 0, "hello", "ink pink")


def test_every_class_has_a_rule_and_every_rule_a_class():
    # `middle` and `end` place words, `strong`, `small` and `code` shape them: rules of `text`.
    rules = set(
        re.findall(r"\.([a-z][a-z0-9-]*)", re.sub(r"/\*.*?\*/", "", CSS.read_text(), flags=re.S))
    )
    assert rules - {"sketch", "picture"} == CLASSES
