"""From a program's text to its trace, and from a trace to its outcome.

May import: everything else in `bugbot`.

    program.py   run_program: the one way a program is run, everywhere
    limits.py    how much a run may use up
    watchdog.py  ends a program that computes for ever (plain CPython only)
    host.py      Python as the program finds it: its clock, its chance, its way out
    console.py   what stands in for the screen and the keyboard
    faults.py    from an exception to a message on the learner's own line
    slips/       the likely causes: which common mistake an error looks like
    outcome.py   the summary of a finished run
"""

from bugbot.run.limits import Limits
from bugbot.run.outcome import outcome_of
from bugbot.run.program import run_program

__all__ = ["Limits", "outcome_of", "run_program"]
