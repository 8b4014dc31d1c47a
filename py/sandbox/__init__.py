"""Runs a program that nobody vouches for, as a process shut in by four fences.

May import: the standard library. Everybody who runs such programs may import this: `bugbot.cli` and
`grader`.

    node.py       the page's own Python and its lock-down, under Node with Node's permissions
    walls.py      round it: user, files, processes and network of its own, if the system can
    inside.py     makes those walls, where bubblewrap is not there to do it
    processes.py  ends a process with whatever it has started

The fourth is limits of the system on open files, memory, time and processes; `node.py` sets them
before the process hears of the program.
"""
