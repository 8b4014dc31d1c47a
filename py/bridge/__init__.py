"""The only Python that knows it is in a browser: a few functions that the worker calls.

May import: the standard library, `bugbot`, `grader` and Pyodide's own modules. Nobody imports it.
"""
