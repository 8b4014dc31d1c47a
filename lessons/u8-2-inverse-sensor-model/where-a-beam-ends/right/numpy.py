# style: NumPy

import numpy as np

direction = np.radians(angle)
return np.array([x, y]) + reading * np.array([np.sin(direction), np.cos(direction)])
