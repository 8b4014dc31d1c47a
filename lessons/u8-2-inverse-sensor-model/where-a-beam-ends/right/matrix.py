# style: a matrix

import numpy as np

a = math.radians(angle)
turn = np.array([[math.cos(a), math.sin(a)], [-math.sin(a), math.cos(a)]])
end_x, end_y = turn @ np.array([0, reading]) + (x, y)
