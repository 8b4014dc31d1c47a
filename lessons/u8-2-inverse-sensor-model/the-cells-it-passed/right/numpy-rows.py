# style: rows of a NumPy array

import numpy as np

along = np.arange(0, reading - CELL, CELL / 2)
a = math.radians(angle)
cells = np.floor(np.column_stack([x + along * np.sin(a), y + along * np.cos(a)]) / CELL).astype(int)
cells = cells[np.all((cells >= 0) & (cells < ACROSS), axis=1)]
