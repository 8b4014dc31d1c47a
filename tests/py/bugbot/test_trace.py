import io
import json
import sys
from array import array
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot import trace as trace_module
from bugbot.trace import KINDS, Trace, TraceError, storable

WORLD = {"name": "empty"}

SAMPLES: dict[str, tuple[Any, ...]] = {
    "pose": (0.5, 100.0, 101.5, 359.5),
    "scan": (0.5, 100.0, 101.5, 0.0, [-19.6875, 50.1, 0.0, 200.0]),
    "plot": (0.5, "known %", 12.5),
    "print": (0.5, "stderr", "größer\n"),
    "note": (0.5, 7, "forward(500) counts as forward(100)"),
    "line": (0.5, 7),
    "led": (0.5, 255, 0, 128),
    "beep": (0.5, 440.0, 200.0),
    "bump": (0.5, 100.0, 150.0),
    "fault": (0.5, "NameError", "name 'x' is not defined", 3, None, "Traceback"),
    "end": (0.5, "finished", "Finished after 0.5 s."),
}


def recorded() -> Trace:
    trace = Trace("print(1)\n", WORLD, 7)
    for kind, values in SAMPLES.items():
        trace.add(kind, *values)
    trace.layer(0.5, "free", [(102.5, 7.25), (0, 200)], "black", "squares", 5)
    trace.layer(0.5, "goal", [(1, 2)], "red", "text", 4, ["here"])
    return trace


def saved(trace: Trace) -> list[str]:
    file = io.StringIO()
    trace.save(file)
    return file.getvalue().splitlines(keepends=True)


def test_every_kind_comes_back_from_a_file_as_it_went_in() -> None:
    trace = recorded()
    again = Trace.load(saved(trace))
    assert again.header == json.loads(json.dumps(trace.header))
    assert again.events == [tuple(event) for event in trace.events]
    assert again.points == trace.points
    assert {event[0] for event in again.events} == set(KINDS)


def test_the_format_of_the_file_has_not_changed(golden: Callable[[str, str], None]) -> None:
    """Saved runs must open in later versions: a changed line here wants a new VERSION."""
    golden("every-kind.trace", "".join(saved(recorded())))


def test_of_kind_gives_the_names_of_the_fields() -> None:
    (fault,) = recorded().of_kind("fault")
    assert fault["type"] == "NameError"
    assert list(fault) == list(KINDS["fault"])


def test_points_are_kept_to_a_hundredth_of_a_cm_and_at_most_so_far_off() -> None:
    trace = Trace("", WORLD, 0)
    trace.layer(0, "a", [(1.234, 5.006), (-1e9, 1e300)], "red", "dots", 2)
    (layer,) = trace.of_kind("layer")
    assert trace.points_of(layer) == [(1.23, 5.01), (-327.67, 327.67)]


def test_a_layer_drawn_again_unchanged_stores_no_points() -> None:
    trace = Trace("", WORLD, 0)
    for _ in range(3):
        trace.layer(0, "a", [(1, 2), (3, 4)], "red", "dots", 2)
        trace.layer(0, "b", [(9, 9)], "red", "dots", 2)
    assert len(trace.points) == 6
    assert [layer["first"] for layer in trace.of_kind("layer")] == [0, 2, 0, 2, 0, 2]


@pytest.mark.parametrize("wrong", [float("nan"), float("inf")])
def test_a_layer_without_finite_points_is_refused_and_nothing_is_kept(wrong: float) -> None:
    trace = Trace("", WORLD, 0)
    with pytest.raises(ValueError, match=r"nan|inf"):
        trace.layer(0, "a", [(1, 2), (3, wrong)], "red", "dots", 2)
    assert trace.events == []
    assert len(trace.points) == 0


def test_the_memory_of_coordinates_is_bounded() -> None:
    trace = Trace("", WORLD, 0)
    trace.layer(0, "a", [(i / 100, i / 100) for i in range(20_100)], "red", "dots", 2)
    assert trace.points[-1] == 20_099
    assert len(trace._quantise) == 20_000


def test_prints_of_one_moment_and_stream_are_joined_up_to_a_length() -> None:
    trace = Trace("", WORLD, 0)
    trace.write(0, "stdout", "a")
    trace.write(0, "stdout", "b" * 1000)
    trace.write(0, "stdout", "c")
    trace.write(0, "stderr", "d")
    trace.write(1, "stderr", "e")
    assert [event[3][-1] for event in trace.events] == ["b", "c", "d", "e"]


def test_size_counts_everything_also_what_has_been_taken() -> None:
    trace = Trace("", WORLD, 0)
    trace.write(0, "stdout", "x" * 100)
    trace.layer(0, "a", [(1, 2)], "red", "text", 2, ["words"])
    before = trace.bytes
    assert before >= 100 + 4 + 5
    trace.take()
    assert trace.bytes == before


def test_taking_hands_over_only_what_is_new() -> None:
    trace = Trace("", WORLD, 0)
    trace.layer(0, "a", [(1, 2)], "red", "dots", 2)
    rows, points = trace.take()
    assert json.loads(rows) == [["layer", 0, "a", "red", "dots", 2, 0, 1, None]]
    assert points == array("h", [100, 200]).tobytes()
    trace.layer(1, "a", [(1, 2)], "red", "dots", 2)
    trace.layer(1, "b", [(3, 4)], "red", "dots", 2)
    rows, points = trace.take()
    assert [(row[2], row[6]) for row in json.loads(rows)] == [("a", 0), ("b", 1)]
    assert points == array("h", [300, 400]).tobytes()
    assert trace.take() == ("[]", b"")


def test_files_are_little_endian_on_every_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    trace = recorded()
    little = saved(trace)
    monkeypatch.setattr(
        trace_module.sys, "byteorder", "big" if sys.byteorder == "little" else "little"
    )
    assert saved(trace)[-1] != little[-1]
    assert Trace.load(saved(trace)).points == trace.points


HEADER = saved(Trace("", WORLD, 0))[0]
POINTS = '["points",""]'


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([], "line 1: not JSON"),
        (["nonsense"], "line 1: not JSON"),
        (["[]"], 'line 1: not a trace: "format" should be "bugbot-trace"'),
        (['{"format": "other"}'], 'line 1: not a trace: "format" should be "bugbot-trace"'),
        (
            [HEADER.replace('"version":1', '"version":9')],
            "line 1: version 9; this reads version 1",
        ),
        ([HEADER.replace('"seed":0', '"seed":"0"')], 'line 1: "seed" should be of type int'),
        ([HEADER.replace('"program":""', '"program":null')], '"program" should be of type str'),
        ([HEADER.replace('{"name":"empty"}', "[]")], '"world" should be of type dict'),
        ([HEADER, "{"], "line 2: not JSON"),
        ([HEADER, "{}"], "line 2: an event is a list that begins with its kind"),
        ([HEADER, "[]"], "line 2: an event is a list that begins with its kind"),
        ([HEADER, "[3]"], "line 2: an event is a list that begins with its kind"),
        ([HEADER, "", '["jump",1]'], "line 3: unknown kind 'jump'; known: pose, scan, layer"),
        ([HEADER, '["bump",1,2]'], "line 2: bump has 3 values (t, x, y), not 2"),
        ([HEADER, '["points",3]'], "line 2: the points are not base64"),
        ([HEADER, '["points","A"]'], "line 2: the points are not base64"),
        ([HEADER, '["points","AAAA"]'], "line 2: the points are not base64"),
        ([HEADER, '["points","AAA="]'], "line 2: the points do not come in pairs"),
        ([HEADER, POINTS, '["bump",0,1,2]'], "line 3: there is more after the points"),
        ([HEADER, '["bump",0,1,2]'], "the points, the last row, are missing"),
        (
            [HEADER, '["layer",0.5,"a","red","dots",2,0,3,null]', POINTS],
            "the layer 'a' at 0.5 s wants 3 points from number 0, but the file has 0",
        ),
        (
            [HEADER, '["layer",0.5,"a","red","dots",2,-1,1,null]', POINTS],
            "wants 1 points from number -1",
        ),
        (
            [HEADER, '["layer",0.5,"a","red","dots",2,"x",1,null]', POINTS],
            "from number 'x'",
        ),
    ],
)
def test_a_broken_file_is_refused_by_line(lines: list[str], message: str) -> None:
    with pytest.raises(TraceError) as refusal:
        Trace.load(lines)
    assert message in str(refusal.value)


@given(st.text())
def test_storable_text_can_always_be_written_as_utf8(text: str) -> None:
    assert storable(text).encode("utf-8").decode("utf-8") == storable(text)


def test_storable_keeps_what_it_can() -> None:
    assert storable("Größe 20 cm") == "Größe 20 cm"
    assert storable("a\ud83eb") == "a\ufffd\ufffd\ufffdb"
