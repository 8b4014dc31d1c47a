# style: rows of a NumPy array

import numpy as np

free = np.array(cells_along(x, y, angle, FAR if reading >= FAR else reading - CELL))
hit = None if reading >= FAR else cell_of(*end_of_beam(x, y, angle, reading))
hit = hit and np.array(hit)
return free, hit
