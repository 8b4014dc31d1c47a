# style: NumPy

import numpy as np

return (np.array([column, row]) + 0.5) * CELL
