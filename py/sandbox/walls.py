"""Which walls the system can put round a process, and how to start a command behind them.

May import: the standard library, `sandbox.inside`.

Bubblewrap is taken where it is installed and works, else Linux's own calls (`inside.py`) where they
are allowed. Where neither is (macOS, Windows, a container that forbids it) there are no walls:
Node's fences and the page's stand alone, and whoever asks is told so.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from sandbox import inside

__all__ = ["NONE", "Walls", "innermost", "walls_for"]

_SYSTEM = ("/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache")
"""What a program of this system is linked with."""

_PATIENCE_S = 20.0


@dataclass(frozen=True, slots=True)
class Walls:
    """What stands round a process; `held` says it for a report."""

    held: str
    before: tuple[str, ...] = ()
    """What a command is put behind."""

    def round(self, command: Sequence[str]) -> list[str]:
        """The command, behind these walls."""
        return [*self.before, *command]


NONE = Walls("this system gives it no walls of its own: only Node's")


@cache
def walls_for(program: str, folder: str) -> Walls:
    """The best walls that hold round a program; it may read its libraries and a folder."""
    paths = [*_SYSTEM, folder]
    if not any(Path(program).is_relative_to(path) for path in paths):
        paths.append(program)
    for walls in _known(paths, folder):
        if _stand(walls, program, folder):
            return walls
    return NONE


def _known(paths: Sequence[str], folder: str) -> Iterator[Walls]:
    if not sys.platform.startswith("linux"):
        return
    words = "files, processes, network and a user of its own"
    bubblewrap = shutil.which("bwrap")
    if bubblewrap is not None:
        yield Walls(f"bubblewrap gives it {words}", (bubblewrap, *_bubblewrap(paths, folder)))
    helper = (sys.executable, "-I", "-S", inside.__file__, *paths, "--")
    yield Walls(f"Linux's namespaces give it {words}", helper)


def _bubblewrap(paths: Sequence[str], folder: str) -> Iterator[str]:
    yield from ("--unshare-all", "--unshare-user", "--uid", "65534", "--gid", "65534")
    yield from (
        "--die-with-parent",
        "--new-session",
        "--as-pid-1",
        "--cap-drop",
        "ALL",
        "--clearenv",
    )
    for path in map(Path, paths):
        if path.is_symlink():
            yield from ("--symlink", str(path.readlink()), str(path))
        elif path.exists():
            yield from ("--ro-bind", str(path), str(path))
    yield from ("--remount-ro", "/", "--chdir", folder, "--")


def _stand(walls: Walls, program: str, folder: str) -> bool:
    """Do they let the program start?"""
    try:
        done = subprocess.run(
            walls.round([program, "--version"]),
            cwd=folder,
            env={},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=_PATIENCE_S,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0 and done.stdout.strip() != b""


def innermost(pid: int) -> int:
    """The process that stands behind the walls that were started as this one."""
    children = {parent: child for child, parent in _parents()}
    while pid in children:
        pid = children[pid]
    return pid


def _parents() -> Iterator[tuple[int, int]]:
    """Each process of this system with its parent, as far as we may know."""
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                stat = (folder / "stat").read_text("utf-8", "replace")
            except OSError:
                continue  # it has ended meanwhile
            yield int(folder.name), int(stat.rpartition(")")[2].split()[1])
