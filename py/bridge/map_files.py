"""The two files of a ROS map among files that somebody chose, or in a zip archive of them.

`zipfile` is imported where it is needed: it is not in the snapshot, so the page brings it first.
"""

from __future__ import annotations

import io
import zlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from posixpath import basename, dirname, join, normpath
from typing import TYPE_CHECKING

from bugbot.errors import WrongValueError

if TYPE_CHECKING:
    from zipfile import ZipInfo

__all__ = ["MOST_BYTES", "MapFile", "image_for", "text_of", "unpacked", "yaml_among"]

_YAML = (".yaml", ".yml")
_IMAGE = (
    *(".pgm", ".png", ".pbm", ".ppm", ".pnm"),
    *(".bmp", ".jpg", ".jpeg", ".gif", ".tif", ".tiff", ".webp"),
)
MOST_BYTES = 80_000_000
"""Of all unpacked files together: more than any map that a page can show."""


@dataclass(frozen=True)
class MapFile:
    """A file by its name; in an archive its path there."""

    name: str
    data: bytes


def unpacked(files: Sequence[MapFile]) -> list[MapFile]:
    """The files, with those of an archive in its place. What a Mac adds of its own is left out.

    Raises WrongValueError if two have one name, as nobody could tell which is meant.
    """
    found: list[MapFile] = []
    for file in files:
        inner = _inside(file) if file.name.lower().endswith(".zip") else [file]
        found += [each for each in inner if not _is_a_macs_own(each.name)]
    names = [file.name for file in found]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise WrongValueError(f"there are two files called {twice[0]}: choose the files of one map")
    return found


def _is_a_macs_own(path: str) -> bool:
    return path.startswith("__MACOSX/") or basename(path).startswith(("._", ".DS_Store"))


def _inside(file: MapFile) -> Iterator[MapFile]:
    import zipfile

    left = MOST_BYTES
    try:
        with zipfile.ZipFile(io.BytesIO(file.data)) as archive:
            for entry in archive.infolist():
                if entry.is_dir() or not entry.filename.lower().endswith(_YAML + _IMAGE):
                    continue
                left -= entry.file_size
                if left < 0:
                    raise WrongValueError(
                        f"the files in {file.name} take more than {MOST_BYTES:,} bytes"
                    )
                if entry.flag_bits & 1:
                    raise WrongValueError(
                        f"{file.name} is locked with a password: unpack it and choose its files"
                    )
                yield MapFile(_path(entry), archive.read(entry))
    except (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, EOFError):
        raise WrongValueError(
            f"{file.name} is no zip archive, or it is damaged: unpack it and choose its files"
        ) from None


def _path(entry: ZipInfo) -> str:
    """Its name; a Mac writes UTF-8 without saying so."""
    name = entry.filename
    if not entry.flag_bits & 0x800:
        with suppress(UnicodeError):
            name = name.encode("cp437").decode()
    return name.replace("\\", "/")


def yaml_among(files: Sequence[MapFile]) -> MapFile:
    """The one YAML file; WrongValueError if there is none, or several."""
    found = [file for file in files if file.name.lower().endswith(_YAML)]
    if len(found) == 1:
        return found[0]
    if found:
        names = ", ".join(sorted(file.name for file in found))
        raise WrongValueError(f"choose one map at a time: there are {names}")
    there = ", ".join(sorted(file.name for file in files)) or "nothing"
    raise WrongValueError(
        "a ROS map is a YAML file and an image: choose both together, or a zip archive of the "
        f"two; there is no YAML file among {there}"
    )


def text_of(file: MapFile) -> str:
    """UTF-8, or UTF-16 with a mark at its beginning, as nav2 reads both."""
    data = file.data
    try:
        if data.startswith((b"\xff\xfe", b"\xfe\xff")) and len(data) > 2:
            return data.decode("utf-16")
        return data.decode("utf-8")
    except UnicodeDecodeError:
        raise WrongValueError(
            f"{file.name} does not hold text in UTF-8: save it as UTF-8, if it is a YAML file"
        ) from None


def image_for(files: Sequence[MapFile], yaml: MapFile, wanted: str) -> tuple[MapFile, list[str]]:
    """The image that a YAML file names, and what ROS would mind about the name.

    Chosen files have no folders, so the folder in the name does not count where only one fits.
    """
    others = [file for file in files if file is not yaml]
    beside = normpath(join(dirname(yaml.name), _plain(wanted)))
    for file in others:
        if _plain(file.name) == beside and "\\" not in wanted:
            return file, []
    bare = basename(_plain(wanted))
    for same in (str, str.lower):
        fitting = [file for file in others if same(basename(_plain(file.name))) == same(bare)]
        if len(fitting) == 1:
            return fitting[0], _minded(yaml, wanted, fitting[0])
        if fitting:
            names = ", ".join(sorted(file.name for file in fitting))
            raise WrongValueError(
                f"{yaml.name} names the image {wanted}, which could be one of {names}: choose the "
                "two files of the map alone"
            )
    there = f"; there is {', '.join(sorted(file.name for file in others))}" if others else ""
    raise WrongValueError(
        f"{yaml.name} names the image {bare or '(none)'}, which was not chosen with it: choose "
        f"both together{there}"
    )


def _plain(name: str) -> str:
    """With slashes, and each accented letter as one sign: a Mac's archives write two."""
    from unicodedata import normalize

    return normalize("NFC", name.replace("\\", "/"))


def _minded(yaml: MapFile, wanted: str, found: MapFile) -> list[str]:
    """An image in another folder is no matter where files were chosen, which have none."""
    if "\\" in wanted:
        return [f"{yaml.name} names the image {wanted}: ROS wants / in place of \\"]
    if basename(_plain(wanted)) != basename(_plain(found.name)):
        return [
            f"{yaml.name} names the image {wanted}, and the file is {basename(found.name)}: ROS "
            "tells capitals from small letters"
        ]
    if "/" in found.name:
        return [f"{yaml.name} names the image {wanted}, but in the archive it is {found.name}"]
    return []
