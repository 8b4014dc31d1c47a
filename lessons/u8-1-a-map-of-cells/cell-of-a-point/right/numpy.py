# style: NumPy

import numpy as np

return np.floor(np.array([x, y]) / CELL).astype(int)
