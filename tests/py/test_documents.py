"""The documents keep their word: links lead somewhere, examples run, commands and names exist."""

import json
import re
from pathlib import Path

import pytest

import bugbot
from bugbot import worlds
from bugbot.run import run_program
from bugbot.run.outcome import outcome_of

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *sorted((ROOT / "site").glob("*.md")),
    ROOT / "lessons" / "README.md",
]
IDS = [str(path.relative_to(ROOT)) for path in DOCUMENTS]

_FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"\]\(([^)\s]+)\)")


def _prose(text: str) -> str:
    return _FENCE.sub("", text)


def _anchors(text: str) -> set[str]:
    """The headings as GitHub's addresses have them: lower case, words joined by "-"."""
    headings = re.findall(r"^#+ (.+)$", _prose(text), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", each).strip().lower().replace(" ", "-") for each in headings}


@pytest.mark.parametrize("document", DOCUMENTS, ids=IDS)
def test_links_lead_somewhere(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    broken = []
    for link in _LINK.findall(_prose(text)):
        if link.startswith(("https://", "http://", "mailto:")):
            continue
        path, _, anchor = link.partition("#")
        target = (document.parent / path) if path else document
        if not target.exists() or (
            anchor and anchor not in _anchors(target.read_text(encoding="utf-8"))
        ):
            broken.append(link)
    assert broken == []


@pytest.mark.parametrize("document", DOCUMENTS, ids=IDS)
def test_python_examples_run_or_at_least_compile(document: Path) -> None:
    for language, code in _FENCE.findall(document.read_text(encoding="utf-8")):
        if language != "python":
            continue
        if "from bugbot import *" not in code:
            compile(code, str(document), "exec")
            continue
        outcome = outcome_of(run_program(code, "empty", 1))
        assert outcome["status"] == "finished", outcome


@pytest.mark.parametrize("document", DOCUMENTS, ids=IDS)
def test_npm_commands_exist(document: Path) -> None:
    scripts = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))["scripts"]
    named = set(re.findall(r"npm run ([\w:-]+)", document.read_text(encoding="utf-8")))
    assert named - set(scripts) == set()


def test_the_readme_has_every_world_and_every_call() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    listed = re.findall(r"^\| `([a-z-]+)` \|", text, re.MULTILINE)
    assert sorted(set(listed) & set(worlds.names())) == sorted(worlds.names())
    calls = {each for each in bugbot.__all__ if each[0].islower()}
    missing = [each for each in sorted(calls) if f"{each}(" not in text]
    assert missing == []


def test_the_architecture_names_every_package() -> None:
    package = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    named = {*package["dependencies"], *package["devDependencies"]}
    # Types are of the package they describe; a star stands for the parts of one.
    missing = [
        name
        for name in sorted(named)
        if not name.startswith("@types/")
        and f"`{name}`" not in text
        and f"`{name.split('/')[0]}/*`" not in text
    ]
    assert missing == []
