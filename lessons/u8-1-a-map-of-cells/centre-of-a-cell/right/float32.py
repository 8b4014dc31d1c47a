# style: NumPy's short floats

import numpy as np

x, y = np.float32((column + 0.5) * CELL), np.float32((row + 0.5) * CELL)
