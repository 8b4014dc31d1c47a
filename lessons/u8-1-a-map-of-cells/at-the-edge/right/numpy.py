# style: NumPy

import numpy as np

cell = np.floor(np.array([x, y]) / CELL).astype(int)
if np.any(cell < 0) or np.any(cell >= ACROSS):
    return None
return np.dot([1, ACROSS], cell)
