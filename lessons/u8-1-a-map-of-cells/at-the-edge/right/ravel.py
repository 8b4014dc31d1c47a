# style: NumPy's own way to an index, and an exception

import numpy as np

column, row = cell_of(x, y)
try:
    index = np.ravel_multi_index((row, column), (ACROSS, ACROSS))
except ValueError:
    index = None
