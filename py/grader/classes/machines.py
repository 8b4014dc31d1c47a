"""Marks on the machines of a dask cluster.

May import: the standard library, `distributed`, `grader.classes.work`, `grader.lesson`.

Each machine needs the project's folder, as it is here, and its workers must find the Python in it:

    PYTHONPATH=py dask worker ADDRESS --nthreads 1 --nworkers auto

The submissions and the checks travel with the work; the sandbox is the worker machine's own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from grader.classes.work import Row, Work, mark_work, not_marked
from grader.lesson import CourseError

__all__ = ["by_machines"]

WAIT_S = 10
"""For the scheduler to answer."""


def by_machines(works: Sequence[Work], address: str) -> Iterator[Row]:
    """The rows, as they come from the cluster. What is not done is called off at the end."""
    try:
        from distributed import Client, as_completed
    except ImportError:
        raise CourseError(
            "--dask needs the package distributed: pip install 'bugbot-lessons[dask]'"
        ) from None
    try:
        client = Client(address, timeout=WAIT_S, set_as_default=False)
    except (OSError, ValueError) as error:
        raise CourseError(f"no dask scheduler answers at {address}: {error}") from None
    with client:
        if not client.scheduler_info()["workers"]:
            raise CourseError(f"the scheduler at {address} has no workers yet: start some")
        # Not pure: the same file twice is marked twice, as on one machine.
        futures = client.map(mark_work, list(works), pure=False)
        waiting = dict(zip((each.key for each in futures), works, strict=True))
        try:
            for future in as_completed(futures, loop=client.loop):
                work = waiting.pop(future.key)
                wrong = future.exception()
                yield future.result() if wrong is None else not_marked(work, _words(wrong))
        finally:
            client.cancel(futures)


def _words(error: BaseException) -> str:
    if isinstance(error, ModuleNotFoundError) and error.name and error.name.startswith("grader"):
        return "a worker does not find the project's Python: start it with PYTHONPATH=py"
    return f"{type(error).__name__}: {error}"
