"""Are the checks of a task strict enough? Its solution is changed in the ways of learners.

May import: the standard library, the rest of `grader`. Stays off the site.

    edits.py        a program as text and as a tree; the changes to one piece of it
    operators.py    the changes to operators, numbers, names and calls
    statements.py   the changes to whole statements and their order
    mutants.py      every mutant of a solution, each once
    equivalent.py   equivalent.json: changes that are no mistakes, with the reason
    trying.py       marks a mutant, and stops as soon as it has failed
    study.py        all mutants of tasks, on all cores, with what is known from before
    command.py      python -m grader mutants
"""
