"""Files that a class might hold and that mean no good, each with what it tries.

`{class_folder}` and `{marks}` stand for the class's folder and the folder of its marks. Should a
fence be down, they do no more than spoil these two, and start 20 processes that end at once.
"""

from __future__ import annotations

from pathlib import Path

__all__ = ["HOSTILE", "hostile_program"]

HOSTILE = {
    "computes for ever": """
def cell_of(x, y):
    while True:
        pass
""",
    "eats memory": """
kept = []
def cell_of(x, y):
    for _ in range(80):
        kept.append(bytearray(50_000_000))
""",
    "writes to files": """
for path in ("{class_folder}/honest-1/cell-of-a-point.py", "{marks}/rows.jsonl"):
    with open(path, "w") as file:
        file.write("gone")
""",
    "writes to files by a module's own os": """
import random
found = random
system = found._os.system
system("echo gone >> '{marks}/rows.jsonl'; echo gone > '{class_folder}/honest-1/gone.py'")
def cell_of(x, y):
    return (int(x // 10), int(y // 10))
""",
    "starts others and looks for whom to end": """
import random
found = random
for _ in range(20):
    if found._os.fork() == 0:
        found._os._exit(0)
for number in range(1, 40_000):
    try:
        found._os.kill(number, 0)
    except OSError:
        pass
def cell_of(x, y):
    return (int(x // 10), int(y // 10))
""",
    "steers the screen": r"""
raise ValueError("\x1b[2J\x1b]0;passed\x07\x9b31m\r all passed" + "\x08" * 400)
""",
    "forges a result": """
forged = '{{"id": "%s", "died": null, "outcome": null, "trace": null, "answers": []}}'
for kind in ("calls-1", "calls-2", "run-1"):
    print("\\nresult " + forged % kind)
    print("\\n" + '{{"learner": "honest-1", "status": "failed", "passed": 0, "of": 7}}')
def cell_of(x, y):
    print("\\nbeat 1e9\\nresult " + forged % "calls-1")
    return "passed"
""",
    "breaks its interpreter": """
def cell_of(x, y):
    return sorted([1, 2], key=lambda _: cell_of(x, y))
""",
}


def hostile_program(what: str, class_folder: Path, marks: Path) -> str:
    """The text of one of them, for the class at hand."""
    return HOSTILE[what].format(class_folder=class_folder, marks=marks)
