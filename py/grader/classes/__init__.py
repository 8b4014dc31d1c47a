"""Marks the files of a whole class: python -m grader mark-all FOLDER.

May import: the standard library, `grader`; `distributed` in `machines.py` alone, and there only
when it is asked for.

    submissions.py  which files of a folder are whose and for which task; reads one
    work.py         one submission as work that can be sent to any process or machine, and its row
    sandbox.py      does a job in the locked-down Python under Node
    lanes.py        processes of this machine
    machines.py     machines of a dask cluster
    record.py       what is done already, kept while it is done
    summary.py      totals per task, the commonest mistakes
    table.py        the marks as CSV
    page.py         the marks as one HTML page
    command.py      mark-all itself

None of this goes to the browser.
"""
