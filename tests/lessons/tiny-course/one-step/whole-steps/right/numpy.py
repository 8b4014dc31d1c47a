# style: NumPy
import numpy as np

return np.int64(np.floor(length / step))
