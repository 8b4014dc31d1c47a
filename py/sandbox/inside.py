"""Makes walls round a command with Linux's own calls: python inside.py PATH … -- COMMAND …

The command finds the paths that are named, read-only, and nothing else of this machine: no other
files, no other process, no network. It has no rights, can't gain any, and ends when we end.
Uses the standard library alone, and nothing of it is left in the command's process.
"""

from __future__ import annotations

import ctypes
import os
import stat
import sys
from collections.abc import Sequence
from typing import NoReturn

REFUSED = 97
"""The exit status if the system does not allow it."""

_NEW = 0x00020000 | 0x04000000 | 0x08000000 | 0x10000000 | 0x20000000 | 0x40000000
"""Mounts, host's name, inter-process communication, users, processes, network."""

_READ_ONLY, _NO_SUID, _NO_DEVICES, _REMOUNT, _BIND, _REC, _PRIVATE = (
    1,
    2,
    4,
    32,
    4096,
    16384,
    1 << 18,
)
_DETACH = 2
_KEPT_FLAGS = {
    os.ST_NOEXEC: 8,
    os.ST_NOATIME: 1024,
    os.ST_NODIRATIME: 2048,
    os.ST_RELATIME: 1 << 21,
}
"""Flags of a mount that may not be dropped, as `statvfs` and as `mount` call them."""

_DIE_WITH_PARENT, _NO_NEW_RIGHTS = 1, 38
_SIGKILL = 9
_PIVOT_ROOT = {"x86_64": 155, "aarch64": 41, "riscv64": 41, "i686": 217, "armv7l": 218}
_NOBODY = 65534
_ROOT = "/tmp"
"""Hidden by the new root while that is made; it has to be there."""

_libc = ctypes.CDLL(None, use_errno=True)


def main(arguments: Sequence[str]) -> int:
    """Make the walls and carry the command out behind them; its exit status."""
    end = arguments.index("--")
    paths, command = arguments[:end], arguments[end + 1 :]
    here = os.getcwd()
    try:
        _leave()
        _close_in([path for path in paths if os.path.lexists(path)])
        os.chdir(here)
    except OSError as error:
        print(f"walls: {error}", file=sys.stderr)
        return REFUSED
    child = os.fork()  # the first process of its own
    if child == 0:
        _carry_out(command)
    for number in (0, 1):
        os.close(number)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def _call(name: str, *arguments: object) -> None:
    if getattr(_libc, name)(*arguments) == -1:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")


def _leave() -> None:
    uid, gid = os.getuid(), os.getgid()
    _call("unshare", _NEW)
    for name, text in (
        ("setgroups", "deny"),
        ("uid_map", f"{_NOBODY} {uid} 1"),
        ("gid_map", f"{_NOBODY} {gid} 1"),
    ):
        with open(f"/proc/self/{name}", "w") as file:
            file.write(text)


def _mount(source: str | None, target: str, kind: str | None, flags: int, data: str = "") -> None:
    encoded = [None if each is None else os.fsencode(each) for each in (source, target, kind)]
    _call("mount", *encoded, ctypes.c_ulong(flags), os.fsencode(data) or None)


def _close_in(paths: Sequence[str]) -> None:
    """Have a root of nothing but these paths."""
    links = {path: os.readlink(path) for path in paths if os.path.islink(path)}
    opened = {path: os.open(path, os.O_PATH) for path in paths if path not in links}
    _mount("none", "/", None, _REC | _PRIVATE)
    _mount("none", _ROOT, "tmpfs", _NO_SUID | _NO_DEVICES, "size=1m,mode=755")
    for path, target in links.items():
        os.symlink(target, f"{_ROOT}{path}")
    for path, number in opened.items():
        place = f"{_ROOT}{path}"
        if stat.S_ISDIR(os.fstat(number).st_mode):
            os.makedirs(place, exist_ok=True)
        else:
            os.makedirs(os.path.dirname(place), exist_ok=True)
            os.close(os.open(place, os.O_CREAT | os.O_WRONLY, 0o600))
        _mount(f"/proc/self/fd/{number}", place, None, _BIND)
        os.close(number)
        before = os.statvfs(place).f_flag
        kept = sum(flag for said, flag in _KEPT_FLAGS.items() if before & said)
        _mount(None, place, None, _REMOUNT | _BIND | _READ_ONLY | _NO_SUID | _NO_DEVICES | kept)
    _mount(None, _ROOT, None, _REMOUNT | _READ_ONLY | _NO_SUID | _NO_DEVICES, "size=1m")
    os.chdir(_ROOT)
    _call("syscall", _PIVOT_ROOT[os.uname().machine], b".", b".")
    _call("umount2", b".", _DETACH)


def _carry_out(command: Sequence[str]) -> NoReturn:
    try:
        _call("prctl", _DIE_WITH_PARENT, _SIGKILL, 0, 0, 0)
        _call("prctl", _NO_NEW_RIGHTS, 1, 0, 0, 0)
        os.execv(command[0], list(command))  # as nobody: what rights there were are gone by this
    except OSError as error:
        print(f"walls: {error}", file=sys.stderr)
    os._exit(REFUSED)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
