# style: NumPy

import numpy as np

n = max(abs(last[0] - column), abs(last[1] - row))
cells = np.column_stack(
    [np.rint(np.linspace(column, last[0], n + 1)), np.rint(np.linspace(row, last[1], n + 1))]
).astype(int)
