"""Prints are told of at once, and a flood of them in as few words as can be."""

from bridge.kept import Kept


class Memory:
    """What the worker has in the end, if the interpreter broke now; `calls` counts."""

    def __init__(self) -> None:
        self.rows: list[tuple[float, str, str]] = []
        self.calls = 0

    def begin(self, t: float, stream: str) -> None:
        self.rows.append((t, stream, ""))

    def keep(self, text: str) -> None:
        self.calls += 1
        t, stream, before = self.rows[-1]
        self.rows[-1] = (t, stream, before + text)


def test_everything_is_kept_in_order_but_perhaps_the_last_newline() -> None:
    memory = Memory()
    kept = Kept(memory.begin, memory.keep)
    for t, stream, text in (
        *((0.0, "stdout", "a"), (0.0, "stdout", "\n"), (0.0, "stdout", "b"), (0.0, "stdout", "\n")),
        *((0.0, "stdout", "\n"), (0.0, "stderr", "oh"), (0.0, "stderr", "\n")),
        *((1.5, "stdout", "c"), (1.5, "stdout", "\n")),
    ):
        kept.add(t, stream, text)
    assert memory.rows == [
        (0.0, "stdout", "a\nb\n\n"),
        (0.0, "stderr", "oh\n"),
        (1.5, "stdout", "c"),
    ]


def test_a_print_costs_one_call() -> None:
    memory = Memory()
    kept = Kept(memory.begin, memory.keep)
    for number in range(100):
        kept.add(0.0, "stdout", str(number))
        kept.add(0.0, "stdout", "\n")
    assert memory.calls == 100


def test_what_has_been_sent_is_not_kept_again() -> None:
    memory = Memory()
    kept = Kept(memory.begin, memory.keep)
    kept.add(0.0, "stdout", "a")
    kept.add(0.0, "stdout", "\n")
    kept.sent()
    memory.rows = [(0.0, "stdout", "")]
    kept.add(0.0, "stdout", "b")
    assert memory.rows == [(0.0, "stdout", "b")]
