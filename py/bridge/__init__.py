"""The only Python that knows it is in a browser: a few functions that the worker calls.

May import: the standard library, `bugbot`, `performer` and Pyodide's own modules. `judging`, `ros`
and `map_files` may import `grader` and `mapping`: they are not in the snapshot and come only to
workers that run no learner's program. Nobody imports the bridge.
"""
