"""Does the work that a marking asks for, in the interpreter that belongs to a learner's program.

May import: the standard library, `bugbot`.

Nothing here would tell what is right, and nothing that would is beside it: in a page, in the
locked-down Python under Node and in the processes of plain CPython this interpreter is given
`bugbot` and this package, and neither `grader` nor `mapping`. So a program that gets out of
everything finds no reference, no check and no judge; what it sends back is a claim, and is
held against the truth elsewhere.

    perform.py    does one job: runs the program, calls its functions
    calling.py    calls the learner's functions, inside a run
    constants.py  the program with other constants
    values.py     answers as JSON, by exact type; and as a message shows them
    limits.py     what a job may use up
    refusal.py    reads a program for what it may not use while it is marked, and says so
    fence.py      what that is, and the same while it runs
    serving.py    the performer's process, under plain CPython
"""
