"""YAML as people and programs write it: what is read, and what is refused in words."""

import pytest

from bugbot.errors import WrongValueError
from mapping.map_yaml import Mode, Reader, Settings, read_settings, settings_of

LINES = {
    "image": "map.pgm",
    "mode": "trinary",
    "resolution": "0.05",
    "origin": "[1, 2, 3]",
    "negate": "0",
    "occupied_thresh": "0.65",
    "free_thresh": "0.196",
}
RIGHT = Settings("map.pgm", Mode.TRINARY, 0.05, (1.0, 2.0, 3.0), False, 0.65, 0.196)


def text(sep: str = ": ", **changed: str) -> str:
    return "".join(f"{name}{sep}{value}\n" for name, value in {**LINES, **changed}.items())


FLOW = "{" + ", ".join(f"{name}: {value}" for name, value in LINES.items()) + "}"


@pytest.mark.parametrize(
    "written",
    [
        text(),
        text(sep=":\t"),
        text(sep=" : "),
        text().replace("\n", "\r\n"),
        "\ufeff" + text(),
        "%YAML 1.2\n---\n" + text() + "...\nanything: [\n",
        text() + "---\nimage: another\n",
        "".join(f"  {line}\n" for line in text().splitlines()),
        FLOW,
        FLOW.replace(", ", ",\n\t"),
        FLOW.replace("{image: ", '{"image":'),
        text(origin="[1,\n  2, 3]"),
        text(origin="\n- 1 # x\n- 2\t# y\n- 3"),
        text(origin="[1, 2, 3,]"),
        text(resolution="\n  0.05"),
        text(resolution='"0.05"', negate="'0'"),
        text(resolution="+5E-2 # m a cell"),
        text(resolution="&r .05") + "again: *r\n",
        text(image="map.pgm\t# beside this file"),
        text(image=">-\n  map.pgm"),
        text(image='"map\\x2epgm"'),
        text() + "my-key: 1\nnote: |\n  resolution: 9\nextra:\n  resolution: 9\n  list: [{a: 1}]\n",
        text() + "# a\x85b\u2028c\n",
        text().replace("resolution", '"resolution"'),
        text().replace("resolution: ", "? resolution\n: "),
    ],
)
def test_it_is_read_as_nav2_reads_it(written: str) -> None:
    assert read_settings(written) == RIGHT


@pytest.mark.parametrize(
    ("value", "wanted"),
    [
        ("1", True),
        ("2", True),
        ("-1", True),
        ("0x1", True),
        ("00", False),
        ("y", True),
        ("No", False),
        ("ON", True),
        ("off", False),
        ("true", True),
        ("False", False),
    ],
)
def test_negate_takes_any_whole_number_and_the_words_of_yaml(value: str, wanted: bool) -> None:
    assert read_settings(text(negate=value)).negate is wanted


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("", "has no `name: value` lines"),
        ("hello", "has no `name: value` lines"),
        (text(sep=":"), "has no `name: value` lines"),
        (
            text().replace("resolution", "Resolution"),
            "it has Resolution: names are in small letters",
        ),
        (text().replace("mode: ", "hello\nmode: "), "line 2 .*is no `name: value`"),
        (text() + "hello", "line 8 .*is no `name: value`: take it out.*'hello'"),
        (text().replace("resol", "  resol"), "line 3 .*it is indented.*'resolution: 0.05'"),
        (text().replace("resol", "\tresol"), "line 3 .*begins with a tab"),
        (text() + "resolution: 9\n", "line 8 .*gives resolution again, after line 3"),
        (text(image="[1].pgm"), "line 1 .*put quotes round names; it is 'image: \\[1\\].pgm'"),
        (text(image="@home.pgm"), "line 1 .*wants quotes"),
        (text(image='"map.pgm'), "is opened and never closed"),
        (text(image='"\\U00ffffff"'), "can't be read"),
        (text(image="''"), "line 1.*image should be the name of the image's file; it is ''"),
        (text(image="{a: 1}"), "neither a text nor a list"),
        (text(mode="binary"), "line 2.*mode should be trinary, scale or raw; it is 'binary'"),
        (text(resolution="0,05"), "line 3.*resolution should be a number; it is '0,05'"),
        (text(resolution="0.05#m"), "line 3.*resolution should be a number; it is '0.05#m'"),
        (text(resolution="0x10"), "should be a number"),
        (text(resolution=".inf"), "should be a number"),
        (text(resolution="1e400"), "should be a number"),
        (text(resolution="0"), r"line 3.*resolution should be above 0 \(m\), such as 0.05"),
        (text(origin="0, 0, 0"), r"line 4.*origin should be \[x, y, yaw\] in brackets"),
        (text(origin="[0, 0]"), r"line 4.*origin should be \[x, y, yaw\]"),
        (text(origin="[1_000, 0, 0]"), "line 4.*origin should be three numbers; it is '1_000'"),
        (text(negate="tRUE"), "line 5.*negate should be 0 or 1; it is 'tRUE'"),
        (text(negate="0.0"), "negate should be 0 or 1"),
        (
            text().replace("\n", "\r"),
            "carriage return alone: save the file with ordinary line ends",
        ),
        (text() + "# \a\n", r"line 8 .*U\+0007, which YAML forbids"),
        (text() + "deep: " + "[" * 5000, "never closed|too deep"),
        (text() + "x" * 100_000, "at most 100,000 characters"),
        (
            text().replace("negate: 0\n", ""),
            "YAML file has no negate: what is needed is image, res",
        ),
    ],
)
def test_what_is_refused_says_where_and_what_to_do(written: str, words: str) -> None:
    with pytest.raises(WrongValueError, match=f"(?s){words}"):
        read_settings(written)


def test_ros_1_takes_fewer_spellings() -> None:
    for changed in ({"negate": "true"}, {"mode": "Trinary"}):
        assert read_settings(text(**changed))
        with pytest.raises(WrongValueError):
            read_settings(text(**changed), Reader.ROS1)


SAID = {
    "image": "map.pgm",
    "resolution": 0.05,
    "origin": (1, 2, 3.0),
    "negate": False,
    "occupied_thresh": 0.65,
    "free_thresh": 0.196,
}


def test_a_dictionary_is_read_like_a_file_and_unknown_names_are_left_out() -> None:
    assert settings_of(SAID) == RIGHT
    assert settings_of({**SAID, "mode": "trinary", "note": 5}) == RIGHT


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"image": None}, "image should be"),
        ({"resolution": True}, "resolution should be a number; it is True"),
        ({"resolution": 10**400}, "resolution should be a number"),
        ({"origin": {0: 1, 1: 2, 2: 3}}, "origin should be"),
        ({"origin": "123"}, "origin should be"),
        ({"negate": 0.5}, "negate should be 0 or 1; it is 0.5"),
        ({"mode": 3}, "mode should be trinary"),
    ],
)
def test_a_setting_of_another_kind_is_refused(changed: dict[str, object], words: str) -> None:
    with pytest.raises(WrongValueError, match=words):
        settings_of({**SAID, **changed})


def test_a_missing_setting_is_named() -> None:
    with pytest.raises(WrongValueError, match="the settings have no negate"):
        settings_of({name: value for name, value in SAID.items() if name != "negate"})
