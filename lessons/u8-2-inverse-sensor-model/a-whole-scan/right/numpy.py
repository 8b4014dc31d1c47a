# style: NumPy

import numpy as np

x, y = np.add(START, position())
direction = heading()
for beam in np.array(scan()):
    passed, hit = beam_says(x, y, direction + beam[0], beam[1])
    for cell in passed:
        free.add(cell)
    if hit:
        hits.add(hit)
