# style: the smallest and the largest of a row

cells = np.floor_divide(points, CELL).astype(int)
cells = cells[(cells.min(axis=1) >= 0) & (cells.max(axis=1) < ACROSS)]
