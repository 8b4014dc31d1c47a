"""Marks on this machine, some submissions side by side, each lane a process.

May import: the standard library, `grader.classes.work`.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool

from grader.classes.work import Row, Work, close_performer, mark_work, not_marked

__all__ = ["by_processes"]


def by_processes(works: Sequence[Work], processes: int) -> Iterator[Row]:
    """The rows, as they come. If whoever asks stops asking, the processes are ended at once."""
    # Spawned: a process that was forked would have our threads' locks, and our performer.
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(processes, mp_context=context, initializer=_begin)
    try:
        futures = {pool.submit(mark_work, work): work for work in works}
        for future in as_completed(futures):
            yield _row(future, futures[future])
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for each in multiprocessing.active_children():
            each.terminate()


def _row(future: Future[Row], work: Work) -> Row:
    try:
        return future.result()
    except BrokenProcessPool:
        return not_marked(work, "a process of the marking ended by itself: is there memory enough?")
    except Exception as error:
        return not_marked(work, f"{type(error).__name__}: {error}")


def _begin() -> None:
    # Ctrl-C is for the process that was asked; it ends these.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda _number, _frame: _end())
    threading.Thread(target=_outlive_nobody, daemon=True).start()


def _outlive_nobody() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        _end()


def _end() -> None:
    close_performer()
    os._exit(1)
