# style: NumPy, with a float as the answer

import numpy as np

count = np.ceil(MAT / side) ** 2
