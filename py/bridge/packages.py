"""Unpacks packages that the page has sent, into an interpreter that is up."""

from __future__ import annotations

import importlib
import io
from typing import Any

__all__ = ["found_anew", "unpack"]


def unpack(archive: Any, folder: str) -> None:
    """Unpack a wheel, given as a Uint8Array, into a folder that Python imports from."""
    import zipfile  # it is in the standard library's archive, not in the snapshot

    with zipfile.ZipFile(io.BytesIO(archive.to_bytes())) as wheel:
        wheel.extractall(folder)
    found_anew()


def found_anew() -> None:
    """Make the interpreter look at its folders and archives again."""
    importlib.invalidate_caches()
